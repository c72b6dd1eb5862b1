#pragma once

#include "lissom/mesh/types.h"

#include <array>
#include <vector>

namespace lissom {

/// Where a surface crosses itself.
struct SelfIntersections {
    int pairs = 0;              ///< pairs of triangles without a common vertex that meet
    std::vector<int> triangles; ///< all that belong to one, ascending
};

/// Counts triangles that meet others they share no vertex with; touching counts. Decided by exact predicates: no pair is
/// missed or made up by rounding.
///
/// Triangles with a corner that is not finite, or with two equal indices, meet nothing. Triangles that share a vertex are neighbours by
/// construction and are not looked at; weld a soup before.
/// Cost: a tree of boxes walked against itself, about n log n.
[[nodiscard]] SelfIntersections self_intersections(const TriangleMesh& mesh);

/// Whether two triangles have a point in common; exact.
[[nodiscard]] bool triangles_meet(const std::array<Eigen::Vector3d, 3>& a, const std::array<Eigen::Vector3d, 3>& b);

} // namespace lissom
