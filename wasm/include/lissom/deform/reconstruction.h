#pragma once

#include "lissom/deform/held_region.h"
#include "lissom/deform/normal_equations.h"

namespace lissom {

/// The second system, D(ṽ_i) = R_i s_i δ_i (Eq 2.10/2.11), in displacements u = ṽ − v:
///
///     minimise Σ_i ω_i |(L u)_i − (s_i R_i − I) δ_i|²,   δ = L v,   ω_i = mean area / area_i
///
/// over the free vertices, the points and the rows of handle and fixed vertices beside them. Those rim rows are
/// why this is least squares and not the square Poisson system: they carry the handles' orientation, without
/// them the surface meets a handle with a crease. Measured on the bar of 2,050 vertices, edge-length rms and volume:
/// twist by 120 degrees 0.050, 0.93 against 0.071, 0.93 of the Poisson system; bend by 135 degrees 0.088, 0.92
/// against 0.170, 0.67. The exponent of ω (0, 1, 2) changes no digit of these.
struct Reconstruction {
    NormalEquations equations;
    Eigen::SparseMatrix<double, Eigen::RowMajor> T; ///< unknowns × slots: Lᵀ diag(ω), the right-hand side of the rows
    Points delta;                                   ///< δ of each slot
};

/// @param L     cotangent Laplacian of region.mesh
/// @param areas vertex areas of region.mesh
/// @param rows  receives the rows themselves; then the equations are left out
[[nodiscard]] Reconstruction reconstruction(const HeldRegion& region, const SparseMatrix& L, const Eigen::VectorXd& areas, RowPair* rows = nullptr);

} // namespace lissom
