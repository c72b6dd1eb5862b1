#include "lissom/hair/incremental_cholesky.h"

#include "lissom/mesh/errors.h"

#include <Eigen/Cholesky>
#include <Eigen/Householder>
#include <Eigen/QR>

#include <algorithm>
#include <string>

namespace lissom {

using Eigen::Index;
using Eigen::MatrixXd;

namespace {

constexpr Index k_block = 64;

/// Makes the m×(m+r) matrix [L | U], L lower triangular, into [L' | 0] by orthogonal turns of its columns, so
/// that L' L'ᵀ = L Lᵀ + U Uᵀ: Householder reflections of one block of rows at a time, the rows below as products.
void absorb(Eigen::Ref<MatrixXd> L, Eigen::Ref<MatrixXd> U) {
    const Index m = L.rows(), r = U.cols();
    MatrixXd wide, below;
    for (Index at = 0; at < m; at += k_block) {
        const Index b = std::min(k_block, m - at), rest = m - at - b;
        wide.resize(b + r, b);
        wide.topRows(b) = MatrixXd(L.block(at, at, b, b).triangularView<Eigen::Lower>()).transpose();
        wide.bottomRows(r) = U.middleRows(at, b).transpose();
        const Eigen::HouseholderQR<MatrixXd> qr(wide);
        MatrixXd upper = qr.matrixQR().topRows(b).triangularView<Eigen::Upper>();
        Eigen::VectorXd sign = upper.diagonal().array().sign();
        for (Index k = 0; k < b; ++k)
            if (sign[k] == 0) sign[k] = 1;
        L.block(at, at, b, b) = (sign.asDiagonal() * upper).transpose();
        if (rest == 0) continue;
        below.resize(rest, b + r);
        below.leftCols(b) = L.block(at + b, at, rest, b);
        below.rightCols(r) = U.bottomRows(rest);
        below = below * qr.householderQ();
        L.block(at + b, at, rest, b) = below.leftCols(b) * sign.asDiagonal();
        U.bottomRows(rest) = below.rightCols(r);
    }
}

} // namespace

void IncrementalCholesky::reserve(int rows) {
    if (rows <= R_.rows()) return;
    const Index capacity = std::max<Index>(rows, R_.rows() + R_.rows() / 2 + 64);
    MatrixXd larger(capacity, capacity);
    larger.topLeftCorner(size_, size_) = R_.topLeftCorner(size_, size_);
    R_.swap(larger);
}

void IncrementalCholesky::append(const MatrixXd& off, const MatrixXd& diagonal) {
    const Index m = size_, k = diagonal.rows();
    if (k == 0) return;
    MatrixXd Xt = off; // (R⁻¹ offᵀ)ᵀ
    const auto R = R_.topLeftCorner(m, m).triangularView<Eigen::Lower>();
    if (m > 0) R.transpose().solveInPlace<Eigen::OnTheRight>(Xt);
    MatrixXd schur = diagonal;
    if (m > 0) schur.selfadjointView<Eigen::Lower>().rankUpdate(Xt, -1);
    const Eigen::LLT<MatrixXd, Eigen::Lower> corner(schur);
    if (corner.info() != Eigen::Success)
        throw SolverFailure("IncrementalCholesky: " + std::to_string(k) + " rows appended to " + std::to_string(m) +
                            " would leave the matrix not positive definite");
    reserve(static_cast<int>(m + k));
    R_.block(m, 0, k, m) = Xt;
    R_.block(m, m, k, k) = corner.matrixL();
    size_ += static_cast<int>(k);
}

void IncrementalCholesky::remove(const std::vector<int>& places) {
    if (places.empty()) return;
    const Index first = places.front(), r = static_cast<Index>(places.size());
    std::vector<Index> kept;
    std::size_t next = 0;
    for (Index i = first; i < size_; ++i) {
        if (next < places.size() && places[next] == i) ++next;
        else kept.push_back(i);
    }
    const Index rest = static_cast<Index>(kept.size());
    for (Index i = 0; i < rest; ++i) R_.block(first + i, 0, 1, first) = MatrixXd(R_.block(kept[i], 0, 1, first));

    // The kept rows are lower trapezoidal over the columns from `first` on. Columns of the removed rows hang
    // over to the right of the triangle: they are the U of  L Lᵀ + U Uᵀ.
    MatrixXd L = MatrixXd::Zero(rest, rest), U = MatrixXd::Zero(rest, r);
    for (Index i = 0; i < rest; ++i) {
        for (Index j = 0; j <= i; ++j) L(i, j) = R_(kept[i], kept[j]);
        for (Index j = 0; j < r; ++j)
            if (places[j] < kept[i]) U(i, j) = R_(kept[i], places[j]);
    }
    const double turns = 2.0 * static_cast<double>(rest) * static_cast<double>(rest) * static_cast<double>(r + k_block);
    const double anew = static_cast<double>(rest) * static_cast<double>(rest) *
                        (static_cast<double>(rest) * 4 / 3 + static_cast<double>(r));
    if (turns < anew || rest < k_block) {
        absorb(L, U);
        R_.block(first, first, rest, rest) = L;
    } else {
        MatrixXd H = MatrixXd::Zero(rest, rest);
        H.selfadjointView<Eigen::Lower>().rankUpdate(L);
        H.selfadjointView<Eigen::Lower>().rankUpdate(U);
        const Eigen::LLT<MatrixXd, Eigen::Lower> llt(H);
        if (llt.info() != Eigen::Success)
            throw SolverFailure("IncrementalCholesky: the factor lost its definiteness while rows were removed");
        R_.block(first, first, rest, rest) = llt.matrixL();
    }
    size_ -= static_cast<int>(r);
}

void IncrementalCholesky::solve(MatrixXd& b) const {
    const auto R = R_.topLeftCorner(size_, size_).triangularView<Eigen::Lower>();
    R.solveInPlace(b);
    R.transpose().solveInPlace(b);
}

} // namespace lissom
