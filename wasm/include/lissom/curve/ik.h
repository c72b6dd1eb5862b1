#pragma once

#include "lissom/mesh/types.h"

#include <span>

namespace lissom {

struct Reached {
    Points points;
    bool reached = false; ///< false: the chain is too short, and stretched towards the target
};

/// Inverse kinematics of a chain of control points by FABRIK: one of them reaches for a target, segments keep their lengths.
///
/// The chain runs from `end` back to the nearest held point before it, or to the first point, which then is held; from the first point it runs the
/// other way. What lies beyond `end` moves along with it. A straight chain whose target lies on its line is bent a little, always the same way.
/// Source: Aristidou, Lasenby, "FABRIK: a fast, iterative solver for the inverse kinematics problem", Graphical Models 73(5), 2011.
/// Cost: some tens of passes along the chain.
/// @param points  n×3, n ≥ 2
/// @throws InvalidInput `no-such-control` (`end` or a held one is not there), `non-finite-curve`
[[nodiscard]] Reached reached(const Points& points, int end, const Eigen::Vector3d& target, std::span<const int> held = {});

} // namespace lissom
