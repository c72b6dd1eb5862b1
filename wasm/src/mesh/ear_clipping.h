#pragma once

#include <Eigen/Core>

#include <array>
#include <vector>

namespace lissom {

/// Triangles of a planar polygon as places in it, k − 2 for k corners, counter-clockwise where the polygon is.
/// The cut of the shortest new side comes first, which keeps the triangles of a round outline plump.
/// @param corners  k ≥ 3 points in the plane, running counter-clockwise; may touch or cross themselves
[[nodiscard]] std::vector<std::array<int, 3>> clip_ears(const std::vector<Eigen::Vector2d>& corners);

} // namespace lissom
