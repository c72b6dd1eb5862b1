#pragma once

#include "lissom/match/match_session.h"

#include "placed_model.h"

namespace lissom {

/// What a skin is worth on its model, both at unit size; what the session alone knows is left out.
[[nodiscard]] SkinReport skin_report(const TriangleMesh& skin, const PlacedModel& model);

/// Largest distance of a marker's vertex from its place, a share of the diagonal. @param markers  at unit size
[[nodiscard]] double marker_error(const SkinSet& skins, int skin, const Points& markers, const PlacedModel& model);

} // namespace lissom
