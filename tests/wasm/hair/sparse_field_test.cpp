#include "lissom/hair/sparse_field.h"

#include "hair/fields.h"
#include "lissom/hair/dual_field.h"

#include <doctest/doctest.h>

#include <random>

using namespace lissom;
using fields::gap;
using fields::some_constraints;

namespace {

const Eigen::Vector3i k_size{10, 9, 11};

} // namespace

TEST_CASE("the thesis's system and the dual agree through hundreds of edits") {
    SparseField sparse(k_size);
    DualField dual(std::make_shared<GridBilaplacian>(k_size));
    const auto all = some_constraints(k_size.prod(), 240, 7);
    std::mt19937 random(2);
    std::vector<char> in(all.size(), 0);
    for (int edit = 0; edit < 250; ++edit) {
        const std::size_t from = random() % all.size(), count = 1 + random() % 25;
        for (std::size_t i = from; i < std::min(all.size(), from + count); ++i) in[i] = static_cast<char>(random() % 3 != 0);
        std::vector<FieldConstraint> wanted;
        for (std::size_t i = 0; i < all.size(); ++i)
            if (in[i]) wanted.push_back(all[i]);
        sparse.set_constraints(wanted);
        dual.set_constraints(wanted);
        if (edit % 10 != 9 || wanted.empty()) continue;
        CAPTURE(edit);
        CHECK(sparse.residual() < 1e-8);
        CHECK(gap(sparse.field(), dual.field()) < 1e-6);
    }
}

TEST_CASE("an updated factor gives what a new one gives") {
    SparseField sparse(k_size);
    const auto all = some_constraints(k_size.prod(), 120, 3);
    sparse.set_constraints(std::span(all).first(80));
    sparse.set_constraints(std::span(all).last(90));
    const Points updated = sparse.field();
    sparse.refactor();
    CHECK(gap(updated, sparse.field()) < 1e-9);
}

TEST_CASE("without constraints there is no field, and it comes back with the first") {
    SparseField sparse(k_size);
    CHECK(sparse.field().norm() == 0);
    const auto all = some_constraints(k_size.prod(), 30, 9);
    sparse.set_constraints(all);
    const Points before = sparse.field();
    sparse.set_constraints({});
    CHECK(sparse.field().norm() == 0);
    CHECK(sparse.constraint_count() == 0);
    sparse.set_constraints(std::span(all).first(1));
    CHECK((sparse.field().rowwise() - all[0].vector.transpose()).norm() < 1e-6 * std::sqrt(k_size.prod()));
    sparse.set_constraints(all);
    CHECK(gap(sparse.field(), before) < 1e-7);
}
