#include "lissom/hair/sparse_field.h"

#include "lissom/hair/dual_field.h"

#include <doctest/doctest.h>

#include <random>
#include <utility>

using namespace lissom;
using Eigen::Vector3d;

namespace {

const Eigen::Vector3i k_size{10, 9, 11};

std::vector<FieldConstraint> pool(int count, unsigned seed) {
    std::mt19937 random(seed);
    std::vector<char> taken(static_cast<std::size_t>(k_size.prod()), 0);
    std::vector<FieldConstraint> out;
    const auto part = [&] { return static_cast<double>(random() % 2001) / 1000 - 1; };
    while (static_cast<int>(out.size()) < count) {
        const std::size_t node = random() % taken.size();
        if (std::exchange(taken[node], 1)) continue;
        const double x = part(), y = part(), z = part();
        out.push_back({static_cast<int>(node), {x, y, z}});
    }
    return out;
}

double gap(const Points& a, const Points& b) { return (a - b).norm() / b.norm(); }

} // namespace

TEST_CASE("the thesis's system and the dual agree through hundreds of edits") {
    SparseField sparse(k_size);
    DualField dual(std::make_shared<GridBilaplacian>(k_size));
    const auto all = pool(240, 7);
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
    const auto all = pool(120, 3);
    sparse.set_constraints(std::span(all).first(80));
    sparse.set_constraints(std::span(all).last(90));
    const Points updated = sparse.field();
    sparse.refactor();
    CHECK(gap(updated, sparse.field()) < 1e-9);
}

TEST_CASE("without constraints there is no field, and it comes back with the first") {
    SparseField sparse(k_size);
    CHECK(sparse.field().norm() == 0);
    const auto all = pool(30, 9);
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
