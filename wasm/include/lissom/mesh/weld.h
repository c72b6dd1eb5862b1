#pragma once

#include "lissom/mesh/types.h"

#include <span>
#include <vector>

namespace lissom {

/// For each vertex the first one at exactly the same position (itself, where it is alone); −1 where `used` is
/// false. −0 equals 0. Cost: linear.
[[nodiscard]] std::vector<int> exact_twins(const Points& points, const std::vector<bool>& used);

/// Groups candidates and gives for each the smallest vertex index of its group. A candidate within `tolerance`
/// of an earlier one that leads a group joins it (and joins groups, where it is near several leaders); one near
/// none leads its own. Points scattered less than the tolerance around one place so come together, whatever
/// their order. Pass only vertices that may be joined.
/// @param candidates  vertex indices, ascending
/// @returns as many as candidates
/// Cost: linear, by a grid of cells a few tolerances wide.
[[nodiscard]] std::vector<int> near_twins(const Points& points, std::span<const int> candidates, double tolerance);

/// For each triangle whether an earlier one has the same three vertices, in whatever order.
[[nodiscard]] std::vector<bool> repeated_triangles(const Triangles& triangles);

} // namespace lissom
