#pragma once

#include "lissom/mesh/edge_curves.h"
#include "lissom/mesh/types.h"

#include <vector>

namespace lissom {

struct SharpOptions {
    double angle = 35;      ///< degrees between the normals of an edge's two triangles, above which it is sharp; 0: only what is picked
    double shortest = 0.02; ///< curves shorter than this share of the surface's size (`surface_size`) are noise, see below
    double turn = 60;       ///< degrees; where a curve turns by more, it has a corner
};

/// The sharp edges of a surface, chained into curves between corners: where other than two of them meet, and where they turn. Vertices are those of the mesh.
///
/// Sharp is an edge of two triangles that agree about their sides and whose normals are farther apart than the angle, and one of three or more, where sheets
/// meet. Borders are not: they hold themselves. Picked edges are sharp whatever their angle.
/// Left out are, shortest first, curves shorter than told that end somewhere alone or are closed, and then nets that are shorter in sum; what is short
/// between corners of something larger, as the edges of a chamfer, stays. Picked edges always stay.
///
/// Source: Wang et al. (004), 3.4. Changed: the paper takes edges by H_e = 2 |e| cos(θ/2) above a threshold. H_e grows with the edge: the same crease in
/// half as long edges has half the value, and a model in millimetres a thousand times that of one in metres. Angle and length of the whole curve
/// depend on neither.
///
/// @param picked  chains of vertices, closed where the first stands last again; where two that follow one another share no edge, the shortest way along edges is meant
/// @throws InvalidInput `picked-edges` a vertex that is not there, fewer than two, no way from one to the next; `bad-option`
/// Cost: sorting the edges, and a search over the mesh for each gap in what is picked.
[[nodiscard]] std::vector<EdgeCurve> sharp_curves(const TriangleMesh& mesh, const SharpOptions& options = {}, const std::vector<std::vector<int>>& picked = {});

} // namespace lissom
