#pragma once

// The plain shapes that every room of the kernel passes around.

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <vector>

namespace lissom {

using Points = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>; ///< n×3, one point a row
using Triangles = Eigen::Matrix<int, Eigen::Dynamic, 3, Eigen::RowMajor>; ///< m×3 vertex indices
using SparseMatrix = Eigen::SparseMatrix<double>;                         ///< column-major, int indices

/// Triangles over points: what the solvers see. Indices lie in [0, n).
struct TriangleMesh {
    Points points;
    Triangles triangles;

    [[nodiscard]] int vertex_count() const { return static_cast<int>(points.rows()); }
    [[nodiscard]] int triangle_count() const { return static_cast<int>(triangles.rows()); }
};

/// Polygons over points, as a file gave them. Face f has corners[offsets[f] .. offsets[f+1]).
struct PolygonMesh {
    Points points;            ///< n×3, any unit, may hold NaN or infinity
    std::vector<int> offsets; ///< m+1, starts at 0, never falls
    std::vector<int> corners; ///< vertex indices, may be out of range

    [[nodiscard]] int vertex_count() const { return static_cast<int>(points.rows()); }
    [[nodiscard]] int face_count() const { return offsets.empty() ? 0 : static_cast<int>(offsets.size()) - 1; }
};

} // namespace lissom
