#pragma once

#include "lissom/mesh/topology.h"

namespace lissom {

/// What each vertex is smoothed by: its ring, or on a border its neighbours along it, so that borders neither shrink nor curl.
[[nodiscard]] VertexRings smoothing_rings(const TriangleMesh& mesh);

/// The mean of a vertex's neighbours; the vertex itself where it has none.
[[nodiscard]] Eigen::RowVector3d ring_mean(const Points& points, const VertexRings& rings, int v);

} // namespace lissom
