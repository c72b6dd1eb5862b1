#include "lissom/mesh/surface_samples.h"

#include "lissom/mesh/operators.h"
#include "shapes.h"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

using namespace lissom;

TEST_CASE("samples lie in their triangles, and every patch has as many as its area asks for") {
    const TriangleMesh mesh = shapes::uv_sphere(); // triangles of very different sizes
    const SurfacePlaces samples = sample_surface(mesh, 5000, 3);
    REQUIRE(samples.size() == 5000);
    const Eigen::VectorXd areas = triangle_areas(mesh);
    std::vector<int> count(static_cast<std::size_t>(mesh.triangle_count()), 0);
    for (int i = 0; i < samples.size(); ++i) {
        ++count[static_cast<std::size_t>(samples.triangle[static_cast<std::size_t>(i)])];
        CHECK(samples.weights.row(i).minCoeff() >= 0);
        CHECK(samples.weights.row(i).sum() == doctest::Approx(1).epsilon(1e-14));
    }
    for (int t = 0; t < mesh.triangle_count(); ++t) CHECK(std::abs(count[static_cast<std::size_t>(t)] - 5000 * areas[t] / areas.sum()) <= 1.000001);
    const Points places = samples.on(mesh);
    CHECK(places.colwise().mean().norm() < 0.01);
    CHECK((places.rowwise().norm().array() < 1 + 1e-12).all());
}

TEST_CASE("inside a triangle samples are spread evenly") {
    const TriangleMesh mesh{(Points(3, 3) << 0, 0, 0, 1, 0, 0, 0, 1, 0).finished(), (Triangles(1, 3) << 0, 1, 2).finished()};
    const SurfacePlaces samples = sample_surface(mesh, 1000);
    CHECK((samples.weights.colwise().mean().array() - 1.0 / 3).abs().maxCoeff() < 0.005);
    CHECK((samples.weights.array().square().colwise().mean() - 1.0 / 6).abs().maxCoeff() < 0.005);
}

TEST_CASE("neither unit nor place of the surface matters, the seed does; without area there are none") {
    TriangleMesh mesh = shapes::bumpy_sphere();
    const SurfacePlaces samples = sample_surface(mesh, 200, 1);
    CHECK(sample_surface(mesh, 200, 2).weights != samples.weights);
    mesh.points = (1e6 * mesh.points).rowwise() + Eigen::RowVector3d(1e7, 0, 0);
    CHECK(sample_surface(mesh, 200, 1).triangle == samples.triangle);
    CHECK(sample_surface(mesh, 200, 1).weights == samples.weights);
    CHECK(sample_surface({Points(0, 3), Triangles(0, 3)}, 10).size() == 0);
    mesh.points.setZero();
    CHECK(sample_surface(mesh, 10).size() == 0);
}
