#include "lissom/hair/scalp_shell.h"

#include <algorithm>

namespace lissom {

using Eigen::Vector3d;

namespace {

constexpr double k_inside = 0.35, k_outside = 1.2; // how far from the surface the shell's nodes lie, in grid steps
constexpr double k_magnitude = 0.3;                // small, to reduce global influence (Fu 4.6)

/// Whether any of `points` lies within `radius` of p.
bool is_near(const Vector3d& p, const Points& points, double radius) {
    return points.rows() > 0 && (points.rowwise() - p.transpose()).rowwise().squaredNorm().minCoeff() <= radius * radius;
}

} // namespace

std::vector<int> scalp_shell(const Grid& grid, const HeadDistance& head, const Points& scalp, double near,
                             std::size_t limit) {
    const Vector3d low = scalp.colwise().minCoeff().transpose().array() - near - 2 * grid.step;
    const Vector3d high = scalp.colwise().maxCoeff().transpose().array() + near + 2 * grid.step;
    std::vector<int> shell;
    for (int node = 0; node < grid.count(); ++node) {
        const Vector3d p = grid.position(node);
        if ((p.array() < low.array()).any() || (p.array() > high.array()).any()) continue;
        const double distance = head.at(p) / grid.step;
        if (distance < -k_inside || distance > k_outside || !is_near(p, scalp, near + k_outside * grid.step)) continue;
        shell.push_back(node);
    }
    for (int round = 0; shell.size() > limit && round < 8; ++round) // every other node of a finer and finer board
        std::erase_if(shell, [&](int node) {
            const Eigen::Vector3i c = grid.cell(node);
            return round == 0 ? (c.sum() & 1) != 0 : (c[round % 3] >> (round / 3)) & 1;
        });
    return shell;
}

std::vector<FieldConstraint> shell_constraints(const std::vector<int>& shell, const Points& field, const Grid& grid,
                                               const HeadDistance& head) {
    std::vector<FieldConstraint> out;
    out.reserve(shell.size());
    for (std::size_t i = 0; i < shell.size(); ++i) {
        Vector3d t = field.row(static_cast<Eigen::Index>(i));
        const Vector3d normal = head.gradient(grid.position(shell[i])).normalized();
        if (t.dot(normal) < 0) t -= t.dot(normal) * normal;
        const double length = t.norm();
        out.push_back({shell[i], length > 1e-9 ? Vector3d(k_magnitude / length * t) : Vector3d::Zero()});
    }
    return out;
}

} // namespace lissom
