#include "lissom/solve/sparse_cholesky.h"

#include "lissom/mesh/errors.h"
#include "matrices.h"

#include <Eigen/SparseCholesky>
#include <doctest/doctest.h>

#include <limits>
#include <string>

using namespace lissom;
using namespace lissom::matrices;

namespace {

Columns solved(const SparseCholesky& cholesky, Columns B) {
    cholesky.solve(B);
    return B;
}

Columns solved(const SparseMatrix& A, const Columns& B, const Points* coordinates = nullptr) {
    SparseCholesky cholesky(A, coordinates);
    cholesky.factorize(A);
    return solved(cholesky, B);
}

double residual(const SparseMatrix& A, const Columns& X, const Columns& B) { return (A * X - B).norm() / B.norm(); }

/// Solves with and without Eigen; both must agree to the accuracy that the matrix allows.
void check_against_eigen(const SparseMatrix& A, const Points* coordinates = nullptr) {
    const Columns B = random_columns(static_cast<int>(A.rows()), 3, 5);
    const Columns X = solved(A, B, coordinates);
    const Eigen::SimplicialLDLT<SparseMatrix> eigen(A);
    const Columns Y = eigen.solve(Eigen::MatrixXd(B));
    CHECK(residual(A, X, B) < 10 * residual(A, Y, B) + 1e-14);
    CHECK((X - Y).norm() <= 1e-8 * Y.norm());
}

std::string failure_of(const SparseMatrix& A) {
    try {
        SparseCholesky(A).factorize(A);
    } catch (const SolverFailure& failure) {
        return failure.what();
    }
    return "";
}

} // namespace

TEST_CASE("it agrees with a simplicial factorization on random normal matrices") {
    for (const int n : {2, 3, 5, 17, 64, 65, 200, 700})
        for (const int per_row : {1, 2, 4}) {
            CAPTURE(n);
            CAPTURE(per_row);
            check_against_eigen(random_normal(2 * n, n, per_row, 0.1, n + per_row));
        }
}

TEST_CASE("it agrees with a simplicial factorization on grids, whichever order is taken") {
    for (const Grid& g : {grid(40, 31), grid(500, 2), grid(9, 8, 11), grid(1, 1, 300)}) {
        const SparseMatrix A = laplacian(static_cast<int>(g.points.rows()), g.edges, 1e-3);
        check_against_eigen(A);
        check_against_eigen(A, &g.points);
        const SparseMatrix squared = A * A;
        check_against_eigen(squared);
        check_against_eigen(squared, &g.points);
    }
}

TEST_CASE("one number, a diagonal and a full matrix are matrices too") {
    SparseMatrix one(1, 1);
    one.insert(0, 0) = 4;
    Columns B(1, 1);
    B << 2;
    CHECK(solved(one, B)(0, 0) == 0.5);

    check_against_eigen(laplacian(90, {}, 3)); // no edges: 3 I
    for (const int n : {2, 3, 4, 5, 63, 64, 65, 66, 130, 200}) {
        CAPTURE(n);
        Eigen::MatrixXd full = random_columns(n, n, n);
        full = full * full.transpose() + Eigen::MatrixXd::Identity(n, n);
        check_against_eigen(full.sparseView());
    }
}

TEST_CASE("nothing to solve is solved") {
    const SparseMatrix A(0, 0);
    SparseCholesky cholesky(A);
    cholesky.factorize(A);
    Columns B(0, 3);
    CHECK_NOTHROW(cholesky.solve(B));
    CHECK(cholesky.fraction() == 1);
}

TEST_CASE("separate pieces do not disturb each other") {
    const Grid g = grid(20, 20);
    std::vector<std::pair<int, int>> edges = g.edges;
    for (const auto& [a, b] : g.edges)
        edges.emplace_back(a + 400, b + 400);
    const SparseMatrix one = laplacian(400, g.edges, 0.1), two = laplacian(810, edges, 0.1);
    const Columns B = random_columns(400, 2, 1);
    Columns both = Columns::Zero(810, 2);
    both.topRows(400) = B;
    both.middleRows(400, 400) = B;
    const Columns X = solved(two, both);
    CHECK((X.topRows(400) - solved(one, B)).norm() < 1e-11 * X.norm());
    CHECK((X.middleRows(400, 400) - X.topRows(400)).norm() < 1e-11 * X.norm());
    CHECK(X.bottomRows(10).norm() == 0);
    Points points = Points::Zero(810, 3); // all in one place: nowhere to cut
    CHECK((solved(two, both, &points) - X).norm() < 1e-11 * X.norm());
}

TEST_CASE("renumbering the unknowns renumbers the solution") {
    const Grid g = grid(25, 30);
    const int n = static_cast<int>(g.points.rows());
    const SparseMatrix A = laplacian(n, g.edges, 1e-2);
    const std::vector<int> to = shuffled(n, 3);
    const Columns B = random_columns(n, 3, 9);
    Columns B_renumbered(n, 3);
    for (int i = 0; i < n; ++i)
        B_renumbered.row(to[i]) = B.row(i);
    const Columns X = solved(A, B), Y = solved(renumbered(A, to), B_renumbered);
    for (int i = 0; i < n; ++i)
        CHECK((X.row(i) - Y.row(to[i])).norm() < 1e-10 * X.norm());
}

TEST_CASE("only the lower triangle is read") {
    const SparseMatrix A = random_normal(200, 120, 3, 0.5, 8);
    const SparseMatrix lower = A.triangularView<Eigen::Lower>();
    const Columns B = random_columns(120, 1, 2);
    CHECK(solved(lower, B) == solved(A, B));
}

TEST_CASE("the slices of a factorization do not change a bit of it") {
    const Grid g = grid(70, 60);
    SparseMatrix A = laplacian(static_cast<int>(g.points.rows()), g.edges, 1e-2);
    A = A * A;
    const Columns B = random_columns(static_cast<int>(A.rows()), 3, 4);
    SparseCholesky whole(A, &g.points), sliced(A, &g.points);
    whole.factorize(A);
    for (const double work : {1.0, 1e4, 3e5}) {
        CAPTURE(work);
        sliced.begin(A);
        CHECK(sliced.fraction() == 0);
        double last = 0;
        int slices = 0;
        while (sliced.step(work)) {
            CHECK(sliced.fraction() >= last);
            CHECK(sliced.fraction() <= 1);
            last = sliced.fraction();
            ++slices;
        }
        CHECK(slices > 3);
        CHECK(sliced.fraction() == 1);
        CHECK(solved(sliced, B) == solved(whole, B));
    }
}

TEST_CASE("a column is solved alike alone and among others") {
    const SparseMatrix A = random_normal(900, 500, 3, 0.2, 6);
    SparseCholesky cholesky(A);
    cholesky.factorize(A);
    const Columns B = random_columns(500, 7, 3);
    for (const int k : {1, 2, 3, 4, 7}) {
        CAPTURE(k);
        const Columns X = solved(cholesky, B.leftCols(k));
        for (int j = 0; j < k; ++j)
            CHECK((X.col(j) - solved(cholesky, B.col(j))).norm() <= 1e-14 * X.col(j).norm());
    }
}

TEST_CASE("minimum degree and nested dissection give the same solution") {
    const Grid g = grid(60, 60);
    SparseMatrix A = laplacian(3600, g.edges, 1e-2);
    A = A * A;
    SparseCholesky degree(A), dissection(A, &g.points);
    REQUIRE(degree.ordering() == std::string("minimum-degree"));
    REQUIRE(dissection.ordering() == std::string("nested-dissection"));
    CHECK(dissection.factor_work() > 0);
    degree.factorize(A);
    dissection.factorize(A);
    const Columns B = random_columns(3600, 3, 11);
    CHECK((solved(degree, B) - solved(dissection, B)).norm() < 1e-9 * solved(degree, B).norm());
}

TEST_CASE("coordinates that are not finite do no harm") {
    Grid g = grid(30, 30);
    const SparseMatrix A = laplacian(900, g.edges, 1e-2);
    const Columns B = random_columns(900, 1, 11);
    g.points.row(17).setConstant(std::numeric_limits<double>::quiet_NaN());
    g.points(400, 1) = std::numeric_limits<double>::infinity();
    CHECK(residual(A, solved(A, B, &g.points), B) < 1e-12);
    g.points.setConstant(1e308);
    CHECK(residual(A, solved(A, B, &g.points), B) < 1e-12);
}

TEST_CASE("new values need no new analysis, and old ones come back to the bit") {
    const Grid g = grid(40, 40);
    const SparseMatrix A = laplacian(1600, g.edges, 1e-2), A2 = laplacian(1600, g.edges, 5) * 3.0;
    const Columns B = random_columns(1600, 3, 12);
    SparseCholesky cholesky(A);
    cholesky.factorize(A);
    const double entries = cholesky.factor_entries();
    const Columns X = solved(cholesky, B);
    cholesky.factorize(A2);
    CHECK(residual(A2, solved(cholesky, B), B) < 1e-13);
    cholesky.factorize(A);
    CHECK(solved(cholesky, B) == X);
    CHECK(cholesky.factor_entries() == entries);

    SparseCholesky moved = std::move(cholesky);
    CHECK(solved(moved, B) == X);
}

TEST_CASE("a pivot that is not positive is named by its own column") {
    SparseMatrix A = laplacian(50, {}, 1);
    A.coeffRef(31, 31) = -2.5;
    CHECK(failure_of(A) == "the matrix is not positive definite: pivot -2.5 in column 31 (matrix of 50 columns)");
    A.coeffRef(31, 31) = 0;
    CHECK(failure_of(A).find("pivot 0 in column 31") != std::string::npos);

    const Grid g = grid(20, 20);
    SparseMatrix deep = laplacian(400, g.edges, 1e-2);
    deep.coeffRef(210, 210) = -1;
    CHECK(failure_of(deep).find("not positive definite") != std::string::npos);

    SparseMatrix no_diagonal(2, 2);
    no_diagonal.insert(0, 0) = 1;
    CHECK(failure_of(no_diagonal).find("column 1") != std::string::npos);
}

TEST_CASE("after a failure the next matrix is welcome") {
    const Grid g = grid(30, 30);
    const SparseMatrix good = laplacian(900, g.edges, 1e-2);
    SparseMatrix bad = good;
    bad.coeffRef(444, 444) = -7;
    SparseCholesky cholesky(good);
    CHECK_THROWS_AS(cholesky.factorize(bad), SolverFailure);
    Columns B = random_columns(900, 2, 2);
    CHECK_THROWS_AS(cholesky.solve(B), SolverFailure);
    CHECK_FALSE(cholesky.step());
    cholesky.factorize(good);
    CHECK(residual(good, solved(cholesky, B), B) < 1e-12);
}

TEST_CASE("numbers that are not finite never get in, nor out") {
    const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
    const Grid g = grid(10, 10);
    for (const double value : {nan, infinity, -infinity}) {
        SparseMatrix A = laplacian(100, g.edges, 0.1);
        A.coeffRef(57, 56) = value;
        CHECK(failure_of(A).find("row 57, column 56") != std::string::npos);
    }
    SparseMatrix huge = laplacian(100, g.edges, 0.1) * 1e307;
    huge.coeffRef(0, 0) = 1e-300;
    CHECK(failure_of(huge).find("not positive definite") != std::string::npos);

    const SparseMatrix A = laplacian(100, g.edges, 0.1);
    SparseCholesky cholesky(A);
    cholesky.factorize(A);
    Columns B = Columns::Ones(100, 3);
    B(4, 1) = nan;
    CHECK_THROWS_AS(cholesky.solve(B), SolverFailure);
}

TEST_CASE("what does not fit is refused with a code") {
    const auto code_of = [](const auto& f) -> std::string {
        try {
            f();
        } catch (const InvalidInput& error) {
            return error.code();
        }
        return "";
    };
    const Grid g = grid(5, 5);
    const SparseMatrix A = laplacian(25, g.edges, 1), other = laplacian(25, {}, 1);
    const Points few = Points::Zero(24, 3);
    SparseCholesky cholesky(A);
    Columns B = Columns::Zero(24, 1), fitting = Columns::Zero(25, 1);
    CHECK(code_of([] { SparseCholesky(SparseMatrix(3, 4)); }) == "not-square");
    CHECK(code_of([&] { SparseCholesky(A, &few); }) == "wrong-size");
    CHECK(code_of([&] { cholesky.begin(other); }) == "pattern-changed");
    CHECK_THROWS_AS(cholesky.solve(fitting), SolverFailure);
    cholesky.factorize(A);
    CHECK(code_of([&] { cholesky.solve(B); }) == "wrong-size");
}

TEST_CASE("a part of a wider matrix can be solved where it lies") {
    const SparseMatrix A = random_normal(100, 60, 3, 0.5, 8);
    SparseCholesky cholesky(A);
    cholesky.factorize(A);
    Columns wide = random_columns(60, 6, 1);
    const Columns before = wide;
    cholesky.solve(wide.middleCols(2, 3));
    CHECK(wide.leftCols(2) == before.leftCols(2));
    CHECK(wide.rightCols(1) == before.rightCols(1));
    CHECK(wide.middleCols(2, 3) == solved(cholesky, before.middleCols(2, 3)));
}

TEST_CASE("the triangle that is copied out is a factor of the matrix") {
    const Grid g = grid(15, 13);
    const SparseMatrix A = laplacian(195, g.edges, 1e-2);
    SparseCholesky cholesky(A, &g.points);
    CHECK_THROWS_AS(static_cast<void>(cholesky.lower_triangle()), SolverFailure);
    cholesky.factorize(A);
    const LowerTriangle triangle = cholesky.lower_triangle();
    Eigen::MatrixXd L = Eigen::MatrixXd::Zero(195, 195);
    for (int k = 0; k < 195; ++k) {
        CHECK(triangle.rows[triangle.offsets[k]] == k);
        for (std::size_t t = triangle.offsets[k]; t < triangle.offsets[k + 1]; ++t)
            L(triangle.rows[t], k) = triangle.values[t];
    }
    const Eigen::MatrixXd product = L * L.transpose(), dense = A;
    for (int i = 0; i < 195; ++i)
        for (int j = 0; j < 195; ++j)
            CHECK(product(i, j) == doctest::Approx(dense(triangle.order[i], triangle.order[j])).epsilon(1e-12));
}
