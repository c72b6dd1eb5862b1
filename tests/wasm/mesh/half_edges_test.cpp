#include "lissom/mesh/half_edges.h"

#include "lissom/mesh/topology.h"
#include "shapes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <tuple>

using namespace lissom;

namespace {

std::vector<TriangleMesh> sound_and_broken() {
    return {shapes::box(2, 3, 4), shapes::moebius(20, 3), shapes::three_sheets(), shapes::with_fin(shapes::icosphere(1)),
            shapes::with_duplicate_faces(shapes::bumpy_sphere(1)), shapes::with_mixed_orientation(shapes::torus(8, 6))};
}

} // namespace

TEST_CASE("every side of every triangle stands once, in order, and knows its triangle and its direction") {
    for (const TriangleMesh& mesh : sound_and_broken()) {
        const std::vector<HalfEdge> sides = half_edges(mesh);
        CHECK(static_cast<int>(sides.size()) == 3 * mesh.triangle_count());
        const auto place = [](const HalfEdge& e) { return std::tuple(e.a, e.b, e.triangle); };
        CHECK(std::is_sorted(sides.begin(), sides.end(), [&](const HalfEdge& x, const HalfEdge& y) { return place(x) < place(y); }));
        for (const HalfEdge& e : sides) {
            const int from = mesh.triangles(e.triangle, e.corner), to = mesh.triangles(e.triangle, (e.corner + 1) % 3);
            CHECK(e.a < e.b);
            CHECK(from == (e.forward ? e.a : e.b));
            CHECK(to == (e.forward ? e.b : e.a));
        }
    }
}

TEST_CASE("walking edges visits each once with all its sides") {
    for (const TriangleMesh& mesh : sound_and_broken()) {
        const std::vector<HalfEdge> sides = half_edges(mesh);
        const std::vector<Edge> wanted = edges(mesh);
        std::size_t at = 0;
        for_each_edge(sides, [&](auto first, auto last) {
            REQUIRE(at < wanted.size());
            CHECK(first->a == wanted[at].a);
            CHECK(first->b == wanted[at].b);
            CHECK(last - first == wanted[at].forward + wanted[at].backward);
            CHECK(std::count_if(first, last, [](const HalfEdge& e) { return e.forward; }) == wanted[at].forward);
            ++at;
        });
        CHECK(at == wanted.size());
    }
}

TEST_CASE("a side that joins a vertex to itself is no edge") {
    TriangleMesh mesh{Points::Zero(3, 3), Triangles(2, 3)};
    mesh.triangles << 0, 0, 1, 2, 2, 2;
    const std::vector<HalfEdge> sides = half_edges(mesh);
    REQUIRE(sides.size() == 2);
    for (const HalfEdge& e : sides) {
        CHECK(e.a == 0);
        CHECK(e.b == 1);
    }
    CHECK(sides[0].forward != sides[1].forward);
}
