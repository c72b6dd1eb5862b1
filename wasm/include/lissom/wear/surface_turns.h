#pragma once

#include "lissom/mesh/types.h"

#include <Eigen/Geometry>

#include <vector>

namespace lissom {

/// The linear map of each triangle with its normal, which grows as the triangle does: of a surface that only turns and grows it is that turn and
/// growth. Zero of a triangle that tells none (a needle, or one that becomes a line).
/// @param to  n×3, where the vertices go
[[nodiscard]] std::vector<Eigen::Matrix3d> surface_maps(const TriangleMesh& from, const Points& to);

/// How the surface around each vertex turns as its vertices move: the rotation nearest to the mean, by area, of its triangles' linear maps
/// with their normals. The identity where no triangle tells.
/// @param to  n×3, where the vertices go
[[nodiscard]] std::vector<Eigen::Matrix3d> surface_turns(const TriangleMesh& from, const Points& to);

} // namespace lissom
