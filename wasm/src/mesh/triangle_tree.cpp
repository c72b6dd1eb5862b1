#include "lissom/mesh/triangle_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

namespace lissom {

using Eigen::Vector3d;

namespace {

/// The lower ten bits of x, two zeros between each.
std::uint32_t spread(std::uint32_t x) {
    x = (x | (x << 16)) & 0x030000ff;
    x = (x | (x << 8)) & 0x0300f00f;
    x = (x | (x << 4)) & 0x030c30c3;
    return (x | (x << 2)) & 0x09249249;
}

/// Stable sort of `order` by 30-bit keys, ten bits a pass.
void radix_sort(std::vector<int>& order, const std::vector<std::uint32_t>& keys) {
    std::vector<int> other(order.size());
    for (int shift = 0; shift < 30; shift += 10) {
        std::array<std::size_t, 1025> start{};
        for (const int t : order) ++start[(keys[t] >> shift & 1023) + 1];
        for (std::size_t k = 1; k < start.size(); ++k) start[k] += start[k - 1];
        for (const int t : order) other[start[keys[t] >> shift & 1023]++] = t;
        order.swap(other);
    }
}

} // namespace

TriangleTree::TriangleTree(const TriangleMesh& mesh) : mesh_(&mesh) {
    const auto corner = [&](int t, int k) -> Vector3d { return mesh.points.row(mesh.triangles(t, k)); };
    std::vector<std::uint32_t> keys(static_cast<std::size_t>(mesh.triangle_count()));
    Box all;
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        const Vector3d sum = corner(t, 0) + corner(t, 1) + corner(t, 2);
        if (!sum.allFinite()) continue;
        order_.push_back(t);
        all.extend((sum / 3).eval());
    }
    const Vector3d cells = all.isEmpty() ? Vector3d::Zero() : (all.sizes().array() > 0).select(1023.999 / all.sizes().array(), 0).matrix().eval();
    for (const int t : order_) {
        const Vector3d at = ((corner(t, 0) + corner(t, 1) + corner(t, 2)) / 3 - all.min()).cwiseProduct(cells);
        keys[t] = spread(static_cast<std::uint32_t>(at.x())) | spread(static_cast<std::uint32_t>(at.y())) << 1 |
                  spread(static_cast<std::uint32_t>(at.z())) << 2;
    }
    radix_sort(order_, keys);
    levels_.emplace_back((order_.size() + k_leaf - 1) / k_leaf);
    for (std::size_t i = 0; i < order_.size(); ++i)
        for (int k = 0; k < 3; ++k) levels_[0][i / k_leaf].extend(corner(order_[i], k));
    while (levels_.back().size() > 1) {
        const std::vector<Box>& below = levels_.back();
        std::vector<Box> level((below.size() + 1) / 2);
        for (std::size_t i = 0; i < below.size(); ++i) level[i / 2].extend(below[i]);
        levels_.push_back(std::move(level));
    }
}

template <class Meets, class Leaf>
void TriangleTree::visit(Meets meets, Leaf leaf) const {
    if (order_.empty()) return;
    std::vector<std::pair<std::size_t, std::size_t>> open{{levels_.size() - 1, 0}};
    while (!open.empty()) {
        const auto [level, block] = open.back();
        open.pop_back();
        if (!meets(levels_[level][block])) continue;
        if (level == 0) {
            const std::size_t end = std::min((block + 1) * k_leaf, order_.size());
            for (std::size_t i = block * k_leaf; i < end; ++i) leaf(order_[i]);
            continue;
        }
        for (const std::size_t child : {2 * block, 2 * block + 1})
            if (child < levels_[level - 1].size()) open.emplace_back(level - 1, child);
    }
}

std::vector<RayHit> TriangleTree::hits(const Vector3d& origin, const Vector3d& direction) const {
    std::vector<RayHit> found;
    const double length = direction.norm();
    if (!(length > 0) || !std::isfinite(length) || !origin.allFinite() || order_.empty()) return found;
    const Box& all = levels_.back()[0];
    const double slack = 1e-12 * (all.sizes().norm() + (all.center() - origin).norm()); // rounding of positions on the ray
    const auto meets = [&](const Box& box) {
        double near = 0, far = std::numeric_limits<double>::infinity();
        for (int axis = 0; axis < 3; ++axis) {
            const double low = box.min()[axis] - slack - origin[axis], high = box.max()[axis] + slack - origin[axis];
            if (direction[axis] == 0) {
                if (low > 0 || high < 0) return false;
                continue;
            }
            const double a = low / direction[axis], b = high / direction[axis];
            near = std::max(near, std::min(a, b));
            far = std::min(far, std::max(a, b));
        }
        return near <= far;
    };
    visit(meets, [&](int t) {
        const Vector3d a = mesh().points.row(mesh().triangles(t, 0)), b = mesh().points.row(mesh().triangles(t, 1)),
                       c = mesh().points.row(mesh().triangles(t, 2));
        const Vector3d ab = b - a, ac = c - a, p = direction.cross(ac), to = origin - a;
        const double determinant = ab.dot(p);
        if (std::abs(determinant) <= 1e-14 * length * ab.norm() * ac.norm()) return; // seen edge on
        constexpr double border = -1e-10;
        const double u = to.dot(p) / determinant;
        const Vector3d q = to.cross(ab);
        const double v = direction.dot(q) / determinant, depth = ac.dot(q) / determinant;
        if (u >= border && v >= border && u + v <= 1 - border && depth >= 0) found.push_back({depth, t});
    });
    std::sort(found.begin(), found.end(), [](const RayHit& x, const RayHit& y) { return std::pair(x.depth, x.triangle) < std::pair(y.depth, y.triangle); });
    return found;
}

std::vector<int> TriangleTree::crossed(const Vector3d& normal, double offset) const {
    std::vector<int> found;
    const auto meets = [&](const Box& box) {
        if (box.isEmpty()) return false;
        const double centre = normal.dot(box.center()) - offset, reach = normal.cwiseAbs().dot(box.sizes()) / 2 * (1 + 1e-12) + 1e-14 * std::abs(offset);
        return std::abs(centre) <= reach;
    };
    visit(meets, [&](int t) {
        int above = 0;
        for (int k = 0; k < 3; ++k) above += mesh().points.row(mesh().triangles(t, k)).dot(normal) > offset ? 1 : 0;
        if (above == 1 || above == 2) found.push_back(t);
    });
    std::sort(found.begin(), found.end());
    return found;
}

TriangleTree::Nearest TriangleTree::nearest(const Vector3d& p) const {
    return nearest_where(p, std::numeric_limits<double>::infinity(), -1, [](int) { return true; });
}

} // namespace lissom
