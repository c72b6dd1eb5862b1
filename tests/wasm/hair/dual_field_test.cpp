#include "lissom/hair/dual_field.h"

#include <doctest/doctest.h>

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <numeric>
#include <random>

using namespace lissom;
using Eigen::MatrixXd;
using Eigen::Vector3i;

namespace {

/// Δ of a grid as a sparse matrix: the oracle of everything here.
SparseMatrix grid_laplacian(const Grid& grid) {
    std::vector<Eigen::Triplet<double>> entries;
    for (int node = 0; node < grid.count(); ++node) {
        const Vector3i at = grid.cell(node);
        for (int d = 0; d < 3; ++d) {
            if (at[d] + 1 == grid.size[d]) continue;
            Vector3i next = at;
            ++next[d];
            const int other = grid.node(next[0], next[1], next[2]);
            entries.insert(entries.end(), {{node, node, -1 / 6.0}, {other, other, -1 / 6.0},
                                           {node, other, 1 / 6.0}, {other, node, 1 / 6.0}});
        }
    }
    SparseMatrix L(grid.count(), grid.count());
    L.setFromTriplets(entries.begin(), entries.end());
    return L;
}

std::vector<FieldConstraint> random_constraints(const Grid& grid, int count, unsigned seed) {
    std::mt19937 random(seed);
    std::vector<int> nodes(static_cast<std::size_t>(grid.count()));
    std::iota(nodes.begin(), nodes.end(), 0);
    std::vector<FieldConstraint> out;
    for (int i = 0; i < count; ++i) {
        std::swap(nodes[static_cast<std::size_t>(i)], nodes[i + random() % (nodes.size() - static_cast<std::size_t>(i))]);
        const auto part = [&] { return static_cast<double>(random() % 2001) / 1000 - 1; };
        const double x = part(), y = part(), z = part();
        out.push_back({nodes[static_cast<std::size_t>(i)], {x, y, z}});
    }
    return out;
}

Points sparse_solution(const Grid& grid, const std::vector<FieldConstraint>& constraints) {
    const SparseMatrix L = grid_laplacian(grid);
    SparseMatrix A = L.transpose() * L; // Eq 4.3
    MatrixXd b = MatrixXd::Zero(grid.count(), 3);
    const double w2 = FieldSolver::weight * FieldSolver::weight;
    for (const FieldConstraint& c : constraints) {
        A.coeffRef(c.node, c.node) += w2;
        b.row(c.node) += w2 * c.vector.transpose();
    }
    return Eigen::SimplicialLDLT<SparseMatrix>(A).solve(b);
}

double gap(const Points& a, const Points& b) { return (a - b).norm() / b.norm(); }

const Grid k_grid{{0, 0, 0}, 1, {9, 11, 8}};

} // namespace

TEST_CASE("the cosine basis inverts the squared grid Laplacian") {
    const GridBilaplacian K(k_grid.size);
    const SparseMatrix L = grid_laplacian(k_grid);
    MatrixXd f = MatrixXd::Random(k_grid.count(), 2);
    f.rowwise() -= f.colwise().mean().eval();
    CHECK((L * (L * K.apply_inverse(f)) - f).norm() < 1e-10 * f.norm());
}

TEST_CASE("Green's function by reflection is the inverse's own entry") {
    const GridBilaplacian K(k_grid.size);
    for (const int q : {0, 17, 402, k_grid.count() - 1}) {
        MatrixXd unit = MatrixXd::Zero(k_grid.count(), 1);
        unit(q, 0) = 1;
        const MatrixXd column = K.apply_inverse(unit);
        for (int p = 0; p < k_grid.count(); p += 13)
            CHECK(K.green(k_grid.cell(p), k_grid.cell(q)) == doctest::Approx(column(p, 0)).epsilon(1e-9));
    }
}

TEST_CASE("the dual field is the minimiser of the sparse system") {
    const auto K = std::make_shared<GridBilaplacian>(k_grid.size);
    for (const int m : {1, 2, 40, 200}) {
        CAPTURE(m);
        DualField dual(K);
        const auto constraints = random_constraints(k_grid, m, 5);
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
    const auto pool = random_constraints(k_grid, 300, 3);
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
    auto constraints = random_constraints(k_grid, 50, 8);
    dual.set_constraints(constraints);
    for (FieldConstraint& c : constraints) c.vector = 2 * c.vector.reverse().eval();
    const Points before = dual.field();
    dual.set_constraints(constraints);
    CHECK(gap(dual.field(), 2 * before.rowwise().reverse()) < 1e-10);
}

TEST_CASE("a factor that lost rows is the factor of what is left") {
    std::srand(4);
    const MatrixXd B = MatrixXd::Random(220, 220);
    const MatrixXd H = B * B.transpose() + MatrixXd::Identity(220, 220);
    for (const std::vector<int>& gone : {std::vector<int>{0}, {219}, {3, 4, 5, 100, 150}, {0, 50, 219}}) {
        IncrementalCholesky factor;
        factor.append(MatrixXd(100, 0), H.topLeftCorner(100, 100));
        factor.append(H.block(100, 0, 120, 100), H.bottomRightCorner(120, 120));
        factor.remove(gone);
        std::vector<int> kept;
        for (int i = 0; i < 220; ++i)
            if (std::find(gone.begin(), gone.end(), i) == gone.end()) kept.push_back(i);
        const MatrixXd left = H(kept, kept), b = MatrixXd::Random(static_cast<Eigen::Index>(kept.size()), 2);
        MatrixXd x = b;
        factor.solve(x);
        CHECK((left * x - b).norm() < 1e-9 * b.norm());
    }
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
