#include "lissom/mesh/orientation.h"

#include "lissom/mesh/operators.h"
#include "lissom/mesh/topology.h"
#include "shapes.h"

#include <doctest/doctest.h>

#include <algorithm>

using namespace lissom;

namespace {

TriangleMesh turned(TriangleMesh mesh, const Orientation& by) {
    for (int t = 0; t < mesh.triangle_count(); ++t)
        if (by.turned[t]) std::swap(mesh.triangles(t, 1), mesh.triangles(t, 2));
    return mesh;
}

int edges_in_conflict(const TriangleMesh& mesh) {
    const std::vector<Edge> all = edges(mesh);
    return static_cast<int>(std::count_if(all.begin(), all.end(), [](const Edge& e) { return e.forward > 1 || e.backward > 1; }));
}

int turned_count(const Orientation& o) { return static_cast<int>(std::count(o.turned.begin(), o.turned.end(), true)); }

} // namespace

TEST_CASE("what agrees and faces outward is left alone") {
    for (const TriangleMesh& mesh : {shapes::bumpy_sphere(2), shapes::torus(), shapes::bumpy_sheet(), shapes::two_spheres(1)}) {
        const Orientation found = orient(mesh);
        CHECK(turned_count(found) == 0);
        CHECK(found.inconsistent.empty());
        CHECK(found.inside_out.empty());
        CHECK(found.one_sided.empty());
    }
}

TEST_CASE("a closed patch that disagreed comes out facing outward, whichever triangles were wrong") {
    const TriangleMesh sound = shapes::bumpy_sphere(2);
    for (const int every : {2, 3, 7}) {
        CAPTURE(every);
        const TriangleMesh mixed = shapes::with_mixed_orientation(sound, every);
        const Orientation found = orient(mixed);
        const TriangleMesh mended = turned(mixed, found);
        CHECK(edges_in_conflict(mended) == 0);
        CHECK(signed_volume(mended) == doctest::Approx(signed_volume(sound)));
        CHECK(static_cast<int>(found.inconsistent.size()) == turned_count(found));
        CHECK(turned_count(orient(mended)) == 0);
    }
}

TEST_CASE("an open patch faces as most of it did") {
    const TriangleMesh sheet = shapes::bumpy_sheet(6, 6);
    const Orientation found = orient(shapes::with_mixed_orientation(sheet, 3));
    CHECK(turned_count(found) == sheet.triangle_count() / 3);
    const TriangleMesh mended = turned(shapes::with_mixed_orientation(sheet, 3), found);
    CHECK((vertex_normals(mended) - vertex_normals(sheet)).norm() < 1e-12);
}

TEST_CASE("a closed patch that faces inward is turned, a cavity in another is not") {
    const TriangleMesh ball = shapes::icosphere(2);
    const TriangleMesh inward = shapes::turned_inside_out(ball);
    CHECK(static_cast<int>(orient(inward).inside_out.size()) == ball.triangle_count());
    const TriangleMesh cavity = shapes::moved(inward, Eigen::Affine3d(Eigen::Scaling(0.5)));
    CHECK(turned_count(orient(shapes::joined({ball, cavity}))) == 0);
    const TriangleMesh beside = shapes::moved(inward, Eigen::Affine3d(Eigen::Translation3d(5, 0, 0) * Eigen::Scaling(0.5)));
    CHECK(static_cast<int>(orient(shapes::joined({ball, beside})).inside_out.size()) == ball.triangle_count());
}

TEST_CASE("one-sided patches are named once each and turned only where fewer edges then disagree") {
    const TriangleMesh strips = shapes::joined({shapes::moebius(), shapes::moved(shapes::moebius(), Eigen::Affine3d(Eigen::Translation3d(9, 0, 0)))});
    const Orientation found = orient(strips);
    CHECK(found.one_sided.size() == 2);
    CHECK(edges_in_conflict(turned(strips, found)) <= edges_in_conflict(strips));
}
