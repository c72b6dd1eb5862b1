#include "lissom/hair/updatable_cholesky.h"

#include "lissom/mesh/errors.h"
#include "solve/matrices.h"

#include <doctest/doctest.h>

using namespace lissom;

namespace {

struct System {
    matrices::Grid grid = matrices::grid(8, 7, 6);
    SparseMatrix A = matrices::laplacian(static_cast<int>(grid.points.rows()), grid.edges, 0.01);
    SparseCholesky factor{A, &grid.points};

    System() { factor.factorize(A); }
    [[nodiscard]] SparseMatrix raised(const std::vector<int>& nodes, double square) const {
        SparseMatrix B = A;
        for (const int node : nodes) B.coeffRef(node, node) += square;
        return B;
    }
};

double residual(const UpdatableCholesky& factor, const SparseMatrix& A) {
    const Columns b = matrices::random_columns(static_cast<int>(A.rows()), 3, 8);
    Columns x = b;
    factor.solve(x);
    return (A * x - b).norm() / b.norm();
}

} // namespace

TEST_CASE("before any change it solves as the factor it was made of") {
    const System system;
    const UpdatableCholesky factor(system.factor);
    CHECK(factor.size() == system.A.rows());
    CHECK(factor.entries() >= static_cast<double>(system.A.nonZeros()) / 2);
    CHECK(residual(factor, system.A) < 1e-11);
}

TEST_CASE("weights put on a few nodes and on many at once are those of the matrix with them") {
    const System system;
    for (const int count : {1, 8, 9, 100}) { // eight are carried at once
        const std::vector<int> all = matrices::shuffled(static_cast<int>(system.A.rows()), 3), nodes(all.begin(), all.begin() + count);
        UpdatableCholesky factor(system.factor);
        factor.update(nodes, 10);
        CAPTURE(count);
        CHECK(residual(factor, system.raised(nodes, 100)) < 1e-10);
    }
}

TEST_CASE("weights taken off leave what was there before") {
    const System system;
    const std::vector<int> all = matrices::shuffled(static_cast<int>(system.A.rows()), 5), nodes(all.begin(), all.begin() + 40), some(all.begin() + 20, all.begin() + 30);
    UpdatableCholesky factor(system.factor);
    factor.update(nodes, 10);
    factor.downdate(some, 10);
    std::vector<int> left(all.begin(), all.begin() + 20);
    left.insert(left.end(), all.begin() + 30, all.begin() + 40);
    CHECK(residual(factor, system.raised(left, 100)) < 1e-9);
    factor.downdate(left, 10);
    CHECK(residual(factor, system.A) < 1e-7);
}

TEST_CASE("taking away more than is there is refused, not solved") {
    const System system;
    UpdatableCholesky factor(system.factor);
    CHECK_THROWS_AS(factor.downdate(std::vector<int>{17}, 10), SolverFailure);
}
