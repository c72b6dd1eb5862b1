#pragma once

#include "lissom/deform/held_region.h"
#include "lissom/deform/normal_equations.h"
#include "lissom/deform/ring_gradients.h"

namespace lissom {

/// Everything about Eq 2.6–2.8 that does not change during a drag.
///
/// Unknown are the *displacements* u = ṽ′ − v′ of the free vertices, and handles give W − I: so resting
/// handles give u = 0 to the last bit, and far moves lose no digits of the rest pose.
struct ImplicitSystem {
    NormalEquations equations;  ///< of E_L + E_R in u; x, y and z alike
    RingGradients gradients;    ///< by vertex of the region

    /// M − I of a slot is Σ u_k c_kᵀ over [offsets[slot], offsets[slot+1]), or (W − I) of `gradient_handle`.
    std::vector<int> offsets;   ///< slots + 1
    std::vector<int> slots;     ///< k, a slot each: fixed vertices do not move and are left out
    Points coefficients;        ///< c_k
    std::vector<int> gradient_handle; ///< per slot; −1: its own ring (an empty one is the identity)

    /// E_T of blended vertices: its right-hand side is `blends` times (blend_scale ∘ detail − blend_rest).
    Eigen::SparseMatrix<double, Eigen::RowMajor> blends; ///< unknowns × blended
    Eigen::VectorXd blend_scale;
    Points blend_rest;

    std::vector<int> displaced; ///< slots where v′ ≠ v, ascending
    Points displacement;        ///< v′ − v of those
};

/// @param L     cotangent Laplacian of region.mesh
/// @param areas vertex areas of region.mesh
/// @param coherence_ring 1 or 2, SF of Eq 2.7
/// @param blended  vertices of the region with a row of E_T; @param blend_weight  w_T
/// @param rows     receives the rows themselves; then the equations are left out
[[nodiscard]] ImplicitSystem implicit_system(const HeldRegion& region, const SparseMatrix& L, const Eigen::VectorXd& areas, int coherence_ring,
                                             std::span<const int> blended = {}, double blend_weight = 0, RowPair* rows = nullptr);

} // namespace lissom
