#pragma once

#include "lissom/mesh/types.h"

namespace lissom {

/// Weights of a triangle's corners at a place on it, summing to 1, none negative; (1, 0, 0) of a triangle without area.
[[nodiscard]] Eigen::Vector3d corner_weights(const TriangleMesh& mesh, int triangle, const Eigen::Vector3d& place);

} // namespace lissom
