#pragma once

#include "lissom/mesh/types.h"

#include <Eigen/Core>

#include <vector>

namespace lissom {

/// [e₁ e₂ n] of a triangle, n of unit length: how its rest frame maps to its moved one is the linear map that it underwent,
/// normals included, so that even a single flat triangle tells its rotation.
[[nodiscard]] Eigen::Matrix3d triangle_frame(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c);

/// F_t = [e₁′ e₂′ n′] [e₁ e₂ n]⁻¹ of each triangle; the identity for one without area at rest.
[[nodiscard]] std::vector<Eigen::Matrix3d> triangle_gradients(const TriangleMesh& rest, const Points& moved);

/// The rotation nearest to the area-weighted mean of F_t around each vertex; the identity where there is no area.
/// Of rank three whatever the surface, unlike rotations fitted to normals or edges.
[[nodiscard]] std::vector<Eigen::Matrix3d> vertex_rotations(const TriangleMesh& rest, const Points& moved);

} // namespace lissom
