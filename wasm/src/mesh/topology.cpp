#include "lissom/mesh/topology.h"

#include "lissom/mesh/disjoint_sets.h"
#include "lissom/mesh/half_edges.h"

#include <algorithm>

namespace lissom {

VertexRings vertex_rings(const TriangleMesh& mesh) {
    const int n = mesh.vertex_count();
    // Row by row the other two corners of every triangle, most of them twice; then each row sorted, and told once.
    const auto each_side = [&](auto visit) {
        for (int t = 0; t < mesh.triangle_count(); ++t)
            for (int k = 0; k < 3; ++k) {
                const int from = mesh.triangles(t, k), to = mesh.triangles(t, (k + 1) % 3);
                if (from != to) visit(from, to);
            }
    };
    std::vector<int> start(n + 1, 0);
    each_side([&](int from, int to) {
        ++start[from + 1];
        ++start[to + 1];
    });
    for (int v = 0; v < n; ++v) start[v + 1] += start[v];
    VertexRings rings;
    std::vector<int>& row = rings.neighbours;
    row.resize(start.back());
    std::vector<int> next(start.begin(), start.end() - 1);
    each_side([&](int from, int to) {
        row[next[from]++] = to;
        row[next[to]++] = from;
    });
    rings.offsets.reserve(n + 1);
    rings.offsets.push_back(0);
    std::size_t end = 0; // rows only become shorter, so that none is written over before it is read
    for (int v = 0; v < n; ++v) {
        std::sort(row.begin() + start[v], row.begin() + start[v + 1]);
        int before = -1;
        for (int k = start[v]; k < start[v + 1]; ++k)
            if (row[k] != before) row[end++] = before = row[k];
        rings.offsets.push_back(static_cast<int>(end));
    }
    row.resize(end);
    row.shrink_to_fit();
    return rings;
}

std::vector<Edge> edges(const TriangleMesh& mesh) {
    const std::vector<HalfEdge> sides = half_edges(mesh);
    std::vector<Edge> all;
    all.reserve(sides.size() / 2);
    for_each_edge(sides, [&](auto first, auto last) {
        const int forward = static_cast<int>(std::count_if(first, last, [](const HalfEdge& s) { return s.forward; }));
        all.push_back({first->a, first->b, forward, static_cast<int>(last - first) - forward});
    });
    return all;
}

Components components(const VertexRings& rings) {
    Components found;
    found.of_vertex.assign(rings.vertex_count(), -1);
    std::vector<int> stack;
    for (int seed = 0; seed < rings.vertex_count(); ++seed) {
        if (found.of_vertex[seed] >= 0)
            continue;
        found.of_vertex[seed] = found.count;
        stack.push_back(seed);
        while (!stack.empty()) {
            const int v = stack.back();
            stack.pop_back();
            for (const int w : rings[v])
                if (found.of_vertex[w] < 0) {
                    found.of_vertex[w] = found.count;
                    stack.push_back(w);
                }
        }
        ++found.count;
    }
    return found;
}

namespace {

/// Edges of one triangle as a graph that is walked along, each edge once.
class BorderGraph {
public:
    explicit BorderGraph(const TriangleMesh& mesh) : start_(mesh.vertex_count() + 1, 0) {
        for (const Edge& e : edges(mesh))
            if (e.forward + e.backward == 1)
                ends_.push_back({e.forward ? e.a : e.b, e.forward ? e.b : e.a});
        for (const auto& [from, to] : ends_) {
            ++start_[from + 1];
            ++start_[to + 1];
        }
        for (std::size_t i = 1; i < start_.size(); ++i)
            start_[i] += start_[i - 1];
        // Edges that leave a vertex stand before those that arrive: `take` prefers the triangles' direction.
        incident_.resize(start_.back());
        std::vector<int> next(start_.begin(), start_.end() - 1);
        for (int e = 0; e < edge_count(); ++e)
            incident_[next[ends_[e].first]++] = e;
        for (int e = 0; e < edge_count(); ++e)
            incident_[next[ends_[e].second]++] = e;
        used_.assign(ends_.size(), false);
        next_.assign(start_.begin(), start_.end() - 1);
    }

    [[nodiscard]] int edge_count() const { return static_cast<int>(ends_.size()); }

    /// The far end of an edge at v not walked yet, which now counts as walked; −1: none is left.
    int take(int v) {
        for (int& i = next_[v]; i < start_[v + 1]; ++i)
            if (const int e = incident_[i]; !used_[e]) {
                used_[e] = true;
                return ends_[e].first == v ? ends_[e].second : ends_[e].first;
            }
        return -1;
    }

private:
    std::vector<std::pair<int, int>> ends_;
    std::vector<int> start_, incident_, next_;
    std::vector<bool> used_;
};

} // namespace

std::vector<std::vector<int>> boundary_loops(const TriangleMesh& mesh) {
    BorderGraph border(mesh);
    std::vector<std::vector<int>> loops;
    std::vector<int> place(mesh.vertex_count(), -1); // where a vertex stands in the walk
    std::vector<int> walk;
    for (int seed = 0; seed < mesh.vertex_count(); ++seed) {
        for (int v = seed; v >= 0;) {
            if (place[v] >= 0) { // came round: cut the loop off, which also parts loops that touch here
                std::vector<int> loop(walk.begin() + place[v], walk.end());
                for (const int w : loop)
                    place[w] = -1;
                walk.resize(walk.size() - loop.size());
                std::rotate(loop.begin(), std::min_element(loop.begin(), loop.end()), loop.end());
                loops.push_back(std::move(loop));
            }
            place[v] = static_cast<int>(walk.size());
            walk.push_back(v);
            v = border.take(v);
        }
        for (const int w : walk) // the seed, or a chain that ran into a non-manifold edge and closes nowhere
            place[w] = -1;
        walk.clear();
    }
    std::sort(loops.begin(), loops.end());
    return loops;
}

std::vector<bool> boundary_vertices(const TriangleMesh& mesh) {
    std::vector<bool> on_boundary(mesh.vertex_count(), false);
    for (const Edge& e : edges(mesh))
        if (e.forward + e.backward == 1)
            on_boundary[e.a] = on_boundary[e.b] = true;
    return on_boundary;
}

int euler_characteristic(const TriangleMesh& mesh) {
    std::vector<bool> used(mesh.vertex_count(), false);
    for (int t = 0; t < mesh.triangle_count(); ++t)
        for (int k = 0; k < 3; ++k)
            used[mesh.triangles(t, k)] = true;
    const auto vertices = static_cast<int>(std::count(used.begin(), used.end(), true));
    return vertices - static_cast<int>(edges(mesh).size()) + mesh.triangle_count();
}

std::vector<int> non_manifold_vertices(const TriangleMesh& mesh) {
    // Corners at a vertex belong to one fan when a chain of shared edges joins their triangles.
    DisjointSets fans(3 * mesh.triangle_count());
    const auto corner_at = [&](const HalfEdge& s, int v) {
        return 3 * s.triangle + (mesh.triangles(s.triangle, s.corner) == v ? s.corner : (s.corner + 1) % 3);
    };
    const std::vector<HalfEdge> sides = half_edges(mesh);
    for_each_edge(sides, [&](auto first, auto last) {
        for (auto side = first + 1; side != last; ++side)
            for (const int v : {first->a, first->b})
                fans.join(corner_at(*first, v), corner_at(*side, v));
    });
    std::vector<int> fan(mesh.vertex_count(), -1);
    std::vector<bool> split(mesh.vertex_count(), false);
    for (int c = 0; c < 3 * mesh.triangle_count(); ++c) {
        const int v = mesh.triangles(c / 3, c % 3), root = fans.find(c);
        if (fan[v] < 0)
            fan[v] = root;
        else if (fan[v] != root)
            split[v] = true;
    }
    std::vector<int> found;
    for (int v = 0; v < mesh.vertex_count(); ++v)
        if (split[v])
            found.push_back(v);
    return found;
}

} // namespace lissom
