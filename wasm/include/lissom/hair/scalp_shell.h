#pragma once

#include "lissom/hair/field_solver.h"
#include "lissom/hair/head_distance.h"

namespace lissom {

/// The grid nodes that keep hair from growing into the scalp (Fu 4.6): those near the head's surface and near the
/// scalp. Fixed for a head, so their part of the factor is made once. Ascending.
///
/// More than `limit` of them are thinned to every other node, and again: the field is smooth.
/// @param scalp  n×3 points of the scalp
/// @param near   how far from the scalp the shell goes on over face and neck, head units
[[nodiscard]] std::vector<int> scalp_shell(const Grid& grid, const HeadDistance& head, const Points& scalp,
                                           double near, std::size_t limit = 2600);

/// What the shell demands: where the field points into the head its tangential part, at magnitude 0.3.
/// @param field  the field of the style alone at the shell's nodes, shell.size()×3
[[nodiscard]] std::vector<FieldConstraint> shell_constraints(const std::vector<int>& shell, const Points& field,
                                                             const Grid& grid, const HeadDistance& head);

} // namespace lissom
