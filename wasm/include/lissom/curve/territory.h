#pragma once

#include "lissom/curve/encoding.h"
#include "lissom/mesh/topology.h"
#include "lissom/mesh/types.h"

#include <cstdint>
#include <span>
#include <vector>

namespace lissom {

/// Where a vertex lies with regard to one curve.
enum class CurveSide : std::uint8_t { none, inside, start, end, between };

/// One curve's view of all vertices.
struct CurveField {
    std::vector<CurveSide> side;
    std::vector<float> row;      ///< place along the curve; only of vertices that were looked at
    std::vector<float> distance; ///< to the curve, infinity where not looked at
};

/// What a region leaves of a surface, by where it touches the region: pieces of the rest whose contact lies in the first half of the rows are
/// `start`, in the second `end`, with both ends `between`; pieces that touch nothing are `none`.
/// @param row  of vertices inside
void sort_remainder(const VertexRings& rings, CurveField& field);

/// Share of the end, 1 − that of the start, for vertices between both: smoothstep(g₀/(g₀ + g₁)) with g₀ and g₁ the ways along edges to the region
/// at either end. One per vertex, 0 elsewhere.
[[nodiscard]] std::vector<double> between_shares(const TriangleMesh& mesh, const CurveField& field);

/// Evens rows out where the nearest point jumps (beyond the centre of a bend): Laplacian sweeps around every edge along which the place moves
/// 2.5 times as far as the vertex. Elsewhere rows stay bit for bit, as do those at the ends.
/// @param step    length along the curve from row to row, unit of the points
/// @param radius  of the limb: (r/e)²/4 sweeps for edges e long, at most 40
void smooth_rows(const TriangleMesh& mesh, const VertexRings& rings, CurveField& field, double step, double radius);

} // namespace lissom
