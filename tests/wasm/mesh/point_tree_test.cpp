#include "lissom/mesh/point_tree.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace lissom;

namespace {

Points scattered(int n) {
    Points points(n, 3);
    for (int v = 0; v < n; ++v)
        for (int k = 0; k < 3; ++k) points(v, k) = std::sin(12.9898 * (v + 1) + 78.233 * k) * (k == 2 ? 0.1 : 1);
    return points;
}

std::vector<std::pair<int, double>> by_looking_at_all(const Points& points, const Eigen::Vector3d& place, int count) {
    std::vector<std::pair<int, double>> all;
    for (int v = 0; v < points.rows(); ++v) all.emplace_back(v, (points.row(v).transpose() - place).squaredNorm());
    std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.second != b.second ? a.second < b.second : a.first < b.first; });
    all.resize(std::min<std::size_t>(all.size(), static_cast<std::size_t>(count)));
    return all;
}

} // namespace

TEST_CASE("the nearest points are those that a look at all of them finds") {
    Points points = scattered(700);
    points.bottomRows(60) = points.topRows(60); // ties
    const PointTree tree(points);
    std::vector<std::pair<int, double>> found;
    for (int v = 0; v < points.rows(); v += 7) {
        const Eigen::Vector3d place = points.row(v) * (v % 2 == 0 ? 1.0 : 1.7);
        for (const int count : {1, 5, 18, 900}) {
            tree.nearest(place, count, found);
            CHECK(found == by_looking_at_all(points, place, count));
        }
    }
}

TEST_CASE("points in one place, and none at all, end") {
    const Points same = Points::Constant(50, 3, 0.25);
    std::vector<std::pair<int, double>> found;
    PointTree(same).nearest({0, 0, 0}, 3, found);
    REQUIRE(found.size() == 3);
    CHECK(found[2].first == 2);
    const Points none(0, 3);
    PointTree(none).nearest({0, 0, 0}, 3, found);
    CHECK(found.empty());
}
