#include "lissom/mesh/winding_number.h"

#include "shapes.h"

#include "lissom/mesh/chance.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

using Eigen::Vector3d;
using lissom::WindingNumber;

namespace {

Vector3d place(int k, double reach) {
    return {reach * (2 * lissom::chance(1, static_cast<std::uint64_t>(k), 0) - 1), reach * (2 * lissom::chance(1, static_cast<std::uint64_t>(k), 1) - 1),
            reach * (2 * lissom::chance(1, static_cast<std::uint64_t>(k), 2) - 1)};
}

} // namespace

TEST_CASE("a closed surface winds once around what is inside and not around what is outside") {
    const WindingNumber ball(shapes::icosphere(4)), ring(shapes::torus(48, 24));
    for (int k = 0; k < 500; ++k) {
        const Vector3d p = place(k, 1.6);
        if (std::abs(p.norm() - 1) > 0.01) CHECK(ball(p) == doctest::Approx(p.norm() < 1 ? 1 : 0).epsilon(0.07).scale(1));
        CHECK(std::abs(ball(p) - ball.exact(p)) < 0.07);
        CHECK(std::abs(ring(p) - ring.exact(p)) < 0.07);
    }
    CHECK(ring({1, 0, 0}) == doctest::Approx(1).epsilon(0.07));
    CHECK(std::abs(ring({0, 0, 0})) < 0.07);
}

TEST_CASE("of a surface turned inside out it is minus one, of two around each other two") {
    const lissom::TriangleMesh ball = shapes::icosphere(3);
    CHECK(WindingNumber(shapes::turned_inside_out(ball))({0.1, 0, 0}) == doctest::Approx(-1).epsilon(0.07));
    CHECK(WindingNumber(shapes::joined({ball, shapes::moved(ball, Eigen::Affine3d(Eigen::Scaling(2.0)))}))({0.1, 0, 0}) == doctest::Approx(2).epsilon(0.07));
}

TEST_CASE("a flat disc seen at right angles takes the solid angle that it takes, and size changes nothing") {
    const lissom::TriangleMesh disc = shapes::sheet(20, 20); // a unit square
    const double h = 0.5, seen = 4 * std::asin(0.25 / (0.25 + h * h)) / (4 * 3.141592653589793);
    const Eigen::RowVector3d middle = disc.points.colwise().mean();
    for (const double size : {1.0, 1e-5, 1e6}) {
        const WindingNumber number(shapes::moved(disc, Eigen::Affine3d(Eigen::Scaling(size))));
        CHECK(std::abs(number(size * (middle.transpose() + Vector3d(0, 0, -h)))) == doctest::Approx(seen).epsilon(0.07));
    }
}

TEST_CASE("nothing and nowhere are told as zero") {
    CHECK(WindingNumber(lissom::TriangleMesh{})({0, 0, 0}) == 0);
    const WindingNumber torn(shapes::with_nan_vertex(shapes::icosphere(2)));
    CHECK(std::isfinite(torn({0, 0, 0})));
    CHECK(torn({std::numeric_limits<double>::quiet_NaN(), 0, 0}) == 0);
}
