#pragma once

#include "graph.h"

#include <vector>

namespace lissom::solve {

/// Approximate minimum degree (Eigen's). order[k] is the node eliminated k-th.
[[nodiscard]] std::vector<int> minimum_degree_order(const Graph& graph);

/// Geometric nested dissection: the nodes are cut in two by a plane, the nodes that join the halves come
/// last, and each half is ordered the same way; small pieces by minimum degree.
///
/// Source: George, "Nested dissection of a regular finite element mesh", SIAM J. Numer. Anal. 10(2), 1973.
///         Where to cut, and along which axis, is ours: every parallel plane is tried.
///
/// @param coordinates  n×3; where one is not finite it counts as 0
[[nodiscard]] std::vector<int> nested_dissection_order(const Graph& graph, const Points& coordinates);

} // namespace lissom::solve
