#pragma once

#include "lissom/mesh/grid.h"

#include <span>

namespace lissom {

/// One known vector: the field should be `vector` at `node`.
struct FieldConstraint {
    int node;
    Eigen::Vector3d vector;
};

/// Interpolates vectors over a grid: the field t that minimises
///
///     E(t) = Σ_i |Δ(t_i)|² + ω² Σ_{i∈C} |t_i − c_i|²,   ω = 100                     (Fu Eq 4.1–4.3)
///
/// with the symmetric Neumann Laplacian of GridBilaplacian. Without constraints the field is zero.
class FieldSolver {
public:
    static constexpr double weight = 100; ///< ω

    virtual ~FieldSolver() = default;

    /// Makes `constraints` the whole set; what is already there is kept, so the cost follows the change.
    /// The vectors alone may change at no cost. Nodes are in range and each given once.
    /// @throws InvalidInput `constraint-node`  out of range, repeated or not finite
    virtual void set_constraints(std::span<const FieldConstraint> constraints) = 0;

    /// The minimiser, count×3 by node.
    [[nodiscard]] virtual Points field() const = 0;

    [[nodiscard]] virtual int constraint_count() const = 0;
};

/// What is new in `wanted` and what is no longer there, by node: the first step of every solver.
/// @throws InvalidInput `constraint-node`
struct ConstraintChange {
    std::vector<int> added;   ///< places in `wanted`, ascending
    std::vector<int> removed; ///< places in `held`, ascending
};
[[nodiscard]] ConstraintChange constraint_change(std::span<const FieldConstraint> held,
                                                 std::span<const FieldConstraint> wanted, int node_count);

} // namespace lissom
