#include "lissom/hair/dual_field.h"

#include "hair/fields.h"

#include <doctest/doctest.h>

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <random>

using namespace lissom;
using Eigen::MatrixXd;
using fields::gap;
using fields::some_constraints;

namespace {

Points sparse_solution(const Grid& grid, const std::vector<FieldConstraint>& constraints) {
    const SparseMatrix L = fields::grid_laplacian(grid);
    SparseMatrix A = L.transpose() * L; // Eq 4.3
    MatrixXd b = MatrixXd::Zero(grid.count(), 3);
    const double w2 = FieldSolver::weight * FieldSolver::weight;
    for (const FieldConstraint& c : constraints) {
        A.coeffRef(c.node, c.node) += w2;
        b.row(c.node) += w2 * c.vector.transpose();
    }
    return Eigen::SimplicialLDLT<SparseMatrix>(A).solve(b);
}

const Grid k_grid{{0, 0, 0}, 1, {9, 11, 8}};

} // namespace

TEST_CASE("the dual field is the minimiser of the sparse system") {
    const auto K = std::make_shared<GridBilaplacian>(k_grid.size);
    for (const int m : {1, 2, 40, 200}) {
        CAPTURE(m);
        DualField dual(K);
        const auto constraints = some_constraints(k_grid.count(), m, 5);
        dual.set_constraints(constraints);
        const Points field = dual.field();
        CHECK(gap(field, sparse_solution(k_grid, constraints)) < 1e-8);
        std::vector<int> some{3, 99, 500};
        const Points at = dual.field_at(some);
        for (int i = 0; i < 3; ++i) CHECK((at.row(i) - field.row(some[static_cast<std::size_t>(i)])).norm() < 1e-10);
    }
}

TEST_CASE("hundreds of random edits leave no drift, and taking everything away leaves no field") {
    const auto K = std::make_shared<GridBilaplacian>(k_grid.size);
    DualField dual(K);
    std::mt19937 random(11);
    const auto pool = some_constraints(k_grid.count(), 300, 3);
    std::vector<char> in(pool.size(), 0);
    for (int edit = 0; edit < 300; ++edit) {
        const std::size_t from = random() % pool.size(), count = 1 + random() % 30;
        for (std::size_t i = from; i < std::min(pool.size(), from + count); ++i) in[i] = static_cast<char>(random() % 3 != 0);
        std::vector<FieldConstraint> wanted;
        for (std::size_t i = 0; i < pool.size(); ++i)
            if (in[i]) wanted.push_back(pool[i]);
        dual.set_constraints(wanted);
        CHECK(dual.residual() < 1e-8);
    }
    std::vector<FieldConstraint> last;
    for (std::size_t i = 0; i < pool.size(); ++i)
        if (in[i]) last.push_back(pool[i]);
    CHECK(gap(dual.field(), sparse_solution(k_grid, last)) < 1e-8);
    dual.set_constraints({});
    CHECK(dual.constraint_count() == 0);
    CHECK(dual.field().norm() == 0);
}

TEST_CASE("a change of vectors alone keeps the factor and moves the field") {
    const auto K = std::make_shared<GridBilaplacian>(k_grid.size);
    DualField dual(K);
    auto constraints = some_constraints(k_grid.count(), 50, 8);
    dual.set_constraints(constraints);
    for (FieldConstraint& c : constraints) c.vector = 2 * c.vector.reverse().eval();
    const Points before = dual.field();
    dual.set_constraints(constraints);
    CHECK(gap(dual.field(), 2 * before.rowwise().reverse()) < 1e-10);
}

TEST_CASE("constraints outside the grid, given twice or not finite are refused by name") {
    const auto K = std::make_shared<GridBilaplacian>(k_grid.size);
    DualField dual(K);
    const Eigen::Vector3d up(0, 1, 0);
    CHECK_THROWS_WITH(dual.set_constraints(std::vector<FieldConstraint>{{k_grid.count(), up}}),
                      "constraint 0 names node 792, which the grid does not have");
    CHECK_THROWS(dual.set_constraints(std::vector<FieldConstraint>{{4, up}, {4, up}}));
    CHECK_THROWS(dual.set_constraints(std::vector<FieldConstraint>{{4, up * NAN}}));
    CHECK(dual.constraint_count() == 0);
}
