#include "lissom/wear/surface_turns.h"

#include "lissom/mesh/operators.h"
#include "lissom/mesh/polar.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace lissom {

using Eigen::Matrix3d;
using Eigen::Vector3d;

std::vector<Matrix3d> surface_maps(const TriangleMesh& from, const Points& to) {
    std::vector<Matrix3d> maps(static_cast<std::size_t>(from.triangle_count()), Matrix3d::Zero());
    for (int t = 0; t < from.triangle_count(); ++t) {
        const auto frame = [&](const Points& points) {
            const Vector3d a = points.row(from.triangles(t, 0)), b = points.row(from.triangles(t, 1)), c = points.row(from.triangles(t, 2));
            Matrix3d sides;
            // As long as the triangle is wide: of a surface that only grows the map is that growth, normals and all.
            const Vector3d normal = (b - a).cross(c - a);
            sides << b - a, c - a, std::sqrt(normal.norm()) * normal.stableNormalized();
            return sides;
        };
        const Matrix3d here = frame(from.points), there = frame(to);
        const double area = here.col(0).cross(here.col(1)).norm(), longest = std::max({here.col(0).squaredNorm(), here.col(1).squaredNorm(), (here.col(1) - here.col(0)).squaredNorm()});
        if (!(area > 1e-6 * longest) || there.col(2).isZero(0)) continue; // a needle says nothing of turns
        maps[static_cast<std::size_t>(t)] = there * here.inverse();
    }
    return maps;
}

std::vector<Matrix3d> surface_turns(const TriangleMesh& from, const Points& to) {
    const std::vector<Matrix3d> maps = surface_maps(from, to);
    const Eigen::VectorXd areas = triangle_areas(from);
    std::vector<Matrix3d> sums(static_cast<std::size_t>(from.vertex_count()), Matrix3d::Zero());
    for (int t = 0; t < from.triangle_count(); ++t)
        for (int k = 0; k < 3; ++k) sums[static_cast<std::size_t>(from.triangles(t, k))] += 2 * areas[t] * maps[static_cast<std::size_t>(t)];
    for (Matrix3d& sum : sums) sum = nearest_rotation(sum);
    return sums;
}

} // namespace lissom
