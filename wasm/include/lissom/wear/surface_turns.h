#pragma once

#include "lissom/mesh/types.h"

#include <Eigen/Geometry>

#include <vector>

namespace lissom {

/// How the surface around each vertex turns as its vertices move: the rotation nearest to the mean, by area, of its triangles' linear maps
/// with their normals. The identity where no triangle tells.
/// @param to  n×3, where the vertices go
[[nodiscard]] std::vector<Eigen::Matrix3d> surface_turns(const TriangleMesh& from, const Points& to);

} // namespace lissom
