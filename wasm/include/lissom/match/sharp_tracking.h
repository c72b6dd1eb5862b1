#pragma once

#include "lissom/match/fit_surface.h"
#include "lissom/match/folds.h"
#include "lissom/match/sharp_paths.h"
#include "lissom/mesh/topology.h"

#include <vector>

namespace lissom {

/// Brings the vertices of paths to their places, what is around goes along, and evens out the strip beside them.
///
/// First `approach` passes, each by an equal part of the way, moves fading over the strip; then `settle` passes in which free vertices of the strip go to the place of the
/// surface nearest to 0.6 of themselves and 0.4 of the mean of their ring. Each pass is guarded against crossings, turned and folded triangles (`GuardedStep`).
/// Neither markers nor borders nor what is beyond the strip ever moves.
/// Source: as above; Criterion 9: tracking places of path vertices are not asked again.
/// Cost: a pass costs a guarded step, about as much as looking for crossings twice: 0.1 s for 30,000 triangles.
class SharpTracking {
public:
    struct Options {
        int approach = 6, settle = 30;
        int strip = 5;             ///< rings of vertices around paths that may move
        double least_cosine = 0.3; ///< between the normals of skin and surface
        double reach = 0.1;        ///< in the unit of the surface: farther places do not count
    };

    /// @param surface  kept by reference. @param held  path vertices and their places. @param locked  one flag per vertex: never moves unless it is held
    SharpTracking(const TriangleMesh& skin, const FitSurface& surface, const std::vector<Anchor>& held, const std::vector<char>& locked, const Options& options);

    /// One pass. @returns true while there is more
    bool step(TriangleMesh& skin);
    [[nodiscard]] int passes() const { return options_.approach + options_.settle; }
    [[nodiscard]] int done() const { return pass_; }

    /// The farthest that a held vertex is from its place: more than nothing where the guard would not let it through.
    [[nodiscard]] double farthest(const Points& skin) const;

private:
    void approach(const Points& points, Points& moves) const;
    void settle(const TriangleMesh& skin, Points& moves) const;

    const FitSurface& surface_;
    std::vector<Anchor> held_;
    Options options_;
    VertexRings rings_;
    std::vector<int> strip_; ///< free vertices that may move
    GuardedStep guard_;
    int pass_ = 0;
};

} // namespace lissom
