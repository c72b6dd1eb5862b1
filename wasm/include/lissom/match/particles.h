#pragma once

#include "lissom/match/fit_surface.h"
#include "lissom/mesh/types.h"

#include <vector>

namespace lissom {

/// The weights of Eq 1: α stays, β falls, γ is what is left to 1.
struct ParticleWeights {
    double stay = 0.3;   ///< α, as the paper chooses it
    double smooth = 0.5; ///< β
    double move = 1;     ///< w_m of Eq 2, of the way to the tracking position

    /// β of a pass, counted from 0: the paper asks for one that decays and gives none. Ours is 0.5 e^(−pass/20), no less than 0.02.
    [[nodiscard]] static ParticleWeights at(int pass);
};

/// Where the particles of a skin go in one pass of the paper's own loop: v = α v₀ + β v_c + γ v_t (Skins Eq 1) with v_c the centre of the ring, on a border along it,
/// and v_t = v₀ + w_m d_s v_trk (Eq 2, on the surface itself: r_s = 0) towards the nearest place, asked for over the whole surface.
///
/// Source: Wang et al., "Duplicate-Skins for Compatible Mesh Modelling" (004), 2 and 3.1. Nothing keeps a skin from folding or from crossing itself.
/// @param held  one flag per vertex: stays, as markers do
/// Cost: a nearest place per vertex.
[[nodiscard]] Points repositioned(const TriangleMesh& skin, const FitSurface& surface, const std::vector<char>& held, const ParticleWeights& weights);

} // namespace lissom
