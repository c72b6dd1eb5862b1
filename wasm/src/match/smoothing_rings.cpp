#include "lissom/match/smoothing_rings.h"

#include <vector>

namespace lissom {

VertexRings smoothing_rings(const TriangleMesh& mesh) {
    const std::vector<Edge> all = edges(mesh);
    std::vector<char> border(static_cast<std::size_t>(mesh.vertex_count()), 0);
    for (const Edge& e : all)
        if (e.forward + e.backward == 1) border[e.a] = border[e.b] = 1;
    const auto smooths = [&](const Edge& e, int v) { return !border[v] || e.forward + e.backward == 1; };
    VertexRings rings;
    rings.offsets.assign(static_cast<std::size_t>(mesh.vertex_count()) + 1, 0);
    for (const Edge& e : all)
        for (const int v : {e.a, e.b}) rings.offsets[v + 1] += smooths(e, v);
    for (int v = 0; v < mesh.vertex_count(); ++v) rings.offsets[v + 1] += rings.offsets[v];
    rings.neighbours.resize(static_cast<std::size_t>(rings.offsets.back()));
    // Edges come ordered by (a, b): smaller neighbours first keeps rows ascending.
    std::vector<int> next(rings.offsets.begin(), rings.offsets.end() - 1);
    for (const Edge& e : all)
        if (smooths(e, e.b)) rings.neighbours[next[e.b]++] = e.a;
    for (const Edge& e : all)
        if (smooths(e, e.a)) rings.neighbours[next[e.a]++] = e.b;
    return rings;
}

Eigen::RowVector3d ring_mean(const Points& points, const VertexRings& rings, int v) {
    if (rings[v].empty()) return points.row(v);
    Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
    for (const int w : rings[v]) sum += points.row(w);
    return sum / static_cast<double>(rings[v].size());
}

} // namespace lissom
