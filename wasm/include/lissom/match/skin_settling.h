#pragma once

#include "lissom/match/correspondences.h"
#include "lissom/match/fine_fit.h"
#include "lissom/match/fit_surface.h"
#include "lissom/match/folds.h"

#include <vector>

namespace lissom {

struct SettlingOptions {
    int steps = 16;             ///< 1 to 60
    double first_stiffness = 20, last_stiffness = 0.3; ///< μ of `FineFit`; for points 10 and 3, for noisy ones 30 and 10
    double reach = 0.06;        ///< share of the surface's size: farther places do not count
    double least_cosine = 0.2;  ///< between normals, where the surface's say something
    double reverse = 0.5;       ///< weight of samples of the surface, see `Correspondences`
    int projections = 2;        ///< guarded steps to the nearest place at the end; 0 for points
    bool facing = true;         ///< false: which way the surface's triangles face says nothing
};

/// Brings a first skin from around a model onto it: the fine fit alone, without markers, every step guarded against crossings, turned and folded triangles.
///
/// Limits: what is between two sheets (webs, the rim of a lid over a hole) settles somewhere between; nothing goes into a cavity whose mouth the skin closes.
/// Source: Wang et al. (004), 3.1, pre-skinning. Changed as in `MatchSession`.
/// Cost: a step is a factorization and a guarded step, some 0.2 s for 10,000 vertices, and a slice.
class SkinSettling {
public:
    /// @param surface  kept by reference. Both in one space, of any unit.
    SkinSettling(const TriangleMesh& skin, const FitSurface& surface, const SettlingOptions& options);

    /// One slice. @returns true while there is more. @throws SolverFailure
    bool step(TriangleMesh& skin);
    [[nodiscard]] int slices() const { return options_.steps + options_.projections; }

private:
    void project(TriangleMesh& skin);

    const FitSurface& surface_;
    SettlingOptions options_;
    double size_;
    Correspondences correspondences_;
    FineFit fit_;
    GuardedStep guard_;
    int slice_ = 0;
};

} // namespace lissom
