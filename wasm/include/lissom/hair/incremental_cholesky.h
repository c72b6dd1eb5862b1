#pragma once

#include <Eigen/Core>

#include <vector>

namespace lissom {

/// A dense Cholesky factor H = R Rᵀ that grows by rows and loses rows without being made anew.
///
/// Rows are numbered by their place; removing some closes the gaps, so what was added last stays last.
/// Cost: appending k rows to m is m²k; removing r rows whose first is f costs about 2(m − f)²r, or a
/// factorization of the trailing block where that is less; removing the last rows costs nothing.
class IncrementalCholesky {
public:
    [[nodiscard]] int size() const { return size_; }

    /// Adds k rows at the end.
    /// @param off       k×size(): H between the new rows and those there
    /// @param diagonal  k×k: H among the new rows (lower triangle read)
    /// @throws SolverFailure  H would not be positive definite; the factor is then unchanged
    void append(const Eigen::MatrixXd& off, const Eigen::MatrixXd& diagonal);

    /// Takes rows away. @param places ascending, each once, in [0, size())
    void remove(const std::vector<int>& places);

    /// H x = b for each column, in place. b has size() rows.
    void solve(Eigen::MatrixXd& b) const;

    void clear() { size_ = 0; }
    [[nodiscard]] double bytes() const { return 8.0 * static_cast<double>(R_.size()); }

private:
    void reserve(int rows);

    Eigen::MatrixXd R_; // lower triangle of its leading size_×size_ block
    int size_ = 0;
};

} // namespace lissom
