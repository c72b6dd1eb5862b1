#include "lissom/mesh/orient.h"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

using namespace lissom;
using Eigen::Vector2d;
using Eigen::Vector3d;

TEST_CASE("points on either side of a plane and in it are told apart to the last bit") {
    const Vector3d a(0, 0, 0), b(1, 0, 0), c(0, 1, 0);
    CHECK(orient3d(a, b, c, {0, 0, 1}) == 1);
    CHECK(orient3d(a, b, c, {0, 0, -1}) == -1);
    CHECK(orient3d(a, b, c, {0.3, 0.3, 0}) == 0);
    CHECK(orient3d(a, b, c, {0.3, 0.3, 1e-300}) == 1);
    // A slanted plane through representable places: x + y + z = 3/2 in steps of the last bit.
    const double step = std::nextafter(0.5, 1.0);
    const Vector3d p(0.5, 0.5, 0.5), q(1, 0.25, 0.25), r(0.25, 1, 0.25), on(0.25, 0.25, 1), above(0.25, 0.25, std::nextafter(1.0, 2.0));
    CHECK(orient3d(p, q, r, on) == 0);
    CHECK(orient3d(p, q, r, above) == -orient3d(p, q, r, {0.25, 0.25, std::nextafter(1.0, 0.0)}));
    CHECK(orient3d({step, 0.5, 0.5}, q, r, on) != 0);
}

TEST_CASE("swapping two points turns the answer, whatever the places") {
    std::mt19937 draw(7);
    std::uniform_int_distribution<int> coarse(-2, 2); // many that lie in one plane
    const auto point = [&] { return Vector3d(0.1 * coarse(draw), 0.1 * coarse(draw), 0.1 * coarse(draw)); };
    int flat = 0;
    for (int k = 0; k < 2000; ++k) {
        const Vector3d a = point(), b = point(), c = point(), d = point();
        const int side = orient3d(a, b, c, d);
        flat += side == 0;
        CHECK(orient3d(b, a, c, d) == -side);
        CHECK(orient3d(b, c, a, d) == side);
        CHECK(orient3d(a, b, d, c) == -side);
    }
    CHECK(flat > 100);
}

TEST_CASE("turns in the plane") {
    CHECK(orient2d({0, 0}, {1, 0}, {0, 1}) == 1);
    CHECK(orient2d({0, 0}, {0, 1}, {1, 0}) == -1);
    CHECK(orient2d({0.5, 0.5}, {12, 12}, {24, 24}) == 0);
    CHECK(orient2d({0.5, 0.5}, {12, 12}, {24, std::nextafter(24.0, 25.0)}) == 1);
    CHECK(orient2d({0.5, std::nextafter(0.5, 1.0)}, {12, 12}, {24, 24}) != 0);
}
