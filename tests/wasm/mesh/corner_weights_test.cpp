#include "lissom/mesh/corner_weights.h"

#include "shapes.h"

#include <doctest/doctest.h>

using Eigen::Vector3d;

TEST_CASE("weights of corners give the place back, and a corner is its own") {
    const lissom::TriangleMesh ball = shapes::icosphere(2);
    const Vector3d wanted(0.2, 0.5, 0.3);
    for (int t = 0; t < ball.triangle_count(); t += 7) {
        Vector3d place = Vector3d::Zero();
        for (int k = 0; k < 3; ++k) place += wanted[k] * ball.points.row(ball.triangles(t, k)).transpose();
        CHECK(lissom::corner_weights(ball, t, place).isApprox(wanted, 1e-12));
        CHECK(lissom::corner_weights(ball, t, ball.points.row(ball.triangles(t, 1))).isApprox(Vector3d(0, 1, 0), 1e-12));
    }
}

TEST_CASE("beside a triangle no weight is negative, and one without area has its first corner") {
    const lissom::TriangleMesh sheet = shapes::sheet(1, 1);
    const Vector3d weights = lissom::corner_weights(sheet, 0, {7, -3, 1});
    CHECK(weights.minCoeff() >= 0);
    CHECK(weights.sum() == doctest::Approx(1));
    lissom::TriangleMesh flat = sheet;
    flat.points.row(1) = flat.points.row(0);
    flat.points.row(2) = flat.points.row(0);
    CHECK(lissom::corner_weights(flat, 0, {1, 1, 1}) == Vector3d(1, 0, 0));
}
