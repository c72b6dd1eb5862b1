#pragma once

#include "lissom/hair/field_solver.h"
#include "lissom/hair/grid_bilaplacian.h"

#include <memory>

namespace lissom {

/// The field by conjugate gradients, for more constraints than a dense factor should hold.
///
/// On Fu's normal equations (Eq 4.3) themselves, preconditioned by the cosine transform of Δ² + α: memory is a few
/// fields, whatever the number of constraints. It starts from the last field, so a small edit is few iterations.
/// Agrees with DualField to 1e-6.
class IterativeField final : public FieldSolver {
public:
    explicit IterativeField(std::shared_ptr<const GridBilaplacian> operator_);

    /// @throws SolverFailure  it does not converge
    void set_constraints(std::span<const FieldConstraint> constraints) override;
    [[nodiscard]] Points field() const override { return t_; }
    [[nodiscard]] int constraint_count() const override { return static_cast<int>(held_.size()); }
    [[nodiscard]] int iterations() const { return iterations_; } ///< of the last change

private:
    std::shared_ptr<const GridBilaplacian> K_;
    std::vector<FieldConstraint> held_;
    Points t_;
    int iterations_ = 0;
};

} // namespace lissom
