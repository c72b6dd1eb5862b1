#pragma once

#include "lissom/merge/merged_model.h"
#include "lissom/merge/optimal_boundary.h"
#include "lissom/merge/seam.h"
#include "lissom/mesh/working_mesh.h"

#include <Eigen/Geometry>

#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace lissom {

enum class MergeMode {
    independent, ///< Fu 3.3.1: where the source stands, how it is turned and how large it is do not matter
    dependent    ///< Fu 3.3.2: the source stands as placed; handles stay, only the boundary is fitted
};

/// One pair of boundaries to be joined. All vertices are those of the files.
struct MergeBoundary {
    BoundaryLoop source, target;
};

/// Source vertices held in place (dependent merging).
struct MergeHandle {
    std::vector<int> vertices;
    Eigen::Affine3d map = Eigen::Affine3d::Identity(); ///< from the placed source, in the target's space
};

/// Overlapped transition regions (Fu 3.3.3): the source's boundary is carried to the far edge of the target's region, and
/// between there and the far edge of the source's region the details change from one to the other.
struct Transition {
    double source_width = 0; ///< > 0, along the source's surface, in its unit
    double target_width = 0; ///< > 0, along the target's, in its unit: this much of it gives way
    double weight = 0.1;     ///< w_T of E_T
};

struct MergeOptions {
    MergeMode mode = MergeMode::independent;
    int smoothing = 0;       ///< umbrella iterations at the seam; they move the target's seam vertices too
    int coherence_ring = 1;  ///< see DeformOptions
    std::optional<Transition> transition{};
    Eigen::Affine3d placement = Eigen::Affine3d::Identity(); ///< of the source in the target's space; read by `dependent`
};

/// Painted regions for optimal boundary merging (Fu 3.4), in file vertices.
struct PaintedRegions {
    std::vector<int> source_region, feature, target_region;
    std::optional<Placement> placement; ///< none: `best_placement`
    int rounds = 50;                    ///< 0: the region's own edge is the boundary
};

/// (source vertex, target vertex) pairs of one pair of boundaries, in file vertices.
using MergeKeys = std::vector<std::pair<int, int>>;

struct MergeResult {
    MergedModel model;
    SeamFigures seam;
    bool source_turned = false;      ///< its faces were turned over to face as the target's do
    std::vector<MergeKeys> keys;     ///< the keys used, found ones included
    std::vector<Finding> warnings;   ///< `source-turned`, `key-found`
    double solve_seconds = 0, stitch_seconds = 0;
};

/// Poisson merging: the source is deformed so that its boundaries meet the target's, and both are stitched together.
/// The target is never deformed.
///
/// Each vertex of a source boundary gets a position on the target's and a gradient R_i s_i; Eq 2.8 and 2.11 do the rest.
/// Before that the source is brought into a pose that only its own shape decides, so that the result depends on
/// its position, turn and size not even by rounding's choices.
///
/// Source: Fu, thesis ch. 3.3 (000); Fu et al., Computer Graphics Forum 26(1), 2007, section 5 (002).
/// Cost:   preparing factors two matrices once per set of boundaries; `merge` is two solves and the seam.
class MergeSession {
public:
    /// @param source,target  kept by reference: must outlive the session
    /// @param roi      source vertices that may move (dependent only); empty: all
    /// @throws InvalidInput `no-boundary`, what `cut_part` says, `handle-overlap`, `vertex-out-of-range`,
    ///         `boundary-too-small` (half of a loop's edges below a millionth of its model), `placed-too-far` (dependent:
    ///         below 1e-10 of the distance from the target)
    MergeSession(const WorkingMesh& source, const WorkingMesh& target, std::span<const MergeBoundary> boundaries, MergeOptions options = {},
                 std::span<const int> roi = {}, std::span<const MergeHandle> handles = {});
    /// Merges the feature along the boundary that changes least; then `merge` takes no keys (one empty list).
    /// @throws InvalidInput what `map_regions`, `optimal_boundary`, `open_target` and `cut_part` say, `boundary-too-small`
    MergeSession(const WorkingMesh& source, const WorkingMesh& target, const PaintedRegions& regions, MergeOptions options = {});
    ~MergeSession();
    MergeSession(MergeSession&&) noexcept;

    /// One slice of the factorizations. @returns true while there is more. @throws SolverFailure
    bool step();
    [[nodiscard]] double fraction() const;

    /// @param keys    for each pair of boundaries; none: the best single one is found
    /// @param settle  false: the first solve only
    /// @throws InvalidInput `boundary-count`, what `match_loops` says
    /// @throws SolverFailure
    [[nodiscard]] MergeResult merge(std::span<const MergeKeys> keys, bool settle = true) const;

    [[nodiscard]] const std::vector<double>& energies() const; ///< of the boundary, round by round; empty where it was given
    [[nodiscard]] const std::optional<Placement>& placement() const; ///< the one used
    [[nodiscard]] int free_vertices() const;
    [[nodiscard]] int degenerate_vertices() const;
    [[nodiscard]] double prepare_seconds() const; ///< cutting, refining, assembling
    [[nodiscard]] double factor_seconds() const;
    [[nodiscard]] double memory_bytes() const;
    [[nodiscard]] const std::vector<Finding>& warnings() const; ///< `boundary-refined`, `factor-shifted`, …

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace lissom
