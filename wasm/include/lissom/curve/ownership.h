#pragma once

#include "lissom/mesh/topology.h"
#include "lissom/mesh/types.h"

#include <span>
#include <vector>

namespace lissom {

enum class CurveBlending {
    ownership, ///< diffused ownership
    geodesic,  ///< smoothstep of the way to the border, on the surface
    gaussian   ///< the thesis's, about linked control points (Blanco 5.4)
};

/// How much each of several owners has of each vertex.
struct OwnerShares {
    static constexpr int k_most = 4; ///< as many as a vertex of a shader takes

    std::vector<int> offsets{0}; ///< n+1
    std::vector<int> owners;     ///< numbers ≥ 0; largest share first
    std::vector<double> shares;  ///< > 0, summing to 1 over each vertex
};

/// Shares that diffuse from owned vertices over the surface: (M + L_ρ) w = M δ for each owner's indicator δ, with M the vertex areas and L_ρ
/// the positive cotangent Laplacian, the weight of edge ij times ρ_i ρ_j: −∇·(ρ² ∇w). A partition of unity without seams where three owners meet.
///
/// ρ is the distance over which owners blend: the limb's radius at the nearest link. Measured on a person 1.7 m high: 0.06 m looks right, 0.02 leaves a
/// shelf at hip and armpit. A tenth of the vertices (the pelvis) have three owners with more than a hundredth.
/// The least shares go to zero smoothly (each loses a thousandth), so that taking only four leaves no visible step.
/// @param owner  per vertex, ≥ 0
/// @param rho    per vertex, ≥ 0
/// @throws SolverFailure
[[nodiscard]] OwnerShares diffused_shares(const TriangleMesh& mesh, std::span<const int> owner, std::span<const double> rho);

/// Shares by the shortest way to another owner's vertices along edges: smoothstep(½ + g/2ρ) for the owner, the rest for the nearest
/// other. Two owners a vertex; where three meet there is a seam.
[[nodiscard]] OwnerShares geodesic_shares(const TriangleMesh& mesh, std::span<const int> owner, std::span<const double> rho);

/// Each vertex wholly its owner's.
[[nodiscard]] OwnerShares whole_shares(std::span<const int> owner);

/// Ownership cleaned: what an owner has apart from its main piece (the largest of its connected pieces), and what touches others', goes to those
/// around it, from the border inwards. Pieces of the surface of their own stay.
[[nodiscard]] std::vector<int> joined_owners(const VertexRings& rings, std::vector<int> owner);

} // namespace lissom
