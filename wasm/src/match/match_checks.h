#pragma once

#include "lissom/match/match_session.h"

#include "placed_model.h"

#include <string>
#include <vector>

namespace lissom {

/// @throws InvalidInput `model-count`, `bad-option`
void check_options(const std::vector<MatchModel>& models, const MatchOptions& options);
/// @throws InvalidInput `curve-count`, `bad-curve`
void check_curves(const std::vector<MatchModel>& models);

/// What nothing can be right about whatever the markers are: codes of what a source and a target differ in.
[[nodiscard]] std::vector<const char*> differences(const PlacedModel& source, const PlacedModel& target);

/// Whether a plane through the origin has all markers on one side of it, by some margin.
[[nodiscard]] bool one_sided(const Points& markers, double margin);

/// What a model is called in a sentence.
[[nodiscard]] std::string name_of(std::size_t model, std::size_t count);

} // namespace lissom
