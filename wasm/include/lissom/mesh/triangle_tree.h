#pragma once

#include "lissom/mesh/types.h"

#include <Eigen/Geometry>

#include <vector>

namespace lissom {

/// Where a ray meets a triangle.
struct RayHit {
    double depth; ///< in lengths of the ray's direction, ≥ 0
    int triangle;
};

/// A bounding volume hierarchy: which triangles a ray or a plane meets, and which is nearest to a point.
///
/// Triangles are sorted along a space-filling curve (Morton order of their centres) and boxed in blocks of a power of two,
/// so that the tree is an array without pointers and is built in linear time. Which way triangles face, and whether
/// they hang together, does not matter. Triangles with a corner that is not finite are never met.
/// Cost: build linear; 1.1 million triangles in about 0.2 s. The mesh is referred to and must outlive the tree.
class TriangleTree {
public:
    explicit TriangleTree(const TriangleMesh& mesh);
    explicit TriangleTree(TriangleMesh&&) = delete;

    /// Every triangle on the ray, nearest first, where several are equally near the smaller index first. A ray through an
    /// edge meets all of its triangles (Möller & Trumbore 1997, borders counted in).
    [[nodiscard]] std::vector<RayHit> hits(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction) const;

    /// Triangles with a corner strictly above the plane n·x = offset and one at or below it, ascending.
    [[nodiscard]] std::vector<int> crossed(const Eigen::Vector3d& normal, double offset) const;

    struct Nearest {
        int triangle = -1; ///< −1: there is none
        double distance = 0;
        Eigen::Vector3d point = Eigen::Vector3d::Zero();
    };
    [[nodiscard]] Nearest nearest(const Eigen::Vector3d& p) const;

private:
    using Box = Eigen::AlignedBox3d;

    [[nodiscard]] const TriangleMesh& mesh() const { return *mesh_; }
    /// Calls `leaf(triangle)` for each triangle in a box that `meets`.
    template <class Meets, class Leaf>
    void visit(Meets meets, Leaf leaf) const;

    const TriangleMesh* mesh_;
    std::vector<int> order_;                ///< triangles along the curve
    std::vector<std::vector<Box>> levels_;  ///< boxes of blocks: [0] of leaves, each further level half as many
};

} // namespace lissom
