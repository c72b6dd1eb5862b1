#include "lissom/wear/surface_turns.h"

#include "shapes.h"

#include <doctest/doctest.h>

#include <cmath>

using Eigen::AngleAxisd;
using Eigen::Matrix3d;
using Eigen::Vector3d;

TEST_CASE("a surface that turns and grows turns by just that") {
    const lissom::TriangleMesh ball = shapes::bumpy_sphere(2);
    const Matrix3d turn = AngleAxisd(1.1, Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();
    for (const Matrix3d& found : lissom::surface_turns(ball, 3.5 * ball.points * turn.transpose())) CHECK(found.isApprox(turn, 1e-9));
}

TEST_CASE("where it bends each vertex turns as what is around it, and needles have no say") {
    const lissom::TriangleMesh bar = shapes::with_needles(shapes::box(2, 40, 2, {0.2, 8, 0.2}), 4, 1e-12);
    lissom::Points bent = bar.points; // around a circle of radius 4 in x and y
    for (Eigen::Index v = 0; v < bent.rows(); ++v) {
        const double angle = bar.points(v, 1) / 4, r = 4 + bar.points(v, 0);
        bent.row(v) << r * std::cos(angle), r * std::sin(angle), bar.points(v, 2);
    }
    const auto turns = lissom::surface_turns(bar, bent);
    for (Eigen::Index v = 0; v < bent.rows(); ++v)
        if (bar.points(v, 1) > 0.5 && bar.points(v, 1) < 7.5) CHECK(turns[static_cast<std::size_t>(v)].isApprox(AngleAxisd(bar.points(v, 1) / 4, Vector3d::UnitZ()).toRotationMatrix(), 0.06));
}

TEST_CASE("the map of each triangle is that of the surface, and a needle tells none") {
    const lissom::TriangleMesh ball = shapes::bumpy_sphere(2);
    const Matrix3d map = 3.5 * AngleAxisd(1.1, Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();
    for (const Matrix3d& found : lissom::surface_maps(ball, ball.points * map.transpose())) CHECK(found.isApprox(map, 1e-9));
    lissom::TriangleMesh needle{lissom::Points(3, 3), lissom::Triangles(1, 3)};
    needle.points << 0, 0, 0, 1, 0, 0, 0.5, 1e-9, 0;
    needle.triangles << 0, 1, 2;
    CHECK(lissom::surface_maps(needle, needle.points)[0].isZero(0));
}
