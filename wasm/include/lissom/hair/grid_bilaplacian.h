#pragma once

#include "lissom/mesh/grid.h"

namespace lissom {

/// The squared Neumann Laplacian of a grid, in the cosine basis that diagonalises it.
///
/// Δ is the symmetric graph Laplacian of the grid divided by 6, so that its interior rows are the thesis's
/// operator Δ(t_i) = Σ_j (t_j − t_i)/N(i) (Fu 4.4.1). With the orthonormal DCT-II basis
/// φ_k(p) = c_k cos(πk(p + ½)/n), c_0² = 1/n, c_k² = 2/n, its eigenvalues are
/// λ_k = (1/6) Σ_d (2 − 2cos(πk_d/n_d)); the bilaplacian's are λ_k², and zero for constants alone.
///
/// Cost: construction O(n⁴) for n nodes a side, as one field does.
class GridBilaplacian {
public:
    explicit GridBilaplacian(const Eigen::Vector3i& size);

    [[nodiscard]] const Eigen::Vector3i& size() const { return size_; }

    /// (Δ²)⁺ applied to each column of `f` (count×k): what is constant in `f` is dropped.
    [[nodiscard]] Eigen::MatrixXd apply_inverse(const Eigen::MatrixXd& f) const;

    /// The smoothest eigenvectors at some nodes: those with k_d < `per_axis`, the constant first.
    struct Modes {
        Eigen::MatrixXd values;  ///< one row a node, one column a mode
        Eigen::VectorXd inverse; ///< of their eigenvalues; 0 for the constant
    };
    [[nodiscard]] Modes smoothest(const std::vector<Eigen::Vector3i>& nodes, int per_axis) const;

    /// Entry (p, q) of (Δ²)⁺: the field at node p of a unit load at node q (and its mean taken off).
    /// Eight look-ups, by reflection at the walls.
    [[nodiscard]] double green(const Eigen::Vector3i& p, const Eigen::Vector3i& q) const;

    /// green(p_i, q_j) for all pairs, rows.size() × columns.size().
    [[nodiscard]] Eigen::MatrixXd green(const std::vector<Eigen::Vector3i>& rows,
                                        const std::vector<Eigen::Vector3i>& columns) const;

private:
    Eigen::Vector3i size_;
    Eigen::MatrixXd cosine_[3];     // orthonormal DCT-II, row k is φ_k
    Eigen::VectorXd inverse_;       // 1/λ_k², 0 for the constant
    std::vector<double> table_;     // T(u) for u_d in [0, n_d]
};

} // namespace lissom
