#pragma once

#include "lissom/mesh/nearest_on_triangle.h"
#include "lissom/mesh/types.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
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
        int feature = 6; ///< of the triangle, see NearestOnTriangle
    };
    [[nodiscard]] Nearest nearest(const Eigen::Vector3d& p) const;

    /// The nearest of those triangles that `accepts(triangle)`, no farther than `reach`; where several are equally near the smallest.
    /// @param hint  a triangle that may be near, or −1: saves time and changes nothing
    template <class Accept>
    [[nodiscard]] Nearest nearest_where(const Eigen::Vector3d& p, double reach, int hint, Accept accepts) const;

private:
    using Box = Eigen::AlignedBox3d;

    [[nodiscard]] const TriangleMesh& mesh() const { return *mesh_; }
    /// Calls `leaf(triangle)` for each triangle in a box that `meets`.
    template <class Meets, class Leaf>
    void visit(Meets meets, Leaf leaf) const;

    const TriangleMesh* mesh_;
    std::vector<int> order_;                ///< triangles along the curve
    std::vector<std::vector<Box>> levels_;  ///< boxes of blocks: [0] of leaves, each further level half as many

    static constexpr std::size_t k_leaf = 4; ///< triangles of a leaf
};

template <class Accept>
TriangleTree::Nearest TriangleTree::nearest_where(const Eigen::Vector3d& p, double reach, int hint, Accept accepts) const {
    Nearest best;
    if (order_.empty() || !p.allFinite()) return best;
    double least = reach * reach;
    const auto look_at = [&](int t) {
        if (!accepts(t)) return;
        const auto corners = mesh().triangles.row(t);
        const NearestOnTriangle at = nearest_on_triangle(p, mesh().points.row(corners[0]), mesh().points.row(corners[1]), mesh().points.row(corners[2]));
        const double squared = (at.point - p).squaredNorm();
        if (!(squared < least || (squared == least && (best.triangle < 0 || t < best.triangle)))) return;
        least = squared;
        best = {t, std::sqrt(squared), at.point, at.feature};
    };
    if (hint >= 0) look_at(hint);
    // Without branches, and once for each box.
    const auto squared_distance = [&](const Box& box) { return (box.min() - p).cwiseMax(p - box.max()).cwiseMax(0.0).squaredNorm(); };
    struct Open {
        std::size_t level, block;
        double squared;
    };
    std::array<Open, 72> open; // a path down and a sibling a level: no more than two a bit of an index
    std::size_t count = 0;
    open[count++] = {levels_.size() - 1, 0, 0};
    while (count > 0) {
        const auto [level, block, squared] = open[--count];
        if (squared > least) continue;
        if (level == 0) {
            const std::size_t end = std::min((block + 1) * k_leaf, order_.size());
            for (std::size_t i = block * k_leaf; i < end; ++i)
                if (order_[i] != hint) look_at(order_[i]);
            continue;
        }
        const std::vector<Box>& below = levels_[level - 1];
        const std::size_t a = 2 * block, b = a + 1;
        const double to_a = squared_distance(below[a]), to_b = b < below.size() ? squared_distance(below[b]) : std::numeric_limits<double>::infinity();
        // The nearer child is looked at first: it goes on the stack last.
        const bool a_first = to_a <= to_b;
        const Open nearer = a_first ? Open{level - 1, a, to_a} : Open{level - 1, b, to_b}, farther = a_first ? Open{level - 1, b, to_b} : Open{level - 1, a, to_a};
        if (farther.squared <= least && farther.block < below.size()) open[count++] = farther;
        if (nearer.squared <= least) open[count++] = nearer;
    }
    return best;
}

} // namespace lissom
