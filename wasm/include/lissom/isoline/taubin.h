#pragma once

#include "lissom/mesh/topology.h"

#include <vector>

namespace lissom {

/// One pair of steps of λ|μ smoothing: every vertex half way to the mean of its ring, then 0.53 of the way back, which
/// takes out noise and hardly shrinks. Vertices with `kept` stay.
///
/// Source: Taubin, "A signal processing approach to fair surface design", SIGGRAPH 1995.
/// @param kept  one flag per vertex, or none: all may move
void taubin_step(Points& points, const VertexRings& rings, const std::vector<bool>& kept = {});

/// ∫H² dA over the vertices that are not left out: Σ |L x|² / a. No unit.
/// @param left_out  one flag per vertex, or none: those on a boundary, where L x is no curvature
[[nodiscard]] double bending_energy(const TriangleMesh& mesh, const std::vector<bool>& left_out = {});

/// A third of the area of the triangles around each vertex (unit²), floored at a millionth of the mean. Sums to the surface area
/// but for that floor. Unlike the mixed Voronoi area it needs no angle, so that needles do it no harm.
[[nodiscard]] Eigen::VectorXd ring_areas(const TriangleMesh& mesh);

} // namespace lissom
