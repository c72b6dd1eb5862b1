#pragma once

#include "lissom/mesh/topology.h"

#include <Eigen/Core>

#include <vector>

namespace lissom {

/// The deformation gradients M_i as linear functions of the deformed positions (Eq 2.5):
/// M_i = Σ_k ṽ′_k c_ikᵀ over i and its ring, where v′ are the rest positions with degenerate vertices displaced
/// (Eq 2.9). Σ_k c_ik = 0 and Σ_k v′_k c_ikᵀ = I, so that a common affine map gives exactly its linear part.
struct RingGradients {
    std::vector<int> offsets;        ///< n+1; a row is empty for a vertex without a gradient of its own
    std::vector<int> vertices;       ///< k of each coefficient
    Points coefficients;             ///< c_ik, 1/length
    Points rest;                     ///< n×3, v′
    std::vector<int> displaced;      ///< where v′ differs from v, ascending
    int borrowed = 0;                ///< rows taken from a neighbour, for want of any usable ring
};

/// What may be displaced and what needs a gradient, per vertex.
struct GradientNeeds {
    std::vector<char> wanted;  ///< 1: a gradient is needed
    std::vector<char> movable; ///< 1: Eq 2.9 may displace it (free vertices)
};

/// A vertex whose ring lies in a plane or a line has no gradient: cond(V Vᵀ) > 2e5. Such vertices are displaced
/// along the normal *one after the other*, each tested against those displaced before it (all at once would
/// merely shift a flat side). Where displacing the vertex does not help (valence 2 or collinear
/// neighbours at a boundary), a neighbour is displaced instead, then the 2-ring takes the ring's place, which stands
/// in for the vertex that Fu inserts; and where nothing helps the gradient of a neighbour is used.
///
/// The order is by valence and position, not by index, so that re-indexing the vertices changes nothing.
[[nodiscard]] RingGradients ring_gradients(const TriangleMesh& mesh, const VertexRings& rings, const GradientNeeds& needs);

} // namespace lissom
