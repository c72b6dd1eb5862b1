#include "lissom/match/flood_grid.h"

#include "refusal.h"
#include "shapes.h"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

using namespace lissom;

TEST_CASE("nodes outside of a ball are reached, those inside are not, and distances are true") {
    const TriangleMesh ball = shapes::icosphere(4);
    FloodGrid flood(ball, 40);
    double before = 0;
    while (flood.step()) {
        CHECK(flood.fraction() >= before);
        before = flood.fraction();
    }
    CHECK(flood.first_sound() == 0);
    const double r = flood.radii().front(), step = flood.grid().step;
    const std::vector<char> reached = flood.reached(r);
    for (int i = 0; i < flood.grid().count(); ++i) {
        const double off = flood.grid().position(i).norm() - 1;
        if (std::abs(off) < flood.radii().back()) CHECK(flood.distances()[i] == doctest::Approx(std::abs(off)).epsilon(0.02).scale(1));
        if (std::abs(off - r) > 0.1 * step) CHECK(bool(reached[i]) == (off > r));
    }
    CHECK(refusal([] { const TriangleMesh place{Points::Zero(1, 3), Triangles::Zero(1, 3)}; FloodGrid{place, 40}; }) == "flat-model");
}

TEST_CASE("a radius at which the flood runs in through holes is not sound") {
    TriangleMesh ball = shapes::icosphere(3);
    int row = 0;
    for (int t = 0; t < ball.triangle_count(); ++t)
        if (t % 10) ball.triangles.row(row++) = ball.triangles.row(t);
    ball.triangles.conservativeResize(row, 3);
    FloodGrid flood(ball, 100);
    while (flood.step()) {
    }
    const auto middle_is_reached = [&](int k) {
        const Grid& grid = flood.grid();
        const Eigen::Vector3i at = grid.local(Eigen::Vector3d::Zero()).array().round().cast<int>().matrix();
        return flood.reached(flood.radii()[static_cast<std::size_t>(k)])[grid.node(at.x(), at.y(), at.z())] != 0;
    };
    REQUIRE(flood.first_sound() > 0);
    CHECK(middle_is_reached(flood.first_sound() - 1));
    CHECK_FALSE(middle_is_reached(flood.first_sound()));
}
