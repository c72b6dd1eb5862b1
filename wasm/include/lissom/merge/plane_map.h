#pragma once

#include "lissom/mesh/types.h"

#include <array>
#include <span>
#include <vector>

namespace lissom {

using PlanePoints = Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor>; ///< n×2

/// A place in a triangle of a plane map.
struct PlanePlace {
    int triangle = -1; ///< −1: outside
    std::array<double, 3> weight{};
};

/// Finds the triangles of a plane map that points lie in, by a grid of cells about one triangle wide.
class PlaneLocator {
public:
    /// @param points,triangles  kept by reference
    PlaneLocator(const PlanePoints& points, const Triangles& triangles);

    /// @param nearest  where the point is outside (or in a gap that rounding made): the nearest place on the map
    [[nodiscard]] PlanePlace locate(const Eigen::Vector2d& point, bool nearest = false) const;

private:
    [[nodiscard]] PlanePlace in_triangle(int t, const Eigen::Vector2d& point) const;
    [[nodiscard]] int cell(double value, int axis) const;

    const PlanePoints& points_;
    const Triangles& triangles_;
    Eigen::Vector2d low_;
    double size_ = 1;
    std::array<int, 2> count_{1, 1};
    std::vector<int> offsets_, entries_;
};

/// Harmonic map of a disk with its border fixed: the weights are all equal, so that a convex border gives a valid map
/// whatever the triangles (Tutte 1963).
/// @param fixed  vertices, and where they go
[[nodiscard]] PlanePoints tutte_map(const TriangleMesh& mesh, std::span<const int> fixed, const PlanePoints& where);

/// Least squares conformal map of a disk (Lévy et al. 2002), own assembly on our Cholesky: the least Σ |∇u⊥ − ∇v|² area,
/// with two border vertices far apart pinned. Normalised: centroid of the area at the origin, area π, and pinned
/// vertices along x. Orientation is kept.
/// @throws SolverFailure
[[nodiscard]] PlanePoints conformal_map(const TriangleMesh& mesh, const std::vector<int>& border);

} // namespace lissom
