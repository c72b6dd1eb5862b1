#pragma once

#include "lissom/mesh/types.h"

#include <vector>

namespace lissom {

/// Whether a polygon can be drawn, and if not, why.
enum class FaceVerdict {
    usable,
    out_of_range, ///< a corner names no vertex
    not_finite,   ///< a corner has no finite position
    too_small     ///< fewer than three different corners
};

/// True for each vertex whose coordinates are numbers that can be computed with: finite, and below 1e100 so
/// that their squares are.
[[nodiscard]] std::vector<bool> finite_vertices(const Points& points);

/// @param finite  of `finite_vertices(source.points)`
[[nodiscard]] FaceVerdict face_verdict(const PolygonMesh& source, int face, const std::vector<bool>& finite);

struct Triangulation {
    Triangles triangles;                  ///< source indices
    std::vector<int> polygon_of_triangle; ///< faces in file order
};

/// The triangles of each polygon, in source indices: quads along their better diagonal (one that lies inside,
/// then the shorter one), larger polygons by ear clipping in their best-fit plane, shortest cut first; never
/// fewer than k − 2 triangles for k different corners. Ties fall to the corner that comes first in the face,
/// so neither renumbering the vertices nor a rigid motion matters. Polygons that are not usable give none.
///
/// Concave, non-planar, self-touching and self-crossing polygons all end; the last are covered somehow.
/// Cost: linear in triangles and quads; for a polygon of k corners about k log k.
[[nodiscard]] Triangulation triangulate(const PolygonMesh& source);

} // namespace lissom
