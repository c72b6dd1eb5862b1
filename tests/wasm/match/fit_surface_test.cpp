#include "lissom/match/fit_surface.h"

#include "shapes.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace lissom;
using Eigen::Vector3d;

TEST_CASE("on a thin plate the place is on the side that faces as the point does") {
    const FitSurface plate(shapes::box(6, 1, 6, {1, 0.02, 1})); // y from 0 to 0.02
    const Vector3d above(0.13, 0.05, 0.07);
    CHECK(plate.nearest(above, {0, 1, 0}, 0.3, 1).point.isApprox(Vector3d(0.13, 0.02, 0.07)));
    const auto under = plate.nearest(above, {0, -1, 0}, 0.3, 1);
    CHECK(under.point.isApprox(Vector3d(0.13, 0, 0.07)));
    CHECK(under.cosine == doctest::Approx(1));
    CHECK(plate.nearest(above, {0, -1, 0}, -1, 1).point.y() == doctest::Approx(0.02));
    CHECK(plate.nearest(above, {0, -1, 0}, 0.3, 0.04).triangle == -1);
    const FitSurface blind(shapes::box(6, 1, 6, {1, 0.02, 1}), {true, false});
    CHECK(blind.nearest(above, {0, -1, 0}, 0.3, 1).point.y() == doctest::Approx(0.02));
    CHECK_FALSE(plate.has_border());
    CHECK(plate.nearest_on_border(above, 10).triangle == -1);
}

TEST_CASE("places on a rim are told, and the rim has places of its own") {
    const FitSurface sheet(shapes::sheet());
    const Points& p = sheet.mesh().points;
    const Eigen::RowVector3d low = p.colwise().minCoeff(), high = p.colwise().maxCoeff();
    const Vector3d up(0, 0, 1);
    CHECK(sheet.has_border());
    CHECK_FALSE(sheet.nearest({(low.x() + high.x()) / 2, (low.y() + high.y()) / 2, 0.1}, up, 0.3, 1).on_border);
    const Vector3d beyond(high.x() + 0.2, 0.47 * low.y() + 0.53 * high.y(), 0.1), corner(high.x() + 0.2, high.y() + 0.2, 0.1);
    CHECK(sheet.nearest(beyond, up, 0.3, 1).on_border);
    CHECK(sheet.nearest(corner, up, 0.3, 1).on_border);
    const auto rim = sheet.nearest_on_border({0.49 * low.x() + 0.51 * high.x(), high.y() - 0.2, 0}, 1);
    CHECK(rim.point.y() == doctest::Approx(high.y()));
    CHECK(rim.distance == doctest::Approx(0.2));
    CHECK(rim.on_border);
    const FitSurface soup(shapes::soup(shapes::icosphere(2)), {false, true});
    CHECK_FALSE(soup.has_border());
    CHECK_FALSE(soup.nearest({2, 0.1, 0.2}, Vector3d::UnitX(), 0.3, 2).on_border);
}

TEST_CASE("the cosine does not jump where one triangle ends and the next begins") {
    const FitSurface ball(shapes::bumpy_sphere(2));
    const Points& p = ball.mesh().points;
    const Vector3d normal = Vector3d(1, 2, 3).normalized();
    for (const auto& t : ball.mesh().triangles.rowwise()) {
        const Vector3d middle = (p.row(t[0]) + p.row(t[1])) / 2, across = 1e-9 * (p.row(t[2]).transpose() - middle);
        CHECK(std::abs(ball.nearest(middle + across, normal, -1, 1).cosine - ball.nearest(middle - across, normal, -1, 1).cosine) < 1e-7);
    }
}

TEST_CASE("no surface and no area have no place, and no number that is none") {
    const FitSurface none({Points(0, 3), Triangles(0, 3)});
    CHECK(none.nearest({0, 0, 0}, {0, 0, 1}, 0.3, INFINITY).triangle == -1);
    const FitSurface point({Points::Zero(3, 3), (Triangles(1, 3) << 0, 1, 2).finished()});
    CHECK(point.normals().isZero());
    CHECK(point.nearest({1, 0, 0}, {0, 0, 1}, -1, INFINITY).distance == doctest::Approx(1));
}
