#pragma once

#include "lissom/mesh/types.h"

#include <vector>

namespace lissom {

/// One side of one triangle.
struct HalfEdge {
    int a, b;     ///< its vertices, a < b
    int triangle; ///< whose side it is
    int corner;   ///< 0, 1 or 2: the side runs from this corner to the next one
    bool forward; ///< the triangle runs a → b
};

/// Every side of every triangle, ordered by (a, b, triangle), so that the sides sharing an edge stand together:
/// walks over edges need no manifold mesh. Sides that join a vertex to itself are left out.
/// Cost: linear but for sorting the sides of one vertex.
[[nodiscard]] std::vector<HalfEdge> half_edges(const TriangleMesh& mesh);

/// Calls `visit(first, last)` for each undirected edge with the range of its sides.
template <class Visit>
void for_each_edge(const std::vector<HalfEdge>& sides, Visit visit) {
    for (auto first = sides.begin(); first != sides.end();) {
        auto last = first + 1;
        while (last != sides.end() && last->a == first->a && last->b == first->b)
            ++last;
        visit(first, last);
        first = last;
    }
}

} // namespace lissom
