#pragma once

#include <Eigen/Core>

#include <array>

namespace lissom {

/// A place of a skin, by a triangle's corners and their weights, and where it should go. A vertex alone stands three times.
struct Pull {
    std::array<int, 3> vertices;
    Eigen::Vector3d weights; ///< sum to 1
    Eigen::Vector3d target;
    double weight = 1;       ///< of the square of what is left

    [[nodiscard]] static Pull of_vertex(int v, const Eigen::Vector3d& target, double weight) { return {{v, v, v}, {1, 0, 0}, target, weight}; }
    [[nodiscard]] bool is_vertex() const { return vertices[0] == vertices[1] && vertices[1] == vertices[2]; }
};

} // namespace lissom
