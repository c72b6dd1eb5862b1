#pragma once

#include "lissom/mesh/types.h"

#include <array>
#include <memory>
#include <span>
#include <vector>

namespace lissom {

/// Where a surface crosses itself.
struct SelfIntersections {
    int pairs = 0;              ///< pairs of triangles without a common vertex that meet
    std::vector<int> triangles; ///< all that belong to one, ascending
};

/// Counts triangles that meet others they share no vertex with; touching counts. Decided by exact predicates: no pair is
/// missed or made up by rounding.
///
/// Triangles with a corner that is not finite, or with two equal indices, meet nothing. Triangles that share a vertex are neighbours by
/// construction and are not looked at; weld a soup before.
/// Cost: a tree of boxes walked against itself, about n log n.
[[nodiscard]] SelfIntersections self_intersections(const TriangleMesh& mesh);

/// The same again and again while a surface moves: the tree is made once, its boxes follow the points.
class IntersectionFinder {
public:
    enum class Neighbours {
        left_out, ///< as `self_intersections`
        looked_at ///< triangles with one common vertex count too where the side opposite it goes through the other triangle; not where they lie in one plane but for rounding
    };

    /// @param mesh  where the surface is at first; only its triangles are kept
    explicit IntersectionFinder(const TriangleMesh& mesh, Neighbours neighbours = Neighbours::left_out);
    ~IntersectionFinder();
    IntersectionFinder(IntersectionFinder&&) noexcept;
    IntersectionFinder& operator=(IntersectionFinder&&) noexcept;

    /// @param points  as many as the mesh had
    [[nodiscard]] SelfIntersections find(const Points& points);
    /// Only pairs to which at least one of some triangles belongs.
    [[nodiscard]] SelfIntersections find(const Points& points, std::span<const int> triangles);

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// Whether two triangles have a point in common; exact.
[[nodiscard]] bool triangles_meet(const std::array<Eigen::Vector3d, 3>& a, const std::array<Eigen::Vector3d, 3>& b);

} // namespace lissom
