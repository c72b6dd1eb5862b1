#include "lissom/match/denoise.h"

#include "lissom/mesh/errors.h"
#include "lissom/mesh/point_tree.h"

#include <Eigen/Eigenvalues>

#include <string>
#include <utility>
#include <vector>

namespace lissom {

using Eigen::Vector3d;

namespace {
constexpr double k_line = 1e-6; // middle by largest variance, below which neighbours are on a line
}

Points denoised(const Points& points, int neighbours) {
    if (neighbours < 4) throw InvalidInput("bad-option", "A plane is fitted to " + std::to_string(neighbours) + " points; give 4 or more.");
    Points out = points;
    if (points.rows() < 4) return out;
    const PointTree tree(points);
    std::vector<std::pair<int, double>> near;
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
        const Vector3d p = points.row(i);
        tree.nearest(p, neighbours, near);
        Vector3d middle = Vector3d::Zero();
        for (const auto& [j, d] : near) middle += points.row(j).transpose() - p;
        middle /= static_cast<double>(near.size());
        Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
        for (const auto& [j, d] : near) {
            const Vector3d x = points.row(j).transpose() - p - middle;
            spread += x * x.transpose();
        }
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(spread);
        const Vector3d values = axes.eigenvalues();
        if (!(values[1] > k_line * values[2])) continue;
        const Vector3d normal = axes.eigenvectors().col(0);
        out.row(i) = (p + normal.dot(middle) * normal).transpose();
    }
    return out;
}

} // namespace lissom
