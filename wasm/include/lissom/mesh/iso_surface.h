#pragma once

#include "lissom/mesh/grid.h"
#include "lissom/mesh/types.h"

#include <vector>

namespace lissom {

/// The surface between nodes of a grid with negative and with positive values, facing the positive ones: closed and manifold wherever no negative node lies
/// on the grid's border.
///
/// Each cell is six tetrahedra around its diagonal, cut where values change sign along their edges, at most to a fiftieth of the edge's ends; so no two cells disagree
/// and no triangle is without area. Zero counts as negative.
/// Source: Doi and Koide (1991); the cases follow from one: a corner cut off (i; j, k, l), or two from two (i, j; k, l), for even permutations.
/// Cost: linear in the grid.
[[nodiscard]] TriangleMesh iso_surface(const Grid& grid, const std::vector<float>& values);

} // namespace lissom
