#include "lissom/mesh/corner_weights.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace lissom {

using Eigen::Vector3d;

Vector3d corner_weights(const TriangleMesh& mesh, int triangle, const Vector3d& place) {
    const auto corner = [&](int k) -> Vector3d { return mesh.points.row(mesh.triangles(triangle, k)); };
    const Vector3d a = corner(0), ab = corner(1) - a, ac = corner(2) - a, normal = ab.cross(ac);
    const double squared = normal.squaredNorm();
    if (!(squared > 0)) return {1, 0, 0};
    const double b = std::clamp((place - a).cross(ac).dot(normal) / squared, 0.0, 1.0), c = std::clamp(ab.cross(place - a).dot(normal) / squared, 0.0, 1 - b);
    return {1 - b - c, b, c};
}

} // namespace lissom
