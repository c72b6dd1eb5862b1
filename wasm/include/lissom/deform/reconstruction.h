#pragma once

#include "lissom/deform/held_region.h"
#include "lissom/deform/normal_equations.h"

namespace lissom {

/// The second system, D(ṽ_i) = R_i s_i δ_i (Eq 2.10/2.11), in displacements u = ṽ − v:
///
///     minimise Σ_i ω_i |(L u)_i − (s_i R_i − I) δ_i|²,   δ = L v,   ω_i = mean area / area_i
///
/// over the free vertices, the points and the rows of handle and fixed vertices beside them. Those rim rows are why
/// this is least squares and not the square Poisson system: they carry the handles' orientation, without them
/// the surface meets a handle with a crease (and the errors gather there, Fu 2.4.3, end).
struct Reconstruction {
    NormalEquations equations;
    Eigen::SparseMatrix<double, Eigen::RowMajor> T; ///< unknowns × slots: Lᵀ diag(ω), the right-hand side of the rows
    Points delta;                                   ///< δ of each slot
};

/// @param L     cotangent Laplacian of region.mesh
/// @param areas vertex areas of region.mesh
[[nodiscard]] Reconstruction reconstruction(const HeldRegion& region, const SparseMatrix& L, const Eigen::VectorXd& areas);

} // namespace lissom
