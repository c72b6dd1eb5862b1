#pragma once

#include "lissom/mesh/grid.h"

#include <vector>

namespace lissom {

/// The signed distance to a head, sampled on a grid: negative inside, in head units.
///
/// Near the surface the samples are exact (point to triangle, the sign from angle-weighted pseudonormals:
/// Bærentzen & Aanæs, TVCG 11(3), 2005); farther out they are swept from there (Zhao, "A fast sweeping
/// method for Eikonal equations", 2005) and good to about a cell. Open loops (a neck) are closed by a fan
/// from their centre first, so that inside is defined; other holes and doubled sheets only blur the sign nearby.
///
/// Cost: linear in triangles and grid nodes; memory 4 bytes a node.
class HeadDistance {
public:
    /// @param grid  encloses the head by at least two cells
    /// @throws InvalidInput `head-empty`  no triangle with area
    HeadDistance(const TriangleMesh& head, const Grid& grid);

    /// Trilinear; a point outside the grid is taken to its nearest place inside plus the way there.
    [[nodiscard]] double at(const Eigen::Vector3d& p) const;

    /// Away from the head, length about 1 (exactly the gradient of `at`); zero only at medial points.
    [[nodiscard]] Eigen::Vector3d gradient(const Eigen::Vector3d& p) const;

    /// Both at once.
    struct Sample {
        double distance;
        Eigen::Vector3d gradient;
    };
    [[nodiscard]] Sample sample(const Eigen::Vector3d& p) const;

    [[nodiscard]] const Grid& grid() const { return grid_; }

private:
    Grid grid_;
    std::vector<float> samples_;
};

} // namespace lissom
