#pragma once

#include "lissom/mesh/types.h"

#include <vector>

namespace lissom {

/// How long edges should be at each vertex of a surface so that triangles are small where it bends and large where it is flat.
///
/// A triangle of edge h on a surface of curvature κ is off by about κ h² / 8: equal error everywhere means h ∝ κ^(−1/2). That, to the power `adapt`, between 0.4 and 2.5 times
/// `length`; then no steeper than `k_grading` along the surface, and all scaled so that as many triangles are needed as with `length` everywhere (within these bounds).
/// κ is the largest change of the vertex normals along the edges at a vertex, evened out over its ring.
///
/// @param adapt    0: `length` everywhere, to 1
/// @param creases  one flag per vertex: no curvature is asked there, it takes that of its neighbours; or none
/// Cost: linear but for a queue.
[[nodiscard]] std::vector<double> edge_lengths(const TriangleMesh& mesh, double length, double adapt, const std::vector<char>& creases = {});

/// By how much lengths may differ, as a share of the way between.
constexpr double k_grading = 0.4;

} // namespace lissom
