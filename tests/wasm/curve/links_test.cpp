#include "lissom/curve/links.h"

#include "refusal.h"

#include <doctest/doctest.h>

using namespace lissom;

TEST_CASE("parents come before their children") {
    const std::vector<CurveLink> links{{0, 2, 0.5}, {2, 3, 1}, {4, 3, 0}};
    const LinkOrder order = link_order(5, links);
    CHECK(order.order == std::vector<int>{3, 2, 0, 1, 4});
    CHECK(order.link == std::vector<int>{0, -1, 1, -1, 2});
    CHECK(order.root == std::vector<int>{3, 1, 3, 3, 3});
    CHECK(order.linked == std::vector<bool>{true, false, true, true, true});
}

TEST_CASE("links that make no tree are refused") {
    const auto code = [](std::vector<CurveLink> links) { return refusal([&] { (void)link_order(3, links); }); };
    CHECK(code({{0, 1, 0}, {1, 2, 0}, {2, 0, 0}}) == "link-ring");
    CHECK(code({{0, 0, 0}}) == "link-ring");
    CHECK(code({{0, 1, 0}, {0, 2, 0}}) == "link-twice");
    CHECK(code({{0, 3, 0}}) == "link-range");
    CHECK(code({{-1, 1, 0}}) == "link-range");
    CHECK(code({{0, 1, 1.5}}) == "link-range");
    CHECK(code({}) == "none");
}
