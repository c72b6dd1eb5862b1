#pragma once

#include "lissom/hair/field_solver.h"
#include "lissom/hair/grid_bilaplacian.h"
#include "lissom/hair/incremental_cholesky.h"

#include <memory>

namespace lissom {

/// The field by its dual: one unknown per constraint instead of one per node.
///
/// With K = Δ² and W picking the constrained nodes, the minimiser of Fu Eq 4.1 is
///
///     (G_CC + I/ω²) l + 1 a = c,   1ᵀ l = 0,   t = K⁺ Wᵀ l + a                         (★)
///
/// where G_CC holds Green's function K⁺ between constrained nodes. The dense matrix is kept factored while
/// constraints come and go: the incremental Cholesky of the thesis, in constraint space.
///
/// Exact (it agrees with the sparse system to rounding); cost does not grow with the grid but for the two
/// cosine transforms of a field. Memory: 8 m² bytes for m constraints.
class DualField final : public FieldSolver {
public:
    explicit DualField(std::shared_ptr<const GridBilaplacian> operator_);

    void set_constraints(std::span<const FieldConstraint> constraints) override;
    [[nodiscard]] Points field() const override;
    [[nodiscard]] int constraint_count() const override { return static_cast<int>(held_.size()); }

    /// The field at some nodes only, without a transform. nodes.size()×3.
    [[nodiscard]] Points field_at(std::span<const int> nodes) const;

    /// |(G_CC + I/ω²) l + 1 a − c| / |c|: what rounding and updates have left.
    [[nodiscard]] double residual() const;

private:
    struct Multipliers {
        Eigen::MatrixXd l;    // m×3
        Eigen::RowVector3d a; // the constant part
    };
    [[nodiscard]] Multipliers solve() const;
    void append(std::span<const FieldConstraint> added);

    std::shared_ptr<const GridBilaplacian> K_;
    IncrementalCholesky H_;
    std::vector<FieldConstraint> held_;    // in the order of H_'s rows
    std::vector<Eigen::Vector3i> cells_;   // of held_
    Multipliers multipliers_;
};

} // namespace lissom
