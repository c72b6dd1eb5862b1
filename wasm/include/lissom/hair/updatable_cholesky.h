#pragma once

#include "lissom/solve/sparse_cholesky.h"

#include <span>

namespace lissom {

/// A sparse Cholesky factor that follows changes of A's diagonal without being made anew.
///
/// Changing entry (i, i) by ±w² is the update L Lᵀ ± w² e_i e_iᵀ; it touches the columns on the path from i to
/// the root of the elimination tree and never fills in. Several are carried along their joined paths at
/// once, so that each column is read and written once for all of them.
///
/// Source: Davis & Hager, "Modifying a sparse Cholesky factorization", SIAM J. Matrix Anal. 20(3), 1999, and
///         "Multiple-rank modifications of a sparse Cholesky factorization", 22(4), 2001.
/// Cost:   4 multiply-adds per entry of the path and change.
class UpdatableCholesky {
public:
    /// Takes the factor as a plain triangle. Memory: 12 bytes an entry, the given factor's apart.
    explicit UpdatableCholesky(const SparseCholesky& factor);

    /// A ← A + Σ_i w² e_i e_iᵀ.
    void update(std::span<const int> nodes, double w) { change(nodes, w, +1); }
    /// A ← A − Σ_i w² e_i e_iᵀ. @throws SolverFailure  A would not be positive definite; the factor is spoilt
    void downdate(std::span<const int> nodes, double w) { change(nodes, w, -1); }

    /// A x = b for each column, in place. n×k, row-major.
    void solve(Columns& b) const;

    [[nodiscard]] int size() const { return static_cast<int>(L_.order.size()); }
    [[nodiscard]] double entries() const { return static_cast<double>(L_.values.size()); }

private:
    void change(std::span<const int> nodes, double w, int sign);
    void change_some(std::span<const int> columns, double w, int sign);

    LowerTriangle L_;
    std::vector<int> column_of_; // of A's columns
};

} // namespace lissom
