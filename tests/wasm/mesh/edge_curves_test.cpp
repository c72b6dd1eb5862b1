#include "lissom/mesh/edge_curves.h"

#include "refusal.h"

#include <doctest/doctest.h>

#include <set>

using namespace lissom;
using Chain = std::vector<int>;

TEST_CASE("edges are chained between vertices where other than two meet") {
    // A path 0-1-2-3 with a branch 1-4, and a loop 5-6-7.
    const auto curves = chained(8, {{1, 0}, {1, 2}, {3, 2}, {4, 1}, {5, 6}, {7, 6}, {5, 7}});
    REQUIRE(curves.size() == 4);
    CHECK(curves[0].vertices == Chain{0, 1});
    CHECK(curves[1].vertices == Chain{1, 2, 3});
    CHECK(curves[2].vertices == Chain{1, 4});
    CHECK(curves[3].vertices == Chain{5, 6, 7});
    CHECK(curves[3].closed);
    CHECK_FALSE(curves[1].closed);
}

TEST_CASE("flagged vertices are corners, and a loop with one corner begins there") {
    const auto cut = chained(4, {{0, 1}, {1, 2}, {2, 3}}, {0, 0, 1, 0});
    REQUIRE(cut.size() == 2);
    CHECK(cut[0].vertices == Chain{0, 1, 2});
    CHECK(cut[1].vertices == Chain{2, 3});
    const auto loop = chained(4, {{0, 1}, {1, 2}, {2, 3}, {3, 0}}, {0, 0, 1, 0});
    REQUIRE(loop.size() == 1);
    CHECK(loop[0].vertices.front() == 2);
    CHECK(loop[0].closed);
    CHECK(loop[0].vertices.size() == 4);
}

TEST_CASE("edges of a curve are neither swapped nor split, and of two tied vertices neither goes") { // Criteria 4 to 7
    const EdgeCurves curves(8, {{{0, 1, 2, 3}}}, {5});
    CHECK_FALSE(curves.may_swap(1, 2));
    CHECK_FALSE(curves.may_split(2, 1));
    CHECK(curves.may_swap(0, 2));
    CHECK(curves.may_split(1, 6));
    CHECK_FALSE(curves.may_collapse(1, 2).allowed);
    CHECK_FALSE(curves.may_collapse(0, 2).allowed);
    CHECK_FALSE(curves.may_collapse(1, 5).allowed);
    CHECK(curves.may_collapse(6, 1).kept == 1);
    CHECK(curves.may_collapse(5, 6).kept == 5);
    CHECK(curves.may_collapse(6, 7).allowed);
    CHECK(curves.may_collapse(6, 7).kept == -1);
    CHECK(curves.is_corner(0));
    CHECK(curves.is_corner(5));
    CHECK_FALSE(curves.is_corner(1));
    CHECK(curves.tied(1));
    CHECK_FALSE(curves.tied(6));
}

TEST_CASE("where curves may be edited they go on through splits and collapses, their corners stay") {
    EdgeCurves curves(6, {{{0, 1, 2}}, {{3, 4, 5}, true}}, {}, EdgeCurves::Along::edited);
    REQUIRE(curves.may_split(0, 1));
    curves.split(0, 1, 6);
    curves.split(5, 3, 7);
    curves.split(0, 4, 8); // of no curve
    CHECK(curves.curves()[0].vertices == Chain{0, 6, 1, 2});
    CHECK(curves.curves()[1].vertices == Chain{3, 4, 5, 7});
    CHECK_FALSE(curves.has_edge(0, 1));
    CHECK(curves.has_edge(6, 1));
    CHECK(curves.has_edge(3, 7));
    CHECK_FALSE(curves.tied(8));
    CHECK(curves.may_collapse(0, 6).kept == 0);
    CHECK(curves.may_collapse(2, 1).kept == 2);
    CHECK_FALSE(curves.may_collapse(0, 1).allowed); // both on it, but not along it
    CHECK_FALSE(curves.may_collapse(1, 3).allowed);
    curves.collapse(0, 6);
    curves.collapse(0, 1);
    CHECK(curves.curves()[0].vertices == Chain{0, 2});
    CHECK_FALSE(curves.may_collapse(0, 2).allowed);
    curves.collapse(3, 7);
    CHECK_FALSE(curves.may_collapse(3, 4).allowed); // three are the least of a loop
    CHECK(curves.curves()[1].vertices == Chain{3, 4, 5});
    curves.renumber({0, -1, 1, 2, 3, 4, -1, -1, 5}, 6);
    CHECK(curves.curves()[0].vertices == Chain{0, 1});
    CHECK(curves.has_edge(2, 4));
    CHECK(curves.vertex_count() == 6);
}

TEST_CASE("curves of different models may cross, and where they do a vertex of both stays") {
    const EdgeCurves curves(6, {{{0, 1, 2}}, {{3, 1, 4}, false, 1}}, {}, EdgeCurves::Along::edited);
    CHECK_FALSE(curves.is_corner(1));
    CHECK(curves.through(1) == Chain{0, 1});
    CHECK_FALSE(curves.may_collapse(0, 1).allowed);
    CHECK(EdgeCurves(6, {{{0, 1, 2}}, {{3, 1, 4}}}).is_corner(1));
}

TEST_CASE("curves that are none are refused") {
    CHECK(refusal([] { EdgeCurves(3, {{{0}}}); }) == "bad-curve");
    CHECK(refusal([] { EdgeCurves(3, {{{0, 1}, true}}); }) == "bad-curve");
    CHECK(refusal([] { EdgeCurves(3, {{{0, 3}}}); }) == "bad-curve");
    CHECK(refusal([] { EdgeCurves(3, {{{0, 1, 0}}}); }) == "bad-curve");
    CHECK(refusal([] { EdgeCurves(3, {}, {3}); }) == "bad-curve");
}
