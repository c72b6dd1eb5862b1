#pragma once

#include "lissom/match/match_session.h"

#include "placed_model.h"

namespace lissom {

/// What a skin is worth on its model, both at unit size; what the session alone knows is left out.
/// @param masked  one flag per vertex of the skin, or none: fitted to nothing. @param whole  what the model ignores counts all the same
[[nodiscard]] SkinReport skin_report(const TriangleMesh& skin, const PlacedModel& model, const std::vector<char>& masked, bool whole);

/// Largest distance of a marker's vertex from its place, a share of the diagonal. @param markers  at unit size
[[nodiscard]] double marker_error(const SkinSet& skins, int skin, const Points& markers, const PlacedModel& model);

} // namespace lissom
