#include "match_checks.h"

#include "lissom/mesh/errors.h"

namespace lissom {

using Eigen::Vector3d;

void check_options(const std::vector<MatchModel>& models, const MatchOptions& o) {
    if (models.size() < 2) throw InvalidInput("model-count", "A match needs two models or more, but there are " + std::to_string(models.size()) + ". Add a model.");
    const auto refuse = [](const std::string& sentence) { throw InvalidInput("bad-option", sentence); };
    if (!(o.edge_length >= 0 && o.edge_length < 1)) refuse("The edge length is " + std::to_string(o.edge_length) + " of the source's size; it must be below 1, or 0 for its own.");
    if (o.levels < 1 || o.levels > 4) refuse("The number of levels is " + std::to_string(o.levels) + "; it must be between 1 and 4.");
    if (o.fine_steps < 1 || o.fine_steps > 60) refuse("The number of fine steps is " + std::to_string(o.fine_steps) + "; it must be between 1 and 60.");
    if (o.genus < 0 || o.genus > 1000) refuse("The genus is " + std::to_string(o.genus) + "; it must be between 0 and 1000.");
    if (!(o.sharp_angle >= 0 && o.sharp_angle < 180)) refuse("The sharp angle is " + std::to_string(o.sharp_angle) + " degrees; it must be 0 or more and below 180.");
    if (!(o.adapt >= 0 && o.adapt <= 1)) refuse("How far lengths adapt is " + std::to_string(o.adapt) + "; it must be between 0 and 1.");
    if (o.most_vertices < 0) refuse("The most vertices a skin may have are " + std::to_string(o.most_vertices) + "; give 0 or more.");
}

void check_curves(const std::vector<MatchModel>& models) {
    for (const MatchModel& model : models) {
        if (model.curves.size() != models.front().curves.size())
            throw InvalidInput("curve-count", "One model has " + std::to_string(models.front().curves.size()) + " marker curves and another " + std::to_string(model.curves.size()) + ". Draw each on all models.");
        for (std::size_t c = 0; c < model.curves.size(); ++c) {
            const Points& line = model.curves[c];
            if (line.rows() < 2 || !line.allFinite() || (line.rowwise() - line.row(0)).isZero(0))
                throw InvalidInput("bad-curve", "Marker curve " + std::to_string(c + 1) + " has no length, or a coordinate that is not a finite number. Draw it again.");
        }
    }
}

std::vector<const char*> differences(const PlacedModel& a, const PlacedModel& b) {
    std::vector<const char*> found;
    if (a.is_loose() || b.is_loose()) return found; // pieces, holes and tunnels of these mean nothing
    const WorkingMesh &s = a.working, &t = b.working;
    if (s.component_count != t.component_count) found.push_back("pieces-differ");
    if (s.closed != t.closed) found.push_back("borders-differ");
    const auto tunnels = [](const WorkingMesh& m) { return 2 * m.component_count - m.boundary_loop_count - m.euler_characteristic; };
    if (s.oriented && t.oriented && s.component_count == t.component_count && tunnels(s) != tunnels(t)) found.push_back("genus-differs");
    return found;
}

/// A perceptron.
bool one_sided(const Points& markers, double margin) {
    constexpr int rounds = 200;
    Vector3d direction = markers.colwise().mean();
    for (int round = 0; round < rounds; ++round) {
        Eigen::Index worst = 0;
        const double least = (markers * direction).minCoeff(&worst);
        if (least > margin * direction.norm()) return true;
        direction += markers.row(worst).transpose();
    }
    return false;
}

std::string name_of(std::size_t model, std::size_t count) {
    if (model == 0) return "source";
    return count == 2 ? "target" : "target " + std::to_string(model);
}

} // namespace lissom
