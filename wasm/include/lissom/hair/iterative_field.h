#pragma once

#include "lissom/hair/field_solver.h"
#include "lissom/hair/grid_bilaplacian.h"

#include <memory>

namespace lissom {

/// The field by conjugate gradients on the dual system of DualField (★), for more constraints than a dense factor
/// should hold. G_CC is never formed: its product is two cosine transforms.
///
/// The preconditioner parts Green's function in two: the smoothest modes, taken exactly, and what they leave, which
/// is short of range and so well served by overlapping neighbourhoods, each with a small dense factor (two-level
/// additive Schwarz; Woodbury joins them). Tens of iterations, however many constraints.
///
/// Agrees with DualField to 1e-6. Memory: about 10 kB a constraint.
class IterativeField final : public FieldSolver {
public:
    explicit IterativeField(std::shared_ptr<const GridBilaplacian> operator_);
    ~IterativeField() override;

    /// Starts from the last multipliers; the preconditioner is made anew only where nodes came or went.
    /// @throws SolverFailure  it does not converge
    void set_constraints(std::span<const FieldConstraint> constraints) override;
    [[nodiscard]] Points field() const override;
    [[nodiscard]] int constraint_count() const override { return static_cast<int>(held_.size()); }
    [[nodiscard]] int iterations() const { return iterations_; } ///< of the last change

private:
    class Preconditioner;

    /// K⁺ Wᵀ l: the field of the multipliers, but for its constant part.
    [[nodiscard]] Eigen::MatrixXd spread(const Eigen::MatrixXd& l) const;

    std::shared_ptr<const GridBilaplacian> K_;
    std::vector<FieldConstraint> held_; // by node
    std::unique_ptr<Preconditioner> preconditioner_;
    Eigen::MatrixXd l_;                 // multipliers, held_.size()×3
    Eigen::RowVector3d a_ = Eigen::RowVector3d::Zero();
    int iterations_ = 0;
};

} // namespace lissom
