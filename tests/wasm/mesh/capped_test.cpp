#include "lissom/mesh/capped.h"

#include "lissom/mesh/operators.h"
#include "lissom/mesh/topology.h"
#include "shapes.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

using namespace lissom;

TEST_CASE("a tube is closed to a prism of its volume, its own vertices and triangles first") {
    const TriangleMesh tube = shapes::cylinder(24, 5, 3), closed = capped(tube);
    CHECK(closed.points.topRows(tube.vertex_count()) == tube.points);
    CHECK(closed.triangles.topRows(tube.triangle_count()) == tube.triangles);
    CHECK(closed.vertex_count() == tube.vertex_count() + 2);
    CHECK(closed.triangle_count() == tube.triangle_count() + 2 * 24);
    CHECK(signed_volume(closed) == doctest::Approx(3 * 12 * std::sin(2 * std::numbers::pi / 24)));
    for (const Edge& e : edges(closed)) {
        CHECK(e.forward == 1);
        CHECK(e.backward == 1);
    }
}

TEST_CASE("a fan's centre is the mean of its loop") {
    const TriangleMesh closed = capped(shapes::cylinder(7, 2, 3));
    const auto centre = [&](int k) -> Eigen::Vector3d { return closed.points.row(closed.vertex_count() - 2 + k); };
    CHECK(centre(0).norm() < 1e-12);
    CHECK((centre(1) - Eigen::Vector3d(0, 0, 3)).norm() < 1e-12);
}

TEST_CASE("what is closed stays as it is, what is open is closed once") {
    for (const TriangleMesh& mesh : {shapes::bumpy_sphere(2), shapes::torus()}) {
        CHECK(capped(mesh).points == mesh.points);
        CHECK(capped(mesh).triangles == mesh.triangles);
    }
    for (const TriangleMesh& mesh : {shapes::bumpy_sheet(), shapes::moebius(), shapes::cylinder(), shapes::bow_tie()}) {
        const TriangleMesh once = capped(mesh);
        CHECK(boundary_loops(once).empty());
        CHECK(capped(once).triangles == once.triangles);
    }
}
