#pragma once

#include "lissom/mesh/types.h"

#include <Eigen/Geometry>

#include <vector>

namespace lissom {

/// How often a surface winds around a place: 1 inside a closed surface that faces outward, 0 outside of it, in between near its holes.
///
/// The solid angles of all triangles by 4π (Jacobson et al. 2013); those of far groups by their dipole and its first moments
/// (Barill et al. 2018), which is within 0.07: enough to tell inside from outside. Triangles with a corner that is not finite count for nothing.
/// Cost: building n log n, a question some hundred triangles. Nothing of the mesh is referred to afterwards.
class WindingNumber {
public:
    explicit WindingNumber(const TriangleMesh& mesh);

    [[nodiscard]] double operator()(const Eigen::Vector3d& p) const;
    /// Without groups: triangle by triangle.
    [[nodiscard]] double exact(const Eigen::Vector3d& p) const;

private:
    struct Corners {
        Eigen::Vector3d a, b, c;
    };
    struct Node {
        Eigen::Vector3d centre;     ///< mean of its triangles by area
        Eigen::Vector3d dipole;     ///< sum of their area vectors n
        Eigen::Matrix3d moment;     ///< sum of (middle − centre) nᵀ
        double radius = 0;          ///< of the ball around the centre with all corners in it
        int first = 0, last = 0;    ///< of `triangles_`
        int right = -1;             ///< the left child follows its parent; −1: a leaf
    };

    int build(int first, int last);

    std::vector<Corners> triangles_;
    std::vector<Node> nodes_;
};

} // namespace lissom
