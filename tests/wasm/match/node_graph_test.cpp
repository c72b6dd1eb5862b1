#include "lissom/match/node_graph.h"

#include "shapes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace lissom;

TEST_CASE("nodes keep their distance, every vertex is near one, weights sum to one") {
    for (const TriangleMesh& mesh : {shapes::bumpy_sphere(), shapes::torus(), shapes::sheet(20, 20), shapes::uv_sphere()}) {
        const WeightedGraph edges = edge_graph(mesh);
        const NodeGraph graph(edges, 0.4, 3);
        for (const int node : graph.nodes()) {
            const ShortestPaths ways = shortest_paths(edges, std::vector<int>{node});
            for (const int other : graph.nodes()) CHECK((other == node || ways.distance[other] >= 0.4));
        }
        const ShortestPaths to_any = shortest_paths(edges, graph.nodes());
        CHECK(*std::max_element(to_any.distance.begin(), to_any.distance.end()) < 0.4);
        for (int v = 0; v < mesh.vertex_count(); ++v) {
            double sum = 0;
            CHECK(graph.bindings(v).size() <= 4);
            for (const auto& [node, weight] : graph.bindings(v)) {
                CHECK(weight > 0);
                sum += weight;
            }
            CHECK(sum == doctest::Approx(1).epsilon(1e-12));
        }
        for (int g = 0; g < graph.count(); ++g) { // a node is carried by itself before all others
            double own = 0, most = 0;
            for (const auto& [node, weight] : graph.bindings(graph.nodes()[g])) (node == g ? own : most) = std::max(node == g ? own : most, weight);
            CHECK(own > most);
        }
    }
}

TEST_CASE("sheets that lie on each other share no node, however near they are") {
    TriangleMesh upper = shapes::sheet(12, 12);
    upper.points.col(2).array() += 1e-3;
    const TriangleMesh both = shapes::joined({shapes::sheet(12, 12), upper});
    const NodeGraph graph(edge_graph(both), 0.3);
    const int half = both.vertex_count() / 2;
    for (int v = 0; v < both.vertex_count(); ++v)
        for (const auto& [node, weight] : graph.bindings(v)) CHECK((graph.nodes()[node] < half) == (v < half));
}

TEST_CASE("the same seed gives the same nodes, another others; unit and place do not matter") {
    TriangleMesh mesh = shapes::bumpy_sphere();
    const NodeGraph graph(edge_graph(mesh), 0.3, 5);
    CHECK(NodeGraph(edge_graph(mesh), 0.3, 5).nodes() == graph.nodes());
    CHECK(NodeGraph(edge_graph(mesh), 0.3, 6).nodes() != graph.nodes());
    mesh.points = 1e6 * mesh.points;
    CHECK(NodeGraph(edge_graph(mesh), 0.3e6, 5).nodes() == graph.nodes());
}

TEST_CASE("pieces smaller than the radius, single triangles and unused vertices have a node each") {
    const TriangleMesh mesh = shapes::with_unused_vertices(shapes::with_extra_shell(shapes::icosphere(1)), 2);
    const NodeGraph graph(edge_graph(mesh), 100);
    CHECK(graph.count() == 4); // ball, shell, two unused
    for (int v = 0; v < mesh.vertex_count(); ++v) {
        REQUIRE(graph.bindings(v).size() == 1);
        CHECK(graph.bindings(v)[0].weight == 1);
    }
    CHECK(NodeGraph(WeightedGraph{}, 1).count() == 0);
}
