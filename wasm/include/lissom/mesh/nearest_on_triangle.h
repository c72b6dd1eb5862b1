#pragma once

#include <Eigen/Core>

namespace lissom {

/// The nearest point of a triangle to p, and where on it that point lies.
struct NearestOnTriangle {
    Eigen::Vector3d point;
    int feature; ///< 0–2 a corner, 3–5 the edge opposite corner feature − 3, 6 the inside
};
[[nodiscard]] NearestOnTriangle nearest_on_triangle(const Eigen::Vector3d& p, const Eigen::Vector3d& a,
                                                    const Eigen::Vector3d& b, const Eigen::Vector3d& c);

} // namespace lissom
