#include "lissom/mesh/polyline.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

using namespace lissom;
using Eigen::Vector3d;

TEST_CASE("a line resampled keeps its ends and has segments of one length") {
    const Polyline bent{{0, 0, 0}, {0.3, 0, 0}, {0.3, 2, 0}, {0.3, 2, 0}, {1, 2, 0}};
    const Polyline even = resampled(bent, 0.25);
    CHECK(even.size() == 13);
    CHECK(even.front() == bent.front());
    CHECK(even.back() == bent.back());
    double total = 0;
    for (std::size_t i = 1; i < even.size(); ++i) total += (even[i] - even[i - 1]).norm();
    CHECK(total == doctest::Approx(3).epsilon(0.05));
    CHECK(resampled({{1, 1, 1}, {1, 1, 1}}, 0.1).empty());
    CHECK(resampled({}, 0.1).empty());
}

TEST_CASE("a straight line resampled is as even as it can be, whatever its points and unit") {
    for (const double unit : {1e-6, 1.0, 1e6}) {
        const Polyline uneven{{0, 0, 0}, {0.1 * unit, 0, 0}, {0.11 * unit, 0, 0}, {2 * unit, 0, 0}};
        const Polyline even = resampled(uneven, 0.3 * unit); // 2 / 0.3 rounds to 7
        REQUIRE(even.size() == 8);
        for (std::size_t k = 0; k < 8; ++k) CHECK((even[k] - Vector3d(2 * unit * static_cast<double>(k) / 7, 0, 0)).norm() < 1e-12 * unit);
    }
}

TEST_CASE("a line shorter than a step is one segment, one without numbers is none") {
    const Polyline line{{0, 0, 0}, {0, 0, 1}};
    CHECK(resampled(line, 100) == line);
    CHECK(resampled({{0, 0, 0}, {0, std::numeric_limits<double>::quiet_NaN(), 1}}, 0.1).empty());
    CHECK(resampled({{0, 0, 0}, {0, std::numeric_limits<double>::infinity(), 1}}, 0.1).empty());
}

TEST_CASE("the length of a loop is that of its polygon, wherever it starts and however it runs") {
    const int n = 12;
    Points circle(n + 1, 3);
    circle.row(n).setConstant(1e9); // not on the loop
    for (int k = 0; k < n; ++k) circle.row(k) << 3 * std::cos(2 * std::numbers::pi * k / n), 5, 3 * std::sin(2 * std::numbers::pi * k / n);
    std::vector<int> loop(n);
    std::iota(loop.begin(), loop.end(), 0);
    const double length = 2 * n * 3 * std::sin(std::numbers::pi / n);
    CHECK(loop_length(circle, loop) == doctest::Approx(length));
    std::rotate(loop.begin(), loop.begin() + 5, loop.end());
    std::reverse(loop.begin(), loop.end());
    CHECK(loop_length(circle, loop) == doctest::Approx(length));
    CHECK(loop_length(circle, {}) == 0);
    CHECK(loop_length(circle, {3}) == 0);
}
