#pragma once

#include "lissom/match/fit_surface.h"

#include <vector>

namespace lissom {

/// How far a vertex is brought onto its surface at most, at unit size.
constexpr double k_projection_reach = 0.03;

/// Each vertex at its nearest place of the surface that faces as it does and is in reach; vertices of the skin's border at their nearest place of the rim.
/// @param kept  per vertex: it stays. @param everywhere  also where the surface is ignored
[[nodiscard]] Points projected(const FitSurface& surface, const TriangleMesh& skin, double least_cosine, const std::vector<char>& kept, bool everywhere = false);

} // namespace lissom
