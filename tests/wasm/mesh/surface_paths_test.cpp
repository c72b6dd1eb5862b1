#include "lissom/mesh/surface_paths.h"

#include "lissom/mesh/operators.h"
#include "lissom/mesh/topology.h"
#include "shapes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>

using namespace lissom;

namespace {

constexpr double k_far = std::numeric_limits<double>::infinity();

/// All distances by Floyd and Warshall: no queue, no order.
Eigen::MatrixXd all_distances(const WeightedGraph& graph) {
    Eigen::MatrixXd D = Eigen::MatrixXd::Constant(graph.size(), graph.size(), k_far);
    for (int v = 0; v < graph.size(); ++v) {
        D(v, v) = 0;
        for (int e = graph.offsets[v]; e < graph.offsets[v + 1]; ++e) D(v, graph.ends[e]) = graph.lengths[e];
    }
    for (int k = 0; k < graph.size(); ++k)
        for (int i = 0; i < graph.size(); ++i)
            for (int j = 0; j < graph.size(); ++j) D(i, j) = std::min(D(i, j), D(i, k) + D(k, j));
    return D;
}

} // namespace

TEST_CASE("the graph of a mesh has each edge both ways, at its length") {
    const TriangleMesh mesh = shapes::bumpy_sphere(1);
    const WeightedGraph graph = edge_graph(mesh);
    CHECK(graph.size() == mesh.vertex_count());
    CHECK(graph.ends.size() == 2 * edges(mesh).size());
    for (int v = 0; v < graph.size(); ++v)
        for (int e = graph.offsets[v]; e < graph.offsets[v + 1]; ++e)
            CHECK(graph.lengths[e] == (mesh.points.row(v) - mesh.points.row(graph.ends[e])).norm());
}

TEST_CASE("distances are those of trying every way, from one start and from several") {
    const TriangleMesh mesh = shapes::joined({shapes::bumpy_sheet(6, 5), shapes::bumpy_sphere(1)}); // two pieces
    const WeightedGraph graph = edge_graph(mesh);
    const Eigen::MatrixXd D = all_distances(graph);
    for (const std::vector<int>& starts : {std::vector<int>{0}, {17}, {3, 40, 20}, {5, 50}}) {
        const ShortestPaths found = shortest_paths(graph, starts);
        for (int v = 0; v < graph.size(); ++v) {
            double least = k_far;
            for (const int s : starts) least = std::min(least, D(s, v));
            if (least == k_far) {
                CHECK(found.distance[v] == k_far);
                CHECK(found.before[v] == -1);
                continue;
            }
            CHECK(found.distance[v] == doctest::Approx(least));
            const std::vector<int> path = found.path_to(v);
            CHECK(std::count(starts.begin(), starts.end(), path.front()) == 1);
            CHECK(path.back() == v);
            double length = 0;
            for (std::size_t k = 1; k < path.size(); ++k) length += (mesh.points.row(path[k]) - mesh.points.row(path[k - 1])).norm();
            CHECK(length == doctest::Approx(found.distance[v]));
        }
    }
}

TEST_CASE("a limit changes nothing within it, and an edge of infinite length is no way") {
    const TriangleMesh mesh = shapes::bumpy_sheet(8, 8);
    WeightedGraph graph = edge_graph(mesh);
    const std::vector<int> start{40};
    const ShortestPaths all = shortest_paths(graph, start), near = shortest_paths(graph, start, 0.3);
    for (int v = 0; v < graph.size(); ++v) {
        if (all.distance[v] <= 0.3) CHECK(near.distance[v] == all.distance[v]);
        else CHECK(near.distance[v] > 0.3);
    }
    for (int e = graph.offsets[40]; e < graph.offsets[41]; ++e) graph.lengths[e] = k_far;
    const ShortestPaths shut = shortest_paths(graph, start);
    CHECK(std::count(shut.distance.begin(), shut.distance.end(), k_far) == graph.size() - 1);
}

TEST_CASE("the way across a ring touches both borders with its ends only, and takes the shortest") {
    const int rows = 8, around = 20;
    const TriangleMesh ring = shapes::flat_ring(rows, around);
    std::vector<int> inner, outer;
    for (int j = 0; j < around; ++j) {
        inner.push_back(j);
        outer.push_back((rows - 1) * around + j);
    }
    for (const int from : {-1, outer[7]}) {
        const std::vector<int> path = path_across(ring, outer, inner, from);
        REQUIRE(path.size() == 8);
        if (from >= 0) CHECK(path.front() == from);
        CHECK(std::count(outer.begin(), outer.end(), path.front()) == 1);
        CHECK(std::count(inner.begin(), inner.end(), path.back()) == 1);
        double length = 0;
        for (std::size_t k = 1; k < path.size(); ++k) {
            length += (ring.points.row(path[k]) - ring.points.row(path[k - 1])).norm();
            if (k + 1 < path.size()) CHECK((path[k] >= around && path[k] < (rows - 1) * around));
        }
        CHECK(length == doctest::Approx(1)); // radius 1 to 2, straight out
    }
    CHECK(path_across(ring, outer, {}).empty());
}

TEST_CASE("a slit ring is a disk with the ring's triangles, the path's left to its left") {
    const int around = 20;
    const TriangleMesh ring = shapes::flat_ring(8, around);
    std::vector<int> path;
    for (int row = 7; row >= 0; --row) path.push_back(row * around); // inwards along x: what has y < 0 lies to its left
    const SlitRing slit = slit_ring(ring, path);
    CHECK(euler_characteristic(slit.mesh) == 1);
    CHECK(boundary_loops(slit.mesh).size() == 1);
    CHECK(slit.mesh.vertex_count() == ring.vertex_count() + 8);
    CHECK(triangle_areas(slit.mesh) == triangle_areas(ring));
    CHECK(slit.left == path);
    const std::set<int> left(slit.left.begin(), slit.left.end()), right(slit.right.begin(), slit.right.end());
    for (int t = 0; t < slit.mesh.triangle_count(); ++t) {
        double y = 0;
        bool at_left = false, at_right = false;
        for (int c = 0; c < 3; ++c) {
            const int v = slit.mesh.triangles(t, c);
            CHECK(slit.original[v] == ring.triangles(t, c));
            y += slit.mesh.points(v, 1);
            at_left = at_left || left.contains(v);
            at_right = at_right || right.contains(v);
        }
        if (at_left) CHECK(y < 0);
        if (at_right) CHECK(y > 0);
    }
}
