#pragma once

#include "lissom/mesh/types.h"

#include <vector>

namespace lissom {

/// Which triangles to turn over so that neighbours agree, and what stands in the way.
struct Orientation {
    std::vector<bool> turned;        ///< per triangle: turn it
    std::vector<int> inconsistent;   ///< triangles turned because they disagreed with their patch
    std::vector<int> inside_out;     ///< triangles turned because their whole closed patch faced inward
    std::vector<int> one_sided;      ///< the first triangle of each patch that cannot be oriented
};

/// Walks each patch (triangles joined by edges of exactly two) and makes its triangles agree.
///
/// A closed patch that disagreed comes out facing outward (positive volume); an open one as the larger part of
/// its triangles faced. A closed patch that agreed but faces inward is turned, unless it lies in the box of
/// the largest closed patch: there it may be a cavity, which must face that way. A one-sided patch keeps its
/// triangles unless turning some leaves fewer edges in conflict.
/// Cost: linear.
[[nodiscard]] Orientation orient(const TriangleMesh& mesh);

} // namespace lissom
