#include "lissom/hair/scalp_roots.h"

#include "lissom/mesh/chance.h"
#include "lissom/mesh/errors.h"
#include "lissom/mesh/operators.h"

#include <algorithm>

namespace lissom {

using Eigen::Vector3d;

namespace {

/// Spreads the lower ten bits of x three places apart.
std::uint32_t spread(std::uint32_t x) {
    x = (x | (x << 16)) & 0x030000ffu;
    x = (x | (x << 8)) & 0x0300f00fu;
    x = (x | (x << 4)) & 0x030c30c3u;
    return (x | (x << 2)) & 0x09249249u;
}

// Fractions of 2^64: the golden ratio, and 1/g, 1/g² with g³ = g + 1 for the two coordinates in a triangle.
constexpr std::uint64_t k_along = 0x9e3779b97f4a7c15u, k_first = 0xc13fa9a902a6328fu, k_second = 0x91e10da5c79e7b1du;

} // namespace

ScalpRoots::ScalpRoots(const TriangleMesh& head, std::span<const int> scalp)
    : head_(head), normals_(vertex_normals(head)), scalp_(static_cast<Eigen::Index>(scalp.size()), 3) {
    std::vector<char> is_scalp(static_cast<std::size_t>(head.vertex_count()), 0);
    for (std::size_t i = 0; i < scalp.size(); ++i) {
        is_scalp.at(static_cast<std::size_t>(scalp[i])) = 1;
        scalp_.row(static_cast<Eigen::Index>(i)) = head.points.row(scalp[i]);
    }
    const Eigen::VectorXd areas = triangle_areas(head);
    for (int t = 0; t < head.triangle_count(); ++t) {
        bool all = areas[t] > 0;
        for (int k = 0; k < 3; ++k) all = all && is_scalp[static_cast<std::size_t>(head.triangles(t, k))];
        if (all) triangles_.push_back(t);
    }
    if (triangles_.empty())
        throw InvalidInput("scalp-empty", "The scalp covers no whole triangle. Paint a larger part of the head.");

    const Vector3d low = scalp_.colwise().minCoeff();
    const double size = (scalp_.colwise().maxCoeff() - scalp_.colwise().minCoeff()).maxCoeff();
    std::vector<std::uint32_t> place(static_cast<std::size_t>(head.triangle_count()));
    for (const int t : triangles_) {
        Vector3d centre = Vector3d::Zero();
        for (int k = 0; k < 3; ++k) centre += head.points.row(head.triangles(t, k)).transpose() / 3;
        const Vector3d q = (centre - low) / size * 1023;
        place[static_cast<std::size_t>(t)] = spread(static_cast<std::uint32_t>(q.x())) |
                                             spread(static_cast<std::uint32_t>(q.y())) << 1 |
                                             spread(static_cast<std::uint32_t>(q.z())) << 2;
    }
    std::stable_sort(triangles_.begin(), triangles_.end(), [&](int a, int b) {
        return place[static_cast<std::size_t>(a)] < place[static_cast<std::size_t>(b)];
    });
    double sum = 0;
    for (const int t : triangles_) area_.push_back(sum += areas[t]);
}

Root ScalpRoots::root(std::uint64_t index, std::uint64_t seed) const {
    const double along = unit(hash_bits(seed, 0, 1) + index * k_along) * area_.back();
    const auto at = std::min<std::size_t>(area_.size() - 1,
                                          static_cast<std::size_t>(std::upper_bound(area_.begin(), area_.end(), along) - area_.begin()));
    double b = unit(hash_bits(seed, 0, 2) + index * k_first), c = unit(hash_bits(seed, 0, 3) + index * k_second);
    if (b + c > 1) { // the other half of the parallelogram, folded over
        b = 1 - b;
        c = 1 - c;
    }
    const int t = triangles_[at];
    const auto mix = [&](const Points& of) -> Vector3d {
        return ((1 - b - c) * of.row(head_.triangles(t, 0)) + b * of.row(head_.triangles(t, 1)) +
                c * of.row(head_.triangles(t, 2))).transpose();
    };
    Vector3d normal = mix(normals_);
    if (!(normal.norm() > 1e-9)) normal = Vector3d::UnitY();
    return {t, b, c, mix(head_.points), normal.normalized()};
}

} // namespace lissom
