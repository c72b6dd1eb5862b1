#include "lissom/hair/iterative_field.h"

#include "hair/fields.h"
#include "lissom/hair/dual_field.h"

#include <doctest/doctest.h>

using namespace lissom;
using fields::some_constraints;

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
        CHECK(iterative.iterations() < 60);
        CHECK((a - b).norm() < 1e-8 * a.norm());
    }
}

TEST_CASE("it agrees on a crowded surface too, after every edit of a sequence") {
    const Eigen::Vector3i n(28, 30, 26);
    const auto K = std::make_shared<GridBilaplacian>(n);
    DualField dual(K);
    IterativeField iterative(K);
    std::vector<FieldConstraint> shell;
    for (int node = 0; node < n.prod(); ++node) {
        const Eigen::Vector3d p(node % n.x() - 13.5, node / n.x() % n.y() - 14.5, node / (n.x() * n.y()) - 12.5);
        if (std::abs(p.norm() - 8) < 0.9) shell.push_back({node, p.cross(Eigen::Vector3d(0.1, 1, 0.3)) / 8});
    }
    CHECK(shell.size() > 1200);
    for (std::uint64_t edit = 0; edit < 4; ++edit) {
        std::vector<FieldConstraint> some;
        for (std::size_t i = 0; i < shell.size(); ++i)
            if (chance(edit, i, 0) < 0.8) some.push_back(shell[i]);
        dual.set_constraints(some);
        iterative.set_constraints(some);
        CHECK(iterative.iterations() < 60);
        CHECK((dual.field() - iterative.field()).norm() < 1e-8 * dual.field().norm());
    }
}

TEST_CASE("a small change of many constraints takes fewer iterations than the first time, and none left is no field") {
    const auto K = std::make_shared<GridBilaplacian>(Eigen::Vector3i(16, 16, 16));
    IterativeField field(K);
    auto constraints = some_constraints(4096, 1500, 3);
    field.set_constraints(constraints);
    const int first = field.iterations();
    constraints[5].vector *= 1.01;
    field.set_constraints(constraints);
    CHECK(field.iterations() < first);
    field.set_constraints({});
    CHECK(field.field().norm() == 0);
}
