#include "lissom/mesh/topology.h"

#include "lissom/mesh/operators.h"
#include "shapes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>

using namespace lissom;

namespace {

struct Expected {
    const char* name;
    TriangleMesh mesh;
    int euler, loops, components;
};

std::vector<Expected> known_shapes() {
    return {{"box", shapes::box(3, 4, 5), 2, 0, 1},
            {"uv sphere", shapes::uv_sphere(), 2, 0, 1},
            {"icosphere", shapes::icosphere(), 2, 0, 1},
            {"torus", shapes::torus(), 0, 0, 1},
            {"double torus", shapes::double_torus(), -2, 0, 1},
            {"sheet", shapes::sheet(), 1, 1, 1},
            {"cylinder", shapes::cylinder(), 0, 2, 1},
            {"moebius", shapes::moebius(), 0, 1, 1},
            {"klein bottle", shapes::klein_bottle(), 0, 0, 1},
            {"two spheres", shapes::two_spheres(), 4, 0, 2}};
}

} // namespace

TEST_CASE("each shape has its Euler characteristic, boundary loops and components") {
    for (const Expected& shape : known_shapes()) {
        CAPTURE(std::string(shape.name));
        CHECK(euler_characteristic(shape.mesh) == shape.euler);
        CHECK(boundary_loops(shape.mesh).size() == static_cast<std::size_t>(shape.loops));
        CHECK(components(vertex_rings(shape.mesh)).count == shape.components);
        CHECK(non_manifold_vertices(shape.mesh).empty());
    }
}

TEST_CASE("the bar has 2,050 vertices") { CHECK(shapes::bar().vertex_count() == 2050); }

TEST_CASE("closed shapes run each edge once either way") {
    for (const TriangleMesh& mesh : {shapes::box(2, 3, 4), shapes::torus(), shapes::double_torus(), shapes::icosphere(2)})
        for (const Edge& e : edges(mesh)) {
            CHECK(e.forward == 1);
            CHECK(e.backward == 1);
            CHECK(e.a < e.b);
        }
}

TEST_CASE("rings are symmetric, ascending and hold every edge twice") {
    const TriangleMesh mesh = shapes::with_fin(shapes::bumpy_sphere(2));
    const VertexRings rings = vertex_rings(mesh);
    CHECK(rings.neighbours.size() == 2 * edges(mesh).size());
    for (int v = 0; v < rings.vertex_count(); ++v) {
        CHECK(std::is_sorted(rings[v].begin(), rings[v].end()));
        for (const int w : rings[v])
            CHECK(std::binary_search(rings[w].begin(), rings[w].end(), v));
    }
}

TEST_CASE("a boundary loop runs with its triangles and starts at its smallest vertex") {
    const TriangleMesh mesh = shapes::cylinder(12, 3);
    const auto loops = boundary_loops(mesh);
    REQUIRE(loops.size() == 2);
    for (const std::vector<int>& loop : loops) {
        CHECK(loop.size() == 12);
        CHECK(loop.front() == *std::min_element(loop.begin(), loop.end()));
    }
    CHECK(loops[0][1] == 1); // the lower rim of an outward cylinder runs around +z: the surface is to its left
    CHECK(loops[1][1] == loops[1][0] + 11);
}

TEST_CASE("boundary loops that touch in a vertex come apart") {
    const TriangleMesh mesh = shapes::bow_tie(4);
    const auto loops = boundary_loops(mesh);
    REQUIRE(loops.size() == 2);
    CHECK(loops[0].size() == 16);
    CHECK(loops[1].size() == 16);
    CHECK(non_manifold_vertices(mesh) == std::vector<int>{24});
    CHECK(components(vertex_rings(mesh)).count == 1);
}

TEST_CASE("two holes that touch are two loops") {
    TriangleMesh mesh = shapes::sheet(4, 4);
    Triangles kept(mesh.triangles.rows() - 4, 3);
    int count = 0;
    for (int t = 0; t < mesh.triangle_count(); ++t)
        if (t / 2 != 5 && t / 2 != 10) // two cells in the middle, diagonal to each other
            kept.row(count++) = mesh.triangles.row(t);
    mesh.triangles = kept;
    const auto loops = boundary_loops(mesh);
    REQUIRE(loops.size() == 3);
    CHECK(loops[0].size() == 16);
    CHECK(loops[1].size() == 4);
    CHECK(loops[2].size() == 4);
}

TEST_CASE("three sheets on one line keep their edges of three triangles and lose no vertex") {
    const TriangleMesh mesh = shapes::three_sheets(6);
    const std::vector<Edge> all = edges(mesh);
    CHECK(std::count_if(all.begin(), all.end(), [](const Edge& e) { return e.forward + e.backward == 3; }) == 6);
    CHECK(components(vertex_rings(mesh)).count == 1);
    CHECK(non_manifold_vertices(mesh).empty());
    CHECK_NOTHROW((void)boundary_loops(mesh));
}

TEST_CASE("boundary vertices are those of the loops") {
    for (const TriangleMesh& mesh : {shapes::cylinder(), shapes::sheet(), shapes::moebius(), shapes::torus()}) {
        std::vector<bool> on_loop(mesh.vertex_count(), false);
        for (const auto& loop : boundary_loops(mesh))
            for (const int v : loop)
                on_loop[v] = true;
        CHECK(on_loop == boundary_vertices(mesh));
    }
}

TEST_CASE("an unused vertex is a component without neighbours and does not count in V − E + F") {
    const TriangleMesh mesh = shapes::with_unused_vertices(shapes::icosphere(1), 3);
    CHECK(components(vertex_rings(mesh)).count == 4);
    CHECK(euler_characteristic(mesh) == 2);
}

TEST_CASE("an empty mesh has nothing to walk") {
    const TriangleMesh none{Points(0, 3), Triangles(0, 3)};
    CHECK(edges(none).empty());
    CHECK(boundary_loops(none).empty());
    CHECK(components(vertex_rings(none)).count == 0);
    CHECK(euler_characteristic(none) == 0);
}
