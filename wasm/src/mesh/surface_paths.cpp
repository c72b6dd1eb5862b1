#include "lissom/mesh/surface_paths.h"

#include "lissom/mesh/half_edges.h"
#include "lissom/mesh/topology.h"

#include <algorithm>
#include <map>
#include <queue>
#include <set>
#include <utility>

namespace lissom {

WeightedGraph edge_graph(const TriangleMesh& mesh) {
    const VertexRings rings = vertex_rings(mesh);
    WeightedGraph graph{rings.offsets, rings.neighbours, {}};
    for (int v = 0; v < rings.vertex_count(); ++v)
        for (const int w : rings[v]) graph.lengths.push_back((mesh.points.row(v) - mesh.points.row(w)).norm());
    return graph;
}

std::vector<int> ShortestPaths::path_to(int v) const {
    std::vector<int> path;
    for (; v >= 0; v = before[v]) path.push_back(v);
    std::reverse(path.begin(), path.end());
    return path;
}

ShortestPaths shortest_paths(const WeightedGraph& graph, std::span<const int> starts, double limit) {
    constexpr double far = std::numeric_limits<double>::infinity();
    ShortestPaths found{std::vector<double>(static_cast<std::size_t>(graph.size()), far), std::vector<int>(static_cast<std::size_t>(graph.size()), -1)};
    using Entry = std::pair<double, int>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    for (const int v : starts) {
        found.distance[v] = 0;
        open.emplace(0.0, v);
    }
    while (!open.empty()) {
        const auto [distance, v] = open.top();
        open.pop();
        if (distance > found.distance[v] || distance > limit) continue;
        for (int e = graph.offsets[v]; e < graph.offsets[v + 1]; ++e) {
            const int w = graph.ends[e];
            const double there = distance + graph.lengths[e];
            if (there < found.distance[w]) {
                found.distance[w] = there;
                found.before[w] = v;
                open.emplace(there, w);
            }
        }
    }
    return found;
}

SlitRing slit_ring(const TriangleMesh& ring, const std::vector<int>& path) {
    SlitRing slit{ring, {}, path, path};
    const int n = ring.vertex_count();
    std::vector<int> place(static_cast<std::size_t>(n), -1);
    for (std::size_t k = 0; k < path.size(); ++k) place[path[k]] = static_cast<int>(k);
    for (int v = 0; v < n; ++v) slit.original.push_back(v);
    slit.mesh.points.conservativeResize(n + std::ssize(path), 3);
    for (std::size_t k = 0; k < path.size(); ++k) {
        slit.right[k] = n + static_cast<int>(k);
        slit.original.push_back(path[k]);
        slit.mesh.points.row(slit.right[k]) = ring.points.row(path[k]);
    }
    // Triangles at the path belong to a side by the path edges they lie on; the others around a path vertex by their
    // neighbours across edges that are not of the path.
    const auto is_path_edge = [&](int a, int b) { return place[a] >= 0 && place[b] >= 0 && std::abs(place[a] - place[b]) == 1; };
    std::vector<char> side(static_cast<std::size_t>(ring.triangle_count()), 0); // 1 left, 2 right
    std::map<std::pair<int, int>, std::vector<int>> fans; // (path vertex, other vertex) → triangles there
    std::vector<int> front;
    for (int t = 0; t < ring.triangle_count(); ++t)
        for (int c = 0; c < 3; ++c) {
            const int a = ring.triangles(t, c), b = ring.triangles(t, (c + 1) % 3);
            if (place[a] < 0 && place[b] < 0) continue;
            if (is_path_edge(a, b)) {
                side[t] = place[b] > place[a] ? 1 : 2; // a triangle that runs along the path lies to its left
                front.push_back(t);
            } else {
                fans[std::minmax(a, b)].push_back(t);
            }
        }
    while (!front.empty()) {
        const int t = front.back();
        front.pop_back();
        for (int c = 0; c < 3; ++c) {
            const int a = ring.triangles(t, c), b = ring.triangles(t, (c + 1) % 3);
            if ((place[a] < 0 && place[b] < 0) || is_path_edge(a, b)) continue;
            for (const int u : fans[std::minmax(a, b)])
                if (side[u] == 0) {
                    side[u] = side[t];
                    front.push_back(u);
                }
        }
    }
    for (int t = 0; t < ring.triangle_count(); ++t)
        if (side[t] == 2)
            for (int c = 0; c < 3; ++c)
                if (const int k = place[ring.triangles(t, c)]; k >= 0) slit.mesh.triangles(t, c) = slit.right[k];
    return slit;
}

std::vector<int> path_across(const TriangleMesh& ring, const std::vector<int>& border, const std::vector<int>& other, int from) {
    // Leaving the first border and reaching the second are one-way: no way leads along a border.
    WeightedGraph graph = edge_graph(ring);
    const std::set<int> first(border.begin(), border.end()), second(other.begin(), other.end());
    constexpr double closed = std::numeric_limits<double>::infinity();
    for (int v = 0; v < graph.size(); ++v)
        for (int e = graph.offsets[v]; e < graph.offsets[v + 1]; ++e)
            if (first.contains(graph.ends[e]) || second.contains(v)) graph.lengths[e] = closed;
    const std::vector<int> starts = from >= 0 ? std::vector<int>{from} : border;
    const ShortestPaths found = shortest_paths(graph, starts);
    int best = -1;
    for (const int v : second)
        if (found.distance[v] < closed && (best < 0 || found.distance[v] < found.distance[best] * (1 - 1e-9))) best = v;
    return best < 0 ? std::vector<int>{} : found.path_to(best);
}

} // namespace lissom
