#pragma once

#include "lissom/deform/normal_equations.h"
#include "lissom/solve/sparse_cholesky.h"

#include <optional>

namespace lissom {

/// Normal equations with their factor: x = A⁻¹ (b − G w), factored in slices.
///
/// A matrix that rounding keeps from being positive definite is tried again with its diagonal raised by
/// 1e-10, 1e-8 and 1e-6 of its mean.
///
/// Very short edges beside needles cost the normal equations more digits than there are. Whether they do is tried out once,
/// on a common affine map of all handles; where they do, `refine_by` takes the rows that the equations were made of, and
/// every solution is corrected by its residual in those until the corrections are small: the corrected seminormal equations
/// (Björck, "Stability analysis of the method of seminormal equations for linear least squares problems", Linear Algebra
/// and its Applications 88/89, 1987). A correction costs a solve and two products.
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
    /// Once ready: the largest correction of the trial, relative to its solution.
    [[nodiscard]] double trial_error() const { return trial_error_; }
    /// Whether solutions would lack digits without rows to correct them by.
    [[nodiscard]] bool needs_rows() const { return ready_ && !rows_ && trial_error_ > k_poor; }
    [[nodiscard]] bool corrects() const { return rows_.has_value(); }
    void refine_by(RowPair rows) { rows_ = std::move(rows); }
    [[nodiscard]] double memory_bytes() const;

    /// @param w  handle parameters W − I, 4·handles × 3
    /// @param b  added to the right-hand side, unknowns × 3, or null
    /// @param is_final  false: uncorrected, for a picture under way
    /// @returns  unknowns × 3
    [[nodiscard]] Columns solve(const Columns& w, const Columns* b = nullptr, bool is_final = true) const;

private:
    /// Corrections below this, relative to the solution, are not worth a solve: a hundredth of what is promised.
    static constexpr double k_fine = 1e-8;
    /// A trial worse than this calls for corrections: a tenth of what is promised. Even meshes of 50,000 vertices stay below.
    static constexpr double k_poor = 1e-7;
    static constexpr int k_rounds = 8; ///< of corrections, at most

    void begin();
    [[nodiscard]] double try_out() const;
    void correct(Columns& x, const Columns& w, const Columns* b) const;

    NormalEquations equations_;
    SparseCholesky factor_;
    double shift_ = 0; ///< of the diagonal, relative to its mean
    double trial_error_ = 0;
    std::optional<RowPair> rows_;
    bool ready_ = false;
};

} // namespace lissom
