#include "outer_parts.h"

#include "placed_model.h"

#include <algorithm>

namespace lissom {

OuterParts::OuterParts(const std::vector<MatchModel>& models, FirstSkin wanted) : first_(wanted), found_(models.size()) {
    for (const MatchModel& each : models) models_.push_back(each.model);
}

bool OuterParts::step() {
    // A single piece that crosses itself does so by accident.
    while (model_ < models_.size() && (models_[model_]->component_count < 2 || is_points(*models_[model_]))) ++model_;
    if (model_ == models_.size()) {
        settle();
        return false;
    }
    if (!finder_) finder_.emplace(models_[model_]->mesh);
    if (finder_->step()) return true;
    if (finder_->result().hides()) found_[model_] = finder_->result();
    finder_.reset();
    ++model_;
    return true;
}

void OuterParts::settle() {
    const WorkingMesh& source = *models_.front();
    if (first_ == FirstSkin::automatic) {
        const bool alike = std::all_of(models_.begin(), models_.end(), [&](const WorkingMesh* each) { return each->component_count == source.component_count; });
        first_ = is_points(source) || is_soup(source.mesh) || (found_.front() && !alike) ? FirstSkin::wrap : FirstSkin::copy;
    }
    const bool follows = (first_ == FirstSkin::copy || first_ == FirstSkin::remesh) && found_.front();
    if (follows) std::fill(found_.begin(), found_.end(), std::nullopt);
}

} // namespace lissom
