#include "lissom/merge/boundary_correspondence.h"

#include "refusal.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

using namespace lissom;

namespace {

using Keys = std::vector<std::pair<int, int>>;

/// A loop of n points without any symmetry, `start` of its length from the first.
Points wavy(int n, double start = 0) {
    Points points(n, 3);
    for (int k = 0; k < n; ++k) {
        const double a = 2 * std::numbers::pi * (static_cast<double>(k) / n + start), r = 1 + 0.3 * std::cos(a) + 0.1 * std::sin(2 * a);
        points.row(k) << r * std::cos(a), 0.2 * std::sin(3 * a), r * std::sin(a);
    }
    return points;
}
std::vector<int> forwards(int n) {
    std::vector<int> loop(static_cast<std::size_t>(n));
    std::iota(loop.begin(), loop.end(), 0);
    return loop;
}
std::vector<int> backwards(int n) {
    std::vector<int> loop = forwards(n);
    std::reverse(loop.begin(), loop.end());
    return loop;
}

LoopMatch match(const Points& source, const Points& target, const Keys& keys) {
    return match_loops(source, forwards(static_cast<int>(source.rows())), target, backwards(static_cast<int>(target.rows())), keys);
}

/// Every vertex of both loops in exactly one point, in the loops' order from the first key on.
void check_whole(const LoopMatch& found) {
    std::vector<int> source, target;
    for (const SeamPoint& point : found.points) {
        CHECK((point.source >= 0 || point.target >= 0));
        if (point.source >= 0) source.push_back(point.source);
        if (point.target >= 0) target.push_back(point.target);
        CHECK((point.source_fraction >= 0 && point.source_fraction <= 1));
        CHECK((point.target_fraction >= 0 && point.target_fraction <= 1));
    }
    CHECK(source.size() == found.source.size());
    CHECK(target.size() == found.target.size());
    for (std::vector<int>* places : {&source, &target}) { // ascending but for one jump, where the loop closes
        int falls = 0;
        for (std::size_t k = 1; k < places->size(); ++k) falls += (*places)[k] < (*places)[k - 1];
        CHECK(falls <= 1);
        std::sort(places->begin(), places->end());
        for (std::size_t k = 0; k < places->size(); ++k) CHECK((*places)[k] == static_cast<int>(k));
    }
}

} // namespace

TEST_CASE("equal loops are matched vertex for vertex") {
    const LoopMatch found = match(wavy(30), wavy(30), {{7, 7}});
    CHECK(found.points.size() == 30);
    for (const SeamPoint& point : found.points) CHECK(found.source[point.source] == found.target[point.target]);
    CHECK(found.source.front() == 7);
}

TEST_CASE("loops of any two sizes are matched whole, keys to keys") {
    for (const auto& [n, m] : {std::pair{20, 31}, {31, 20}, {3, 50}, {50, 3}, {24, 24}}) {
        CAPTURE(n);
        CAPTURE(m);
        const Keys keys{{0, 1 % m}, {n / 3, (m / 3 + 1) % m}, {2 * n / 3, (2 * m / 3 + 1) % m}};
        const LoopMatch found = match(wavy(n), wavy(m, 0.4), keys);
        check_whole(found);
        CHECK(static_cast<int>(found.points.size()) >= std::max(n, m));
        for (const auto& [s, t] : keys)
            CHECK(std::count_if(found.points.begin(), found.points.end(), [&](const SeamPoint& p) {
                      return p.source >= 0 && p.target >= 0 && found.source[p.source] == s && found.target[p.target] == t;
                  }) == 1);
    }
}

TEST_CASE("between two keys partners lie at the same share of the length") {
    Points square(4, 3), fine(40, 3);
    square << 0, 0, 0, 1, 0, 0, 1, 0, 1, 0, 0, 1;
    for (int k = 0; k < 40; ++k) {
        const int side = k / 10;
        fine.row(k) = square.row(side) + (k % 10) / 10.0 * (square.row((side + 1) % 4) - square.row(side));
    }
    const LoopMatch found = match(square, fine, {{0, 0}});
    check_whole(found);
    for (int i = 0; i < 4; ++i) {
        const auto [edge, fraction] = found.at_target[i];
        CHECK(edge + fraction == doctest::Approx(10 * i).epsilon(1e-9));
    }
    for (const SeamPoint& point : found.points)
        if (point.source < 0) {
            const int at = found.target[point.target]; // lies so far along the square's side
            CHECK(found.source[point.source_edge] == at / 10);
            CHECK(point.source_fraction == doctest::Approx(at % 10 / 10.0));
        }
}

TEST_CASE("the pose and the unit of either loop do not matter") {
    const LoopMatch here = match(wavy(20), wavy(33, 0.2), {{3, 5}});
    for (const double unit : {1e-6, 1e6}) {
        const LoopMatch there = match(unit * wavy(20), wavy(33, 0.2), {{3, 5}});
        REQUIRE(there.points.size() == here.points.size());
        for (std::size_t k = 0; k < here.points.size(); ++k) {
            CHECK(there.points[k].source == here.points[k].source);
            CHECK(there.points[k].target == here.points[k].target);
            CHECK(there.points[k].target_fraction == doctest::Approx(here.points[k].target_fraction));
        }
    }
}

TEST_CASE("keys that make no sense are refused by name") {
    const auto code = [](const Keys& keys) { return refusal([&] { (void)match(wavy(20), wavy(30), keys); }); };
    CHECK(code({{0, 0}, {5, 8}, {10, 16}}) == "none");
    CHECK(code({{10, 16}, {0, 0}, {5, 8}}) == "none"); // in any order
    CHECK(code({}) == "no-key");
    CHECK(code({{20, 0}}) == "key-not-on-boundary");
    CHECK(code({{0, 30}}) == "key-not-on-boundary");
    CHECK(code({{0, 0}, {0, 8}}) == "key-repeated");
    CHECK(code({{0, 0}, {5, 0}}) == "key-repeated");
    CHECK(code({{0, 0}, {5, 8}, {10, 22}, {15, 15}}) == "keys-out-of-order");
    CHECK(code({{0, 0}, {5, 22}, {10, 15}, {15, 8}}) == k_keys_reversed);
}

TEST_CASE("partners one by one are the first of both and then each the next, the target's backwards") {
    const LoopMatch found = match_one_by_one({4, 5, 6, 7}, {10, 13, 12, 11});
    CHECK(found.source == std::vector<int>{4, 5, 6, 7});
    CHECK(found.target == std::vector<int>{10, 11, 12, 13});
    check_whole(found);
    for (int i = 0; i < 4; ++i) CHECK(found.at_target[i] == std::pair(i, 0.0));
}

TEST_CASE("the key found is the one under which the loops fit, wherever the target begins") {
    const int n = 60;
    for (const int start : {0, 11, 42}) {
        Points target(n, 3); // vertex (k + start) of the target lies where vertex k of the source does, moved and grown
        const Eigen::AngleAxisd turn(1.2, Eigen::Vector3d(1, 2, 3).normalized());
        for (int k = 0; k < n; ++k) target.row((k + start) % n) = 7 * (turn * Eigen::Vector3d(wavy(n).row(k))).transpose() + Eigen::RowVector3d(1, 2, 3);
        CHECK(best_key(wavy(n), forwards(n), target, backwards(n)) == std::pair(0, start));
    }
}
