#pragma once

#include <Eigen/Core>

namespace lissom {

/// On which side of the plane through a, b, c (anticlockwise seen from the positive side) d lies: 1, −1, or 0 in the plane. Exact: the sign
/// of det(a − d, b − d, c − d) reversed, by floating point where its error bound allows, else by sums of doubles without rounding.
///
/// Source: Shewchuk, "Adaptive precision floating-point arithmetic and fast robust geometric predicates", Discrete Comput.
/// Geom. 18, 1997. Requires finite coordinates whose cubes neither overflow nor vanish.
[[nodiscard]] int orient3d(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c, const Eigen::Vector3d& d);

/// 1 where a, b, c turn left, −1 right, 0 in a line. Exact likewise.
[[nodiscard]] int orient2d(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c);

} // namespace lissom
