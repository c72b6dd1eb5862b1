#include "lissom/isoline/proxy.h"

#include "shapes.h"

#include "lissom/mesh/nearest_on_triangle.h"
#include "lissom/mesh/operators.h"

#include <doctest/doctest.h>

using namespace lissom;

TEST_CASE("a simplified mesh stands on vertices of the fine one and keeps its shape") {
    const Proxy fine = whole(shapes::bumpy_sphere(5));
    const Proxy coarse = simplified(fine, 2000);
    CHECK(coarse.mesh.triangle_count() <= 2000);
    CHECK(coarse.mesh.triangle_count() > 1500);
    CHECK(euler_characteristic(coarse.mesh) == 2);
    for (int v = 0; v < coarse.mesh.vertex_count(); ++v) CHECK(coarse.mesh.points.row(v) == fine.mesh.points.row(coarse.fine[v]));
    CHECK(signed_volume(coarse.mesh) == doctest::Approx(signed_volume(fine.mesh)).epsilon(0.01));
}

TEST_CASE("unused vertices are left out, a mesh that is small enough is left alone") {
    const TriangleMesh mesh = shapes::with_unused_vertices(shapes::bumpy_sphere(1), 3);
    const Proxy all = whole(mesh);
    CHECK(all.mesh.vertex_count() == mesh.vertex_count() - 3);
    CHECK(simplified(all, 1 << 20).mesh.triangles == all.mesh.triangles);
}

TEST_CASE("every fine vertex is bound to the nearest place of the proxy") {
    const Proxy fine = whole(shapes::bumpy_sphere(5));
    const Proxy coarse = simplified(fine, 1500);
    const VertexRings rings = vertex_rings(fine.mesh);
    SurfaceBinder binder(fine.mesh.points, rings, coarse);
    while (binder.step(700)) {
    }
    CHECK(binder.fraction() == 1);
    const SurfaceBinding binding = binder.take();
    int farther = 0;
    for (int v = 0; v < fine.mesh.vertex_count(); ++v) {
        const int t = binding.triangle[v];
        REQUIRE(t >= 0);
        const double b = binding.weights(v, 0), c = binding.weights(v, 1);
        CHECK(b >= -1e-5);
        CHECK(c >= -1e-5);
        CHECK(b + c <= 1 + 1e-5);
        const Eigen::RowVector3d there = (1 - b - c) * coarse.mesh.points.row(coarse.mesh.triangles(t, 0)) + b * coarse.mesh.points.row(coarse.mesh.triangles(t, 1)) +
                                         c * coarse.mesh.points.row(coarse.mesh.triangles(t, 2));
        double nearest = 1e300; // of all triangles
        for (int s = 0; s < coarse.mesh.triangle_count(); ++s)
            nearest = std::min(nearest, (nearest_on_triangle(fine.mesh.points.row(v), coarse.mesh.points.row(coarse.mesh.triangles(s, 0)),
                                                             coarse.mesh.points.row(coarse.mesh.triangles(s, 1)), coarse.mesh.points.row(coarse.mesh.triangles(s, 2))).point -
                                         fine.mesh.points.row(v).transpose()).norm());
        if ((there - fine.mesh.points.row(v)).norm() > nearest + 1e-6) ++farther;
    }
    CHECK(farther < 0.002 * fine.mesh.vertex_count());
    for (int p = 0; p < coarse.mesh.vertex_count(); ++p) {
        const int v = coarse.fine[p], t = binding.triangle[v];
        CHECK((coarse.mesh.triangles(t, 0) == p || coarse.mesh.triangles(t, 1) == p || coarse.mesh.triangles(t, 2) == p));
    }
}

TEST_CASE("sheets that lie on each other are not mixed up") {
    TriangleMesh upper = shapes::bumpy_sheet(40, 40), lower = upper;
    lower.points.col(2).array() -= 1e-4; // far nearer than the proxy's error
    const TriangleMesh both = shapes::joined({upper, lower});
    const Proxy fine = whole(both), coarse = simplified(fine, 400);
    const VertexRings rings = vertex_rings(both);
    SurfaceBinder binder(both.points, rings, coarse);
    while (binder.step()) {
    }
    const SurfaceBinding binding = binder.take();
    for (int v = 0; v < both.vertex_count(); ++v) {
        const int corner = coarse.fine[coarse.mesh.triangles(binding.triangle[v], 0)];
        CHECK((corner < upper.vertex_count()) == (v < upper.vertex_count()));
    }
}
