#include "lissom/hair/iterative_field.h"

#include "lissom/hair/dual_field.h"
#include "lissom/hair/strand_hash.h"

#include <doctest/doctest.h>

using namespace lissom;

namespace {

std::vector<FieldConstraint> some_constraints(int nodes, int count, std::uint64_t seed) {
    std::vector<FieldConstraint> out;
    std::vector<char> taken(static_cast<std::size_t>(nodes), 0);
    for (std::uint64_t i = 0; static_cast<int>(out.size()) < count; ++i) {
        const int node = static_cast<int>(chance(seed, i, 0) * nodes);
        if (taken[static_cast<std::size_t>(node)]++) continue;
        out.push_back({node, {chance(seed, i, 1) - 0.5, chance(seed, i, 2) - 0.5, chance(seed, i, 3) - 0.5}});
    }
    return out;
}

} // namespace

TEST_CASE("conjugate gradients and the dual's factor find the same field") {
    const auto K = std::make_shared<GridBilaplacian>(Eigen::Vector3i(14, 18, 11));
    DualField dual(K);
    IterativeField iterative(K);
    for (const int count : {1, 40, 600}) {
        const auto constraints = some_constraints(14 * 18 * 11, count, 7);
        dual.set_constraints(constraints);
        iterative.set_constraints(constraints);
        const Points a = dual.field(), b = iterative.field();
        CAPTURE(count);
        CAPTURE(iterative.iterations());
        CHECK((a - b).norm() < 1e-6 * a.norm());
    }
}

TEST_CASE("a small change of many constraints takes fewer iterations than the first time, and none left is no field") {
    const auto K = std::make_shared<GridBilaplacian>(Eigen::Vector3i(16, 16, 16));
    IterativeField field(K);
    auto constraints = some_constraints(4096, 300, 3);
    field.set_constraints(constraints);
    const int first = field.iterations();
    constraints[5].vector *= 1.01;
    field.set_constraints(constraints);
    CHECK(field.iterations() < first);
    field.set_constraints({});
    CHECK(field.field().norm() == 0);
}
