#include "lissom/match/marker_curves.h"

#include "shapes.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace lissom;
using Eigen::RowVector3d;

namespace {

/// A circle of latitude of the unit sphere, not all of it, at uneven steps.
Points arc(double height, double turn, int count) {
    Points line(count, 3);
    for (int i = 0; i < count; ++i) {
        const double part = std::pow(static_cast<double>(i) / (count - 1), 1.5), angle = turn * part, r = std::sqrt(1 - height * height);
        line.row(i) << r * std::cos(angle), r * std::sin(angle), height;
    }
    return line;
}

} // namespace

TEST_CASE("places along a polyline are equally far apart along it, whatever its own steps") {
    Points line(4, 3);
    line << 0, 0, 0, 1, 0, 0, 1, 0, 0, 1, 3, 0;
    const Points places = places_along_polyline(line, 5);
    Points wanted(5, 3);
    wanted << 0, 0, 0, 1, 0, 0, 1, 1, 0, 1, 2, 0, 1, 3, 0;
    CHECK((places - wanted).norm() < 1e-12);
    CHECK(places_along_polyline(line, 1).row(0).isZero());
}

TEST_CASE("curves drawn unevenly on two balls correspond by the share of their length, and pull at the skin where they run") {
    const TriangleMesh ball = shapes::icosphere(4);
    TriangleMesh large = ball;
    large.points *= 2;
    const FitSurface here(ball), there(large);
    const std::vector<Points> from{arc(0.3, 2, 40), arc(-0.5, 1, 7)}, to{2 * arc(0.3, 2, 200), 2 * arc(-0.5, 1, 90)};
    const MarkerCurves curves(from, here, 0.1);
    CHECK_FALSE(curves.empty());
    const Points targets = curves.on(to, there);
    const auto pulls = curves.pulls(ball, targets);
    REQUIRE(std::ssize(pulls) == targets.rows());
    CHECK(targets.rows() > 25);
    for (std::size_t i = 0; i < pulls.size(); ++i) {
        RowVector3d place = RowVector3d::Zero();
        for (int k = 0; k < 3; ++k) place += pulls[i].weights[k] * ball.points.row(pulls[i].vertices[k]);
        CHECK(there.nearest(targets.row(static_cast<Eigen::Index>(i)), Eigen::Vector3d::Zero(), -1, 1).distance < 1e-9);
        CHECK((2 * place.transpose() - pulls[i].target).norm() < 0.04); // chords of the coarser polyline
    }
    CHECK(MarkerCurves({}, here, 0.1).pulls(ball, Points(0, 3)).empty());
}
