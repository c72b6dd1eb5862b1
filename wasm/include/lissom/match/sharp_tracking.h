#pragma once

#include "lissom/match/fit_surface.h"
#include "lissom/match/folds.h"
#include "lissom/match/sharp_paths.h"
#include "lissom/mesh/topology.h"

#include <vector>

namespace lissom {

/// Brings the vertices of paths to their places, what is around goes along, and evens out the strip beside them.
///
/// First `approach` passes, each by an equal part of the way, moves fading over the strip; then `settle` sweeps in which free vertices of the strip go to the place of the
/// surface nearest to 0.6 of themselves and 0.4 of the mean of their ring, unless a triangle of theirs would turn. Each of the first passes, and every five
/// sweeps together, are guarded against crossings, turned and folded triangles (`GuardedStep`).
/// Neither markers nor borders nor what is beyond the strip ever moves.
/// Source: Wang et al. (004), 3.4; Criterion 9: tracking places of path vertices are not asked again.
/// Cost: a slice is a guarded step, which looks for crossings at least once in the whole skin, or a search per vertex of the strip: 0.15 to 0.3 s for 35,000 triangles.
class SharpTracking {
public:
    struct Options {
        int approach = 6, settle = 30; ///< passes, sweeps
        int strip = 5;             ///< rings of vertices around paths that may move
        double least_cosine = 0.3; ///< between the normals of skin and surface
        double reach = 0.1;        ///< in the unit of the surface: farther places do not count
    };

    /// @param surface  kept by reference. @param held  path vertices and their places. @param locked  one flag per vertex: never moves unless it is held
    SharpTracking(const TriangleMesh& skin, const FitSurface& surface, const std::vector<Anchor>& held, const std::vector<char>& locked, const Options& options);

    /// One slice; the skin moves in those that end with a guarded step. @returns true while there is more
    bool step(TriangleMesh& skin);
    [[nodiscard]] int slices() const;
    [[nodiscard]] int done() const { return slice_; }

    /// The farthest that a held vertex is from its place: more than nothing where the guard would not let it through.
    [[nodiscard]] double farthest(const Points& skin) const;

private:
    void approach(const Points& points, Points& moves) const;
    void settle();
    [[nodiscard]] bool turns(int v, const Eigen::RowVector3d& place) const;

    const FitSurface& surface_;
    std::vector<Anchor> held_;
    Options options_;
    VertexRings rings_;
    std::vector<int> strip_; ///< free vertices that may move
    GuardedStep guard_;
    std::vector<std::vector<int>> around_; ///< triangles at each vertex of the strip
    TriangleMesh settled_; ///< where sweeps have brought the skin since the last guarded step
    std::vector<int> hints_; ///< triangle of the surface found last, per vertex
    int slice_ = 0;
};

} // namespace lissom
