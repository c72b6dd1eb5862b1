#include "lissom/merge/hole_filling.h"

#include "shapes.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>

#include <cmath>
#include <map>
#include <numbers>
#include <numeric>

using namespace lissom;
using Eigen::Vector3d;

namespace {

double area_of(const Points& points, const std::vector<int>& loop, const std::vector<std::array<int, 3>>& triangles) {
    double area = 0;
    for (const auto& [a, b, c] : triangles) {
        const Vector3d p = points.row(loop[a]), q = points.row(loop[b]), r = points.row(loop[c]);
        area += (q - p).cross(r - p).norm() / 2;
    }
    return area;
}

/// A loop of n that waves up and down, numbered backwards in its points.
struct Wavy {
    Points points;
    std::vector<int> loop;
    explicit Wavy(int n, double unit = 1) : points(n, 3), loop(static_cast<std::size_t>(n)) {
        for (int k = 0; k < n; ++k) {
            const double a = 2 * std::numbers::pi * k / n;
            points.row(n - 1 - k) << unit * std::cos(a), unit * 0.4 * std::sin(3 * a), unit * (1 + 0.2 * std::cos(2 * a)) * std::sin(a);
            loop[static_cast<std::size_t>(k)] = n - 1 - k;
        }
    }
};

} // namespace

TEST_CASE("the least-area filling of a flat polygon has its area") {
    const TriangleMesh ring = shapes::flat_ring(2, 24);
    std::vector<int> inner(24);
    std::iota(inner.begin(), inner.end(), 0);
    CHECK(area_of(ring.points, inner, least_area_filling(ring.points, inner)) == doctest::Approx(12 * std::sin(2 * std::numbers::pi / 24)));
}

TEST_CASE("a filling has two triangles fewer than the loop has vertices, and its border is the loop") {
    for (const int n : {3, 4, 7, 40, 513, 5001}) { // the last by hours, were it searched whole
        const Wavy wavy(n);
        const auto triangles = least_area_filling(wavy.points, wavy.loop);
        CHECK(static_cast<int>(triangles.size()) == n - 2);
        std::map<std::pair<int, int>, int> runs;
        for (const auto& t : triangles)
            for (int c = 0; c < 3; ++c) ++runs[{t[static_cast<std::size_t>(c)], t[static_cast<std::size_t>((c + 1) % 3)]}];
        for (int i = 0; i < n; ++i) CHECK(runs[{i, (i + 1) % n}] == 1); // along the loop
        for (const auto& [edge, count] : runs)
            if (count > 0 && (edge.first + 1) % n != edge.second) {
                CHECK(count == 1);
                CHECK(runs[{edge.second, edge.first}] == 1);
            }
    }
}

TEST_CASE("no fan over the loop has less area") {
    const Wavy wavy(25);
    const double least = area_of(wavy.points, wavy.loop, least_area_filling(wavy.points, wavy.loop));
    for (int apex = 0; apex < 25; ++apex) {
        std::vector<std::array<int, 3>> fan;
        for (int k = 1; k + 1 < 25; ++k) fan.push_back({apex, (apex + k) % 25, (apex + k + 1) % 25});
        CHECK(least <= area_of(wavy.points, wavy.loop, fan) * (1 + 1e-12));
    }
}

TEST_CASE("the unit of length does not matter") {
    const auto here = least_area_filling(Wavy(30).points, Wavy(30).loop);
    // Powers of two, for the loop's symmetry makes ties that rounding would break either way.
    for (const double unit : {std::ldexp(1.0, -20), std::ldexp(1.0, 20)}) CHECK(least_area_filling(Wavy(30, unit).points, Wavy(30, unit).loop) == here);
}

TEST_CASE("two points and fewer leave nothing to fill") {
    const Wavy wavy(3);
    CHECK(least_area_filling(wavy.points, {0, 1}).empty());
    CHECK(least_area_filling(wavy.points, {0}).empty());
}
