#pragma once

#include "lissom/deform/deform_session.h"
#include "lissom/merge/boundary_correspondence.h"
#include "lissom/merge/merge_session.h"
#include "lissom/merge/transition.h"

#include <optional>
#include <string>

namespace lissom {

/// File vertices that the user named one by one, as working vertices.
/// @throws InvalidInput `vertex-out-of-range`, `vertex-unused`
[[nodiscard]] std::vector<int> named_vertices(const std::vector<int>& vertices, const WorkingMesh& working, const std::string& name);

/// File vertices that the user painted, as working vertices: those that no face uses are left out.
/// @throws InvalidInput `vertex-out-of-range`
[[nodiscard]] std::vector<int> painted_vertices(std::span<const int> vertices, const WorkingMesh& working, const std::string& name);

/// What a session knows between merges.
struct MergeSession::State {
    const WorkingMesh& source;
    const WorkingMesh& target;
    MergeOptions options;
    Part source_part{}, target_part{};
    std::vector<int> source_place{}, target_place{}; ///< part vertex of each working vertex; −1: cut off
    Points source_normals{}, target_normals{};
    bool looks_turned = false; ///< source and target face opposite ways, as far as their volumes tell
    std::unique_ptr<WorkingMesh> posed{}; ///< the source part, in the pose that is solved in
    std::optional<DeformSession> deform{};
    std::vector<MergeHandle> fixed{};
    std::vector<int> loose{}; ///< part vertices of pieces that nothing holds
    std::vector<Strip> source_strips{}, target_strips{}; ///< of each loop, where there are transitions
    std::vector<std::pair<int, int>> blended{};          ///< loop and strip vertex of each blended vertex
    Points target_curvature{};                           ///< per target working vertex, the curvature normal
    std::vector<Finding> warnings{};
    double prepare_seconds = 0;
    std::vector<double> energies{};
    std::optional<Placement> placement{};
    bool is_matched = false; ///< the loops' vertices are partners one by one, in order from the first

    void cut(std::span<const MergeBoundary> boundaries);
    void find_boundary(const PaintedRegions& regions);
    void cut_transitions();
    /// @throws InvalidInput `boundary-too-small`
    void check_sizes() const;
    /// @throws InvalidInput `placed-too-far`
    void check_placed() const;
    void refine();
    void prepare(std::span<const int> roi, std::span<const MergeHandle> handles);
    [[nodiscard]] std::vector<LoopMatch> match(std::span<const MergeKeys> keys, bool turned, std::vector<MergeKeys>& used, std::vector<Finding>& found) const;
    [[nodiscard]] LoopMatch match_beyond_strip(std::size_t k, const std::vector<int>& loop, MergeKeys& keys) const;
    [[nodiscard]] Points details(std::span<const MergeKeys> keys, bool turned, double scale) const;
    [[nodiscard]] Points deform_source(const std::vector<LoopMatch>& matches, std::span<const MergeKeys> keys, bool turned, bool settle, double& seconds) const;
};

} // namespace lissom
