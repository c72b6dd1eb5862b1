#include "lissom/hair/field_solver.h"

#include "refusal.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace lissom;

namespace {

std::vector<FieldConstraint> at(const std::vector<int>& nodes) {
    std::vector<FieldConstraint> out;
    for (const int node : nodes) out.push_back({node, {1, 0, 0}});
    return out;
}
ConstraintChange change(const std::vector<int>& held, const std::vector<int>& wanted) { return constraint_change(at(held), at(wanted), 10); }

} // namespace

TEST_CASE("what came and what went are told by their places") {
    const ConstraintChange both = change({3, 5, 7}, {5, 2, 9, 3});
    CHECK(both.added == std::vector<int>{1, 2});
    CHECK(both.removed == std::vector<int>{2});
    CHECK(change({}, {4, 1}).added == std::vector<int>{0, 1});
    CHECK(change({4, 1}, {}).removed == std::vector<int>{0, 1});
}

TEST_CASE("another order or another vector is no change of nodes") {
    CHECK(change({3, 5, 7}, {7, 3, 5}).added.empty());
    CHECK(change({3, 5, 7}, {7, 3, 5}).removed.empty());
    std::vector<FieldConstraint> turned = at({3, 5});
    turned[0].vector = {0, 2, 0};
    const ConstraintChange same = constraint_change(at({3, 5}), turned, 10);
    CHECK(same.added.empty());
    CHECK(same.removed.empty());
}

TEST_CASE("nodes that the grid lacks, repeated ones and vectors without numbers are refused") {
    const auto code = [](const std::vector<FieldConstraint>& wanted) { return refusal([&] { (void)constraint_change({}, wanted, 10); }); };
    CHECK(code(at({0, 9})) == "none");
    CHECK(code(at({10})) == "constraint-node");
    CHECK(code(at({-1})) == "constraint-node");
    CHECK(code(at({4, 4})) == "constraint-node");
    CHECK(code({{4, {0, NAN, 0}}}) == "constraint-node");
    CHECK(code({{4, {0, INFINITY, 0}}}) == "constraint-node");
}
