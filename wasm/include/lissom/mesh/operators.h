#pragma once

#include "lissom/mesh/types.h"

#include <Eigen/Geometry>

namespace lissom {

/// Bounding box diagonal of the points; 0 for fewer than two.
[[nodiscard]] double diagonal(const Points& points);

/// Mean length of the undirected edges; 0 without triangles.
[[nodiscard]] double mean_edge_length(const TriangleMesh& mesh);

/// Area of each triangle (unit²).
[[nodiscard]] Eigen::VectorXd triangle_areas(const TriangleMesh& mesh);

/// Signed volume enclosed by the triangles (unit³); meaningful for a closed surface.
[[nodiscard]] double signed_volume(const TriangleMesh& mesh);

/// Unit normals per vertex, weighted by corner angle; zero where no triangle has area.
[[nodiscard]] Points vertex_normals(const TriangleMesh& mesh);

/// Mixed Voronoi area of each vertex (Meyer et al. 2003), floored at a millionth of the mean so that no
/// division by it can run away. Sums to the surface area but for that floor.
[[nodiscard]] Eigen::VectorXd vertex_areas(const TriangleMesh& mesh);

/// Cotangent Laplacian stiffness, n×n, symmetric, negative semi-definite, rows sum to zero:
/// L_ij = ½(cot α_ij + cot β_ij) off the diagonal. No unit. Cotangents are those of triangles whose area
/// is floored relative to their longest edge (height at least 1e-4 of it), so needles and zero-area triangles
/// give weights of at most 1e4 and the matrix stays semi-definite.
/// The edge weight may be negative where the mesh is not Delaunay.
[[nodiscard]] SparseMatrix cotangent_laplacian(const TriangleMesh& mesh);

} // namespace lissom
