#include "lissom/mesh/nearest_on_triangle.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>

#include <cmath>

using namespace lissom;
using Eigen::Vector3d;

TEST_CASE("the nearest point of a triangle is nearer than any other of a fine sampling") {
    const Vector3d a(0, 0, 0), b(1, 0.2, 0), c(0.3, 0.9, 0.4);
    for (int i = 0; i < 300; ++i) {
        const Vector3d p = 2 * Vector3d(std::sin(i * 1.3), std::cos(i * 2.1), std::sin(i * 0.7 + 1));
        const double nearest = (p - nearest_on_triangle(p, a, b, c).point).norm();
        for (double u = 0; u <= 1; u += 0.1)
            for (double v = 0; u + v <= 1; v += 0.1) CHECK(nearest <= (p - (a + u * (b - a) + v * (c - a))).norm() + 1e-12);
    }
}

TEST_CASE("each corner, each edge and the inside is named for what lies before it") {
    const Vector3d a(0, 0, 0), b(4, 0, 0), c(0, 4, 0);
    const struct {
        Vector3d p, nearest;
        int feature;
    } known[] = {{{-1, -1, 2}, a, 0},       {{6, -1, 0}, b, 1},         {{-1, 6, -3}, c, 2},
                 {{3, 3, 1}, {2, 2, 0}, 3}, {{-2, 1, 5}, {0, 1, 0}, 4}, {{1, -2, 5}, {1, 0, 0}, 5},
                 {{1, 1, 7}, {1, 1, 0}, 6}, {a, a, 0},                  {{2, 0, 0}, {2, 0, 0}, 5}};
    for (const auto& [p, nearest, feature] : known) {
        const NearestOnTriangle found = nearest_on_triangle(p, a, b, c);
        CAPTURE(p.transpose());
        CHECK((found.point - nearest).norm() < 1e-15);
        CHECK(found.feature == feature);
    }
}

TEST_CASE("it moves, turns and grows with the triangle") {
    const Vector3d a(0.2, 0.1, 0), b(1, 0.2, 0.3), c(0.3, 0.9, 0.4);
    for (const double scale : {1e-6, 1.0, 1e6}) {
        const Eigen::Affine3d map = Eigen::Translation3d(scale * Vector3d(3, -2, 1)) * Eigen::AngleAxisd(1.1, Vector3d(1, 2, 3).normalized()) * Eigen::Scaling(scale);
        for (int i = 0; i < 100; ++i) {
            const Vector3d p = 2 * Vector3d(std::sin(i * 1.3), std::cos(i * 2.1), std::sin(i * 0.7 + 1));
            const NearestOnTriangle here = nearest_on_triangle(p, a, b, c), there = nearest_on_triangle(map * p, map * a, map * b, map * c);
            CHECK(here.feature == there.feature);
            CHECK((map * here.point - there.point).norm() < 1e-12 * scale);
        }
    }
}
