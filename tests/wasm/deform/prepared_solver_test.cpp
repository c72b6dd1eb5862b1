#include "lissom/deform/prepared_solver.h"

#include "lissom/mesh/errors.h"
#include "solve/matrices.h"

#include <doctest/doctest.h>

using namespace lissom;

namespace {

Eigen::SparseMatrix<double, Eigen::RowMajor> some_columns(int rows, int columns, std::uint32_t seed) {
    return Eigen::MatrixXd(matrices::random_columns(rows, columns, seed)).sparseView();
}

NormalEquations equations(const SparseMatrix& A, int handle_columns = 8) {
    return {SparseMatrix(A.triangularView<Eigen::Lower>()), some_columns(static_cast<int>(A.rows()), handle_columns, 9)};
}

void factor(PreparedSolver& solver) {
    double before = 0;
    while (solver.step()) {
        CHECK(!solver.ready());
        if (!solver.shifted()) CHECK(solver.fraction() >= before);
        before = solver.fraction();
    }
    CHECK(solver.ready());
}

} // namespace

TEST_CASE("what it solves is A x = b − G w") {
    const auto grid = matrices::grid(9, 7, 3);
    const SparseMatrix A = matrices::laplacian(static_cast<int>(grid.points.rows()), grid.edges, 0.1);
    const NormalEquations system = equations(A);
    PreparedSolver solver(system, grid.points);
    factor(solver);
    CHECK(!solver.shifted());
    CHECK(solver.work() > 0);
    CHECK(solver.memory_bytes() > 12.0 * static_cast<double>(system.G.nonZeros()));
    const Columns w = matrices::random_columns(8, 3, 4), b = matrices::random_columns(static_cast<int>(A.rows()), 3, 5);
    const Columns still = solver.solve(w), pulled = solver.solve(w, &b);
    CHECK((A * still + system.G * w).norm() < 1e-10);
    CHECK((A * pulled + system.G * w - b).norm() < 1e-10);
    CHECK((pulled - still - solver.solve(Columns::Zero(8, 3), &b)).norm() < 1e-10); // it is linear
    CHECK(solver.solve(Columns::Zero(8, 3)).norm() == 0);
}

TEST_CASE("a matrix that is almost positive definite is raised a little and says so") {
    const auto grid = matrices::grid(12, 10);
    const int n = static_cast<int>(grid.points.rows());
    const SparseMatrix A = matrices::laplacian(n, grid.edges, -1e-9); // constants have negative energy
    PreparedSolver solver(equations(A), grid.points);
    factor(solver);
    CHECK(solver.shifted());
    Columns b = matrices::random_columns(n, 3, 6);
    b.rowwise() -= b.colwise().mean().eval(); // what the shift does not matter to
    const Columns x = solver.solve(Columns::Zero(8, 3), &b);
    CHECK((A * x - b).norm() < 1e-5 * b.norm());
}

TEST_CASE("one that is not is refused rather than solved wrongly") {
    const auto grid = matrices::grid(12, 10);
    PreparedSolver solver(equations(matrices::laplacian(120, grid.edges, -1)), grid.points);
    CHECK_THROWS_AS(factor(solver), SolverFailure);
}

TEST_CASE("without unknowns there is nothing to solve") {
    PreparedSolver solver(equations(SparseMatrix(0, 0)), Points(0, 3));
    factor(solver);
    CHECK(solver.solve(matrices::random_columns(8, 3, 1)).rows() == 0);
}

TEST_CASE("where the normal equations lose more digits than there are, their rows give them back") {
    // Rows of very different lengths: squared, the short ones vanish beside the long ones.
    const int n = 60, columns = n + 8;
    for (const double least : {1e-2, 1e-6}) {
        EntryRows<1> rows;
        for (int i = 0; i <= n; ++i) {
            const double weight = i % 7 == 3 ? least : 1;
            for (const int k : {i - 1, i})
                if (k >= 0 && k < n) {
                    rows.columns.push_back(k);
                    rows.values.emplace_back((k == i ? 1 : -1) * weight);
                } else {
                    rows.columns.push_back(n + (k < 0 ? 3 : 7)); // the translations of two handles
                    rows.values.emplace_back((k < 0 ? -1 : 1) * weight);
                }
            rows.close_row();
        }
        const NormalEquations system = normal_equations(rows, rows, n, columns);
        Points line = Points::Zero(n, 3);
        line.col(0).setLinSpaced(0, 1);
        PreparedSolver solver(system, line);
        factor(solver);
        CHECK(solver.needs_rows() == (least < 1e-3));
        Columns w = Columns::Zero(8, 3);
        w.row(3) << 0.3, 0.5, -0.7;
        w.row(7) = w.row(3);
        const Columns all = w.row(3).replicate(n, 1); // what moves both ends moves everything
        const double before = (solver.solve(w) - all).cwiseAbs().maxCoeff();
        solver.refine_by(row_pair(rows, rows, n, columns));
        CHECK_FALSE(solver.needs_rows());
        const double after = (solver.solve(w) - all).cwiseAbs().maxCoeff();
        CHECK(after < 1e-9);
        if (least < 1e-3) CHECK(after < 1e-2 * before);
        CHECK(solver.solve(w) == solver.solve(w));
        CHECK((solver.solve(w, nullptr, false) - all).cwiseAbs().maxCoeff() == before);
        const Columns b = matrices::random_columns(n, 3, 5);
        const Columns pulled = solver.solve(Columns::Zero(8, 3), &b);
        const RowPair pair = row_pair(rows, rows, n, columns);
        Columns padded = Columns::Zero(columns, 3);
        padded.topRows(n) = pulled;
        CHECK((pair.left.transpose() * Columns(pair.right * padded) - b).norm() < 1e-6 * b.norm() * pulled.norm());
    }
}
