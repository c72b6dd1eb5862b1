#include "lissom/mesh/half_edges.h"

#include <algorithm>

namespace lissom {

std::vector<HalfEdge> half_edges(const TriangleMesh& mesh) {
    // A bucket per smaller vertex first: sorting a handful of sides at a time beats sorting all at once.
    std::vector<int> start(mesh.vertex_count() + 1, 0);
    const auto each_side = [&](auto visit) {
        for (int t = 0; t < mesh.triangle_count(); ++t)
            for (int k = 0; k < 3; ++k) {
                const int from = mesh.triangles(t, k), to = mesh.triangles(t, (k + 1) % 3);
                if (from != to)
                    visit(HalfEdge{std::min(from, to), std::max(from, to), t, k, from < to});
            }
    };
    each_side([&](const HalfEdge& side) { ++start[side.a + 1]; });
    for (std::size_t i = 1; i < start.size(); ++i)
        start[i] += start[i - 1];

    std::vector<HalfEdge> sides(start.back());
    std::vector<int> next(start.begin(), start.end() - 1);
    each_side([&](const HalfEdge& side) { sides[next[side.a]++] = side; });
    for (int v = 0; v < mesh.vertex_count(); ++v)
        std::sort(sides.begin() + start[v], sides.begin() + start[v + 1], [](const HalfEdge& p, const HalfEdge& q) {
            return p.b != q.b ? p.b < q.b : 3 * p.triangle + p.corner < 3 * q.triangle + q.corner;
        });
    return sides;
}

} // namespace lissom
