#pragma once

#include "lissom/mesh/grid.h"

namespace lissom {

/// Vectors at the nodes of a grid, read between them.
struct VectorField {
    Grid grid;
    Points vectors; ///< count×3

    /// Trilinear; p is taken to its nearest place inside the grid.
    [[nodiscard]] Eigen::Vector3d at(const Eigen::Vector3d& p) const;
};

} // namespace lissom
