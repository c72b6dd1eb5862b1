#include "lissom/hair/incremental_cholesky.h"

#include "lissom/mesh/errors.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>

using namespace lissom;
using Eigen::MatrixXd;

namespace {

/// Symmetric and positive definite, the same for the same seed.
MatrixXd some_matrix(int n, unsigned seed) {
    std::srand(seed);
    const MatrixXd B = MatrixXd::Random(n, n);
    return B * B.transpose() + MatrixXd::Identity(n, n);
}

double residual(const IncrementalCholesky& factor, const MatrixXd& H) {
    const MatrixXd b = MatrixXd::Random(H.rows(), 2);
    MatrixXd x = b;
    factor.solve(x);
    return (H * x - b).norm() / b.norm();
}

} // namespace

TEST_CASE("a factor grown row by row is the factor of the whole") {
    const MatrixXd H = some_matrix(90, 5);
    IncrementalCholesky factor;
    for (int at = 0; at < 90;) { // by 1, 2, 3 … rows
        const int k = std::min(90 - at, 1 + at / 6);
        factor.append(H.block(at, 0, k, at), H.block(at, at, k, k));
        at += k;
        CHECK(factor.size() == at);
        CHECK(residual(factor, H.topLeftCorner(at, at)) < 1e-10);
    }
    CHECK(factor.bytes() >= 8.0 * 90 * 90);
}

TEST_CASE("a factor that lost rows is the factor of what is left") {
    const MatrixXd H = some_matrix(220, 4);
    for (const std::vector<int>& gone : {std::vector<int>{0}, {219}, {3, 4, 5, 100, 150}, {0, 50, 219}}) {
        IncrementalCholesky factor;
        factor.append(MatrixXd(100, 0), H.topLeftCorner(100, 100));
        factor.append(H.block(100, 0, 120, 100), H.bottomRightCorner(120, 120));
        factor.remove(gone);
        std::vector<int> kept;
        for (int i = 0; i < 220; ++i)
            if (std::find(gone.begin(), gone.end(), i) == gone.end()) kept.push_back(i);
        CHECK(factor.size() == static_cast<int>(kept.size()));
        CHECK(residual(factor, H(kept, kept)) < 1e-9);
    }
}

TEST_CASE("rows that would spoil it are refused, and the factor is what it was") {
    const MatrixXd H = some_matrix(20, 6);
    IncrementalCholesky factor;
    factor.append(MatrixXd(20, 0), H);
    const MatrixXd again = H.topRows(1); // a row that is there already
    CHECK_THROWS_AS(factor.append(again, MatrixXd::Constant(1, 1, H(0, 0) - 1)), SolverFailure);
    CHECK(factor.size() == 20);
    CHECK(residual(factor, H) < 1e-10);
}

TEST_CASE("a factor that lost all its rows begins anew") {
    IncrementalCholesky factor;
    factor.append(MatrixXd(3, 0), some_matrix(3, 7));
    factor.remove({0, 1, 2});
    CHECK(factor.size() == 0);
    const MatrixXd H = some_matrix(5, 8);
    factor.append(MatrixXd(5, 0), H);
    CHECK(residual(factor, H) < 1e-12);
    factor.clear();
    CHECK(factor.size() == 0);
}
