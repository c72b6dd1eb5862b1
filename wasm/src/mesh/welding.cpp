#include "welding.h"

#include "lissom/mesh/topology.h"
#include "lissom/mesh/weld.h"

#include <algorithm>
#include <iterator>
#include <numeric>

namespace lissom {

template <class Unwanted>
std::vector<int> Selection::drop(Unwanted unwanted) {
    std::vector<int> faces;
    int count = 0;
    for (int t = 0; t < triangles.rows(); ++t) {
        const int face = polygon_of_triangle[t];
        if (!unwanted(t)) {
            triangles.row(count) = triangles.row(t).eval();
            polygon_of_triangle[count++] = face;
        } else if (faces.empty() || faces.back() != face) {
            faces.push_back(face);
        }
    }
    triangles.conservativeResize(count, 3);
    polygon_of_triangle.resize(count);
    return faces;
}

std::vector<int> Selection::drop_collapsed() {
    return drop([&](int t) {
        const auto c = triangles.row(t);
        return c[0] == c[1] || c[1] == c[2] || c[2] == c[0];
    });
}

std::vector<int> Selection::drop_repeated() {
    const std::vector<bool> repeated = repeated_triangles(triangles);
    return drop([&](int t) { return repeated[t]; });
}

void Selection::map(const std::vector<int>& vertex) {
    for (int& v : triangles.reshaped())
        v = vertex[v];
}

std::vector<bool> Selection::used(int vertex_count) const {
    std::vector<bool> flags(vertex_count, false);
    for (const int v : triangles.reshaped())
        flags[v] = true;
    return flags;
}

std::vector<int> united(const std::vector<int>& a, const std::vector<int>& b) {
    std::vector<int> both;
    std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both));
    return both;
}

namespace {

/// Vertices that a near twin may stand beside: on a boundary, and with edges long enough that welding within
/// the tolerance can neither fold a triangle nor eat fine detail.
std::vector<int> weldable(const TriangleMesh& mesh, double tolerance) {
    std::vector<bool> on_boundary(mesh.vertex_count(), false), has_short_edge(mesh.vertex_count(), false);
    for (const Edge& e : edges(mesh)) {
        if (e.forward + e.backward == 1)
            on_boundary[e.a] = on_boundary[e.b] = true;
        if ((mesh.points.row(e.a) - mesh.points.row(e.b)).norm() < 4 * tolerance)
            has_short_edge[e.a] = has_short_edge[e.b] = true;
    }
    std::vector<int> found;
    for (int v = 0; v < mesh.vertex_count(); ++v)
        if (on_boundary[v] && !has_short_edge[v])
            found.push_back(v);
    return found;
}

} // namespace

Welding weld(const Points& points, const std::vector<bool>& used, double tolerance, Selection& chosen) {
    Welding done;
    const auto clean = [&] {
        done.collapsed = united(done.collapsed, chosen.drop_collapsed());
        done.repeated = united(done.repeated, chosen.drop_repeated());
    };
    done.leader = exact_twins(points, used);
    for (int v = 0; v < points.rows(); ++v)
        if (done.leader[v] >= 0 && done.leader[v] != v)
            done.exact.push_back(v);
    chosen.map(done.leader);
    clean();

    const std::vector<int> open = weldable({points, chosen.triangles}, tolerance);
    const std::vector<int> joined = near_twins(points, open, tolerance);
    std::vector<int> target(points.rows());
    std::iota(target.begin(), target.end(), 0);
    for (std::size_t i = 0; i < open.size(); ++i)
        if (joined[i] != open[i]) {
            target[open[i]] = joined[i];
            done.near.push_back(open[i]);
        }
    if (done.near.empty())
        return done;
    for (int& v : done.leader)
        v = v < 0 ? v : target[v];
    chosen.map(target);
    clean();
    return done;
}

} // namespace lissom
