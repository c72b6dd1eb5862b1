#pragma once

#include "lissom/match/fit_surface.h"
#include "lissom/match/pull.h"
#include "lissom/mesh/types.h"

#include <vector>

namespace lissom {

/// `count` places along a polyline, its ends among them, equally far apart along it. @param line  at least two rows
[[nodiscard]] Points places_along_polyline(const Points& line, int count);

/// Markers that are curves: each has the same number of places on every model, equally spread, which correspond.
///
/// What is pulled are places of the skin, not its vertices: these come and go, and would lie beside a curve drawn by hand.
class MarkerCurves {
public:
    /// @param on_source    a polyline per curve, about unit size
    /// @param edge_length  > 0: places are about so far apart
    MarkerCurves(const std::vector<Points>& on_source, const FitSurface& source, double edge_length);

    [[nodiscard]] bool empty() const { return places_.rows() == 0; }
    /// The places that correspond on another model, n×3. @param curves  as many as the source has
    [[nodiscard]] Points on(const std::vector<Points>& curves, const FitSurface& surface) const;
    /// Pulls of weight 1 at the places of the source's skin nearest to the curves. @param targets  where each place belongs
    [[nodiscard]] std::vector<Pull> pulls(const TriangleMesh& source_skin, const Points& targets) const;

private:
    std::vector<int> counts_; ///< of places, per curve
    Points places_;           ///< on the source
};

} // namespace lissom
