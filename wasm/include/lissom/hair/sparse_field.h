#pragma once

#include "lissom/hair/field_solver.h"
#include "lissom/hair/updatable_cholesky.h"

#include <optional>

namespace lissom {

/// The field by the thesis's own system, one unknown per node:
///
///     (DᵀD + WᵀW) t = ω Wᵀ c                                                     (Fu Eq 4.3)
///
/// factored once by supernodes, then kept up with the constraints by update and downdate (Fu 4.4.2). The
/// reference that DualField is checked against: exact as well, but the factor grows faster than the grid.
///
/// DᵀD alone is singular (constants), so the last weight is kept in the factor when all constraints go, and
/// taken out once there are others.
class SparseField final : public FieldSolver {
public:
    explicit SparseField(const Eigen::Vector3i& size);

    void set_constraints(std::span<const FieldConstraint> constraints) override;
    [[nodiscard]] Points field() const override;
    [[nodiscard]] int constraint_count() const override { return static_cast<int>(held_.size()); }

    /// |A t − b| / |b| of Eq 4.3 for the field at hand.
    [[nodiscard]] double residual() const;

    /// A new supernodal factorization of the system as it stands: what incremental changes save.
    void refactor();

private:
    [[nodiscard]] SparseMatrix system() const;
    [[nodiscard]] Columns right_side() const;

    Grid grid_;                                // of unit step: only its numbering is used
    SparseMatrix DtD_;
    std::vector<FieldConstraint> held_;
    std::vector<int> weighted_;                // nodes whose weight is in the factor, ascending
    std::optional<SparseCholesky> analysis_;
    std::optional<UpdatableCholesky> factor_;
};

} // namespace lissom
