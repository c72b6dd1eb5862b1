#pragma once

#include "lissom/deform/normal_equations.h"
#include "lissom/solve/sparse_cholesky.h"

namespace lissom {

/// Normal equations with their factor: x = A⁻¹ (b − G w), factored in slices.
///
/// A matrix that rounding keeps from being positive definite is tried again with its diagonal raised by
/// 1e-10, 1e-8 and 1e-6 of its mean.
class PreparedSolver {
public:
    /// Analyzes. @param coordinates  of the unknowns, for nested dissection
    PreparedSolver(NormalEquations equations, const Points& coordinates);

    /// @returns true while there is more to factor; then `ready`. @throws SolverFailure  when raising the diagonal did not help
    bool step();
    [[nodiscard]] double fraction() const { return factor_.fraction(); }
    [[nodiscard]] double work() const { return factor_.factor_work(); }
    [[nodiscard]] bool ready() const { return ready_; }
    [[nodiscard]] bool shifted() const { return shift_ > 0; }
    [[nodiscard]] double memory_bytes() const;

    /// @param w  handle parameters W − I, 4·handles × 3
    /// @param b  added to the right-hand side, unknowns × 3, or null
    /// @returns  unknowns × 3
    [[nodiscard]] Columns solve(const Columns& w, const Columns* b = nullptr) const;

private:
    void begin();

    NormalEquations equations_;
    SparseCholesky factor_;
    double shift_ = 0; ///< of the diagonal, relative to its mean
    bool ready_ = false;
};

} // namespace lissom
