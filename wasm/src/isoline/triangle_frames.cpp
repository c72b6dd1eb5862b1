#include "lissom/isoline/triangle_frames.h"

#include "lissom/mesh/operators.h"
#include "lissom/mesh/polar.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

namespace lissom {

Eigen::Matrix3d triangle_frame(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
    Eigen::Matrix3d frame;
    frame.col(0) = b - a;
    frame.col(1) = c - a;
    frame.col(2) = frame.col(0).cross(frame.col(1)).normalized();
    return frame;
}

std::vector<Eigen::Matrix3d> triangle_gradients(const TriangleMesh& rest, const Points& moved) {
    std::vector<Eigen::Matrix3d> gradients(static_cast<std::size_t>(rest.triangle_count()));
    for (int t = 0; t < rest.triangle_count(); ++t) {
        const auto frame = [&](const Points& points) {
            return triangle_frame(points.row(rest.triangles(t, 0)), points.row(rest.triangles(t, 1)), points.row(rest.triangles(t, 2)));
        };
        const Eigen::Matrix3d before = frame(rest.points);
        const double longest = std::max({before.col(0).squaredNorm(), before.col(1).squaredNorm()});
        // A triangle this thin (relative to its sides) has lost its direction to rounding.
        const bool has_area = before.col(0).cross(before.col(1)).norm() > 1e-12 * longest;
        gradients[t] = has_area ? Eigen::Matrix3d(frame(moved) * before.inverse()) : Eigen::Matrix3d::Identity();
    }
    return gradients;
}

std::vector<Eigen::Matrix3d> vertex_rotations(const TriangleMesh& rest, const Points& moved) {
    const std::vector<Eigen::Matrix3d> gradients = triangle_gradients(rest, moved);
    const Eigen::VectorXd areas = triangle_areas(rest);
    std::vector<Eigen::Matrix3d> sums(static_cast<std::size_t>(rest.vertex_count()), Eigen::Matrix3d::Zero());
    for (int t = 0; t < rest.triangle_count(); ++t)
        for (int k = 0; k < 3; ++k) sums[rest.triangles(t, k)] += areas[t] * gradients[t];
    for (Eigen::Matrix3d& sum : sums) sum = nearest_rotation(sum);
    return sums;
}

} // namespace lissom
