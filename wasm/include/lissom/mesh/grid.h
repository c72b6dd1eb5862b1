#pragma once

#include "lissom/mesh/types.h"

#include <Eigen/Geometry>

namespace lissom {

/// A uniform grid of nodes; node (x, y, z) has number x + nx (y + ny z).
struct Grid {
    Eigen::Vector3d origin = Eigen::Vector3d::Zero(); ///< of node (0, 0, 0), head units
    double step = 1;                                  ///< distance between neighbouring nodes, head units
    Eigen::Vector3i size = Eigen::Vector3i::Ones();   ///< nodes per axis

    [[nodiscard]] int count() const { return size.prod(); }
    [[nodiscard]] int node(int x, int y, int z) const { return x + size.x() * (y + size.y() * z); }
    [[nodiscard]] Eigen::Vector3i cell(int node) const {
        return {node % size.x(), node / size.x() % size.y(), node / (size.x() * size.y())};
    }
    [[nodiscard]] Eigen::Vector3d position(int node) const { return origin + step * cell(node).cast<double>(); }
    /// In node units: 0 at the first node of each axis.
    [[nodiscard]] Eigen::Vector3d local(const Eigen::Vector3d& p) const { return (p - origin) / step; }
    [[nodiscard]] bool contains(const Eigen::Vector3d& p) const {
        const Eigen::Vector3d q = local(p);
        return (q.array() >= 0).all() && (q.array() <= (size.array() - 1).cast<double>()).all();
    }
};

/// The eight nodes around a point and their trilinear weights.
struct Cell {
    int nodes[8];
    double weights[8];
};
/// @param p  inside the grid (clamped to it otherwise)
[[nodiscard]] Cell cell_of(const Grid& grid, const Eigen::Vector3d& p);

} // namespace lissom
