#include "lissom/mesh/surface_places.h"

#include "shapes.h"

#include "lissom/mesh/surface_samples.h"

#include <doctest/doctest.h>

TEST_CASE("points of a surface are found where they are, others at what is nearest") {
    const lissom::TriangleMesh ball = shapes::bumpy_sphere(3);
    const lissom::SurfacePlaces samples = lissom::sample_surface(ball, 300);
    const lissom::Points on = samples.on(ball);
    const lissom::SurfacePlaces places = lissom::places_on(ball, on);
    CHECK((lissom::SurfacePlaces{places.triangle, places.weights}.on(ball) - on).cwiseAbs().maxCoeff() < 1e-9);
    const lissom::SurfacePlaces above = lissom::places_on(shapes::sheet(4, 4), lissom::Points(Eigen::RowVector3d(0.3, 0.2, 5)));
    CHECK((lissom::SurfacePlaces{above.triangle, above.weights}.on(shapes::sheet(4, 4)) - Eigen::RowVector3d(0.3, 0.2, 0)).norm() < 1e-9);
    CHECK(above.weights.minCoeff() >= 0);
}

TEST_CASE("on no surface there is no place") {
    CHECK(lissom::places_on(lissom::TriangleMesh{}, lissom::Points::Zero(1, 3)).triangle[0] == -1);
}
