#pragma once

#include "lissom/mesh/types.h"

#include <array>
#include <span>
#include <string>
#include <vector>

namespace lissom {

/// Where a point of a changed mesh lies on the mesh it came from: weights on at most three vertices of one of its
/// triangles. Unused entries have weight 0 and repeat the first vertex.
struct Origin {
    std::array<int, 3> vertex{};
    std::array<double, 3> weight{1, 0, 0};

    [[nodiscard]] static Origin of(int v) { return {{v, v, v}, {1, 0, 0}}; }
    [[nodiscard]] bool is_vertex() const { return weight[0] == 1; }
};

/// The point at `fraction` of the way from a to b, which lie on one triangle.
[[nodiscard]] Origin between(const Origin& a, const Origin& b, double fraction);

/// One loop along which an input is to be joined.
struct BoundaryLoop {
    std::vector<int> vertices; ///< in either direction, closed by itself; neighbours are joined by edges
    /// Vertices of the side to keep (a painted region), where the loop is a path across the surface. Empty: the side
    /// to the left of the path.
    std::vector<int> keep;
};

/// What is left of an input once it is cut along its loops, with the way back.
struct Part {
    TriangleMesh mesh;
    std::vector<Origin> origin;           ///< per vertex, in vertices of the input
    std::vector<int> triangle_origin;     ///< per triangle, of the input
    std::vector<char> is_whole;           ///< per triangle: it is that triangle, not a piece of it
    std::vector<std::vector<int>> loops;  ///< part vertices, the surface to the left
};

/// Cuts the input along closed edge paths and keeps one side of each; loops on an open boundary keep all there is.
/// Pieces of the input that no path reaches are kept.
///
/// @param name  of the input, as messages call it: "source" or "target"
/// @throws InvalidInput `vertex-out-of-range`, `loop-too-short`, `loop-touches-itself`, `loops-touch`,
///   `loop-not-connected` (two neighbours in it share no edge), `loop-non-manifold` (an edge of three triangles),
///   `loop-two-sided` (keeps its left here and its right there), `loop-not-separating` (both sides are one piece),
///   `keep-side-unclear` (the vertices to keep lie on both sides), `loop-touches-boundary`, `nothing-kept`
[[nodiscard]] Part cut_part(const TriangleMesh& input, std::span<const BoundaryLoop> loops, const std::string& name);

/// Closed paths around a painted region: the boundary of the triangles whose three vertices are painted, without
/// the mesh's own boundary edges. Each has the region to its left. Fit for `BoundaryLoop`.
[[nodiscard]] std::vector<std::vector<int>> loops_around(const TriangleMesh& mesh, std::span<const int> region);

} // namespace lissom
