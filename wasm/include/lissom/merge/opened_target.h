#pragma once

#include "lissom/merge/optimal_boundary.h"
#include "lissom/merge/part.h"

namespace lissom {

/// The target opened along an outline in the plane of its region: the faces under the outline go, and the gap
/// between it and what is left is filled with triangles as even as the plane allows (Fu 3.3.1: one band is removed and
/// the gap triangulated anew). The outline's points lie on the target's surface.
///
/// @returns a part with one loop: the outline's points, the surface to the left, so they run backwards; its first vertex
///          is the outline's first
/// @throws InvalidInput `outline-crosses-itself`, `target-region-too-small` (no face is left around the outline)
[[nodiscard]] Part open_target(const TriangleMesh& target, const RegionMaps& maps, const PlanePoints& outline, const std::vector<PlanePlace>& places);

/// The triangles between an outer polygon and an inner one in the plane, both counter-clockwise: numbers below
/// `outer.rows()` are the outer's, the others the inner's. Constrained Delaunay but where rounding forbids.
[[nodiscard]] std::vector<std::array<int, 3>> triangulate_band(const PlanePoints& outer, const PlanePoints& inner);

} // namespace lissom
