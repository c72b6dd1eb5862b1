#pragma once

#include "lissom/mesh/types.h"

#include <memory>
#include <vector>

namespace lissom {

/// n×k right-hand sides and solutions, row-major so that one sweep over the factor serves all of them.
using Columns = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// A lower triangular matrix by columns, each starting with its diagonal, rows ascending.
struct LowerTriangle {
    std::vector<int> order;           ///< order[k]: which of A's columns was eliminated k-th
    std::vector<std::size_t> offsets; ///< n+1
    std::vector<int> rows;            ///< in elimination order
    std::vector<double> values;
};

/// Supernodal Cholesky factorization A = P L Lᵀ Pᵀ of a sparse symmetric positive definite matrix, on dense
/// kernels. Three verbs, apart: analyze (pattern), factorize (values; steppable), solve (many columns).
///
/// Cost: dominated by dense updates of supernode panels; memory is `factor_entries()` doubles.
class SparseCholesky {
public:
    /// Analyzes the pattern of `A`: fill-reducing order, elimination tree, supernodes with relaxed
    /// amalgamation. Reads the lower triangle only (column-major); the values are not used.
    ///
    /// @param A            n×n; every diagonal entry is part of the pattern
    /// @param coordinates  optional n×3 positions of the unknowns: with them a geometric nested dissection
    ///                     is tried beside the minimum degree order and the one with less work wins
    /// @throws InvalidInput `not-square`, `wrong-size` (other than n coordinates)
    explicit SparseCholesky(const SparseMatrix& A, const Points* coordinates = nullptr);
    ~SparseCholesky();
    SparseCholesky(SparseCholesky&&) noexcept;
    SparseCholesky& operator=(SparseCholesky&&) noexcept;

    /// Starts a factorization of the values of `A` (same pattern as analyzed; lower triangle). They are copied.
    /// @throws InvalidInput `pattern-changed`
    /// @throws SolverFailure  a value is not finite: names its row and column
    void begin(const SparseMatrix& A);

    /// Factors some more supernodes: roughly `work` multiply-adds of them, at least 64 columns of one.
    /// Deterministic whatever the slices.
    /// @returns true while there is more to do
    /// @throws SolverFailure  a pivot is not positive: names the column (in A's numbering), pivot and size
    bool step(double work = 5e7);

    /// Share of the numerical work done, in [0, 1].
    [[nodiscard]] double fraction() const;

    /// begin + step to the end.
    void factorize(const SparseMatrix& A);

    /// Solves A X = B in place for all columns of B at once. n×k, k ≥ 1. Requires a finished factorization.
    /// @throws InvalidInput `wrong-size`
    /// @throws SolverFailure  no finished factorization, or the solution is not finite
    void solve(Eigen::Ref<Columns> B) const;

    /// L of A = P L Lᵀ Pᵀ, copied out with the zeros that amalgamation stored: for whoever changes it entry by
    /// entry. Requires a finished factorization. Memory: 12 bytes an entry.
    [[nodiscard]] LowerTriangle lower_triangle() const;

    [[nodiscard]] int size() const;
    [[nodiscard]] double factor_entries() const; ///< numbers stored in the panels, zeros included
    [[nodiscard]] double factor_work() const;    ///< multiply-adds of a factorization
    [[nodiscard]] const char* ordering() const;  ///< "minimum-degree" or "nested-dissection"

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace lissom
