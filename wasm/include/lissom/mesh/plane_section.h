#pragma once

#include "lissom/mesh/triangle_tree.h"
#include "lissom/mesh/types.h"

#include <Eigen/Geometry>

#include <vector>

namespace lissom {

/// One line along which a plane cuts a surface.
struct SectionLine {
    std::vector<Eigen::Vector3d> points; ///< in order; of a closed line the first is not repeated
    bool closed = false;
    double length = 0;
    double area = 0;                     ///< inside a closed line, ≥ 0; 0 for an open one
    Eigen::Vector3d centroid = Eigen::Vector3d::Zero(); ///< of the area inside; of the line itself where it is open

    /// Radius of the circle of the same area; half the length of an open line.
    [[nodiscard]] double radius() const;
    /// Smallest and largest distance of the line from a point.
    [[nodiscard]] double nearest(const Eigen::Vector3d& p) const;
    [[nodiscard]] double farthest(const Eigen::Vector3d& p) const;
};

/// Where the plane through `at` cuts the mesh, chained across shared edges: corners at or below the plane count as
/// below it, so that each triangle is crossed once or not at all. At an edge of more than two triangles lines
/// go on into any one that is left. Needs welded vertices, no orientation.
[[nodiscard]] std::vector<SectionLine> plane_section(const TriangleMesh& mesh, const TriangleTree& tree, const Eigen::Vector3d& normal,
                                                     const Eigen::Vector3d& at);

/// The line that a point of the plane belongs to: the smallest closed one around it, else the nearest; −1: there is none.
[[nodiscard]] int line_around(const std::vector<SectionLine>& lines, const Eigen::Vector3d& normal, const Eigen::Vector3d& p);

} // namespace lissom
