#include "lissom/match/pairwise_match.h"

#include "lissom/match/folds.h"
#include "lissom/match/places.h"
#include "lissom/mesh/errors.h"
#include "lissom/mesh/stopwatch.h"

#include "match_checks.h"
#include "match_report.h"
#include "placed_model.h"
#include "projection.h"

#include <algorithm>
#include <deque>
#include <limits>
#include <optional>
#include <string>
#include <utility>

namespace lissom {

namespace {

constexpr int k_projections = 2;
constexpr double k_projection_cosine = 0.5;
constexpr int k_untangling_rounds = 24;
constexpr double k_anywhere = std::numeric_limits<double>::infinity();

/// Without what is ignored of it.
struct Placed : PlacedModel {
    Placed(const MatchModel& model, const std::string& which) : PlacedModel(*model.model, which) { ignore(model.ignored, which); }
};

} // namespace

struct PairwiseMatch::State {
    std::vector<MatchModel> models;
    MatchOptions options;
    std::deque<Placed> placed{};         ///< in order
    std::optional<MatchSession> pair{};  ///< in hand: the source and target number `results.size() + 1`
    std::vector<MatchResult> results{};  ///< of pairs, in order
    SkinSet skins{};                     ///< in the models' own spaces, once all pairs are matched
    std::vector<char> kept{};            ///< vertices that are markers, or that come from where the source is ignored
    std::vector<char> masked{};          ///< the latter; empty: none
    std::vector<int> refused{};          ///< steps, per model
    int composed = 2;                    ///< models whose skins are there
    int projections = 0;                 ///< slices
    double seconds = 0;

    [[nodiscard]] int count() const { return static_cast<int>(models.size()); }
    [[nodiscard]] bool matched() const { return static_cast<int>(results.size()) == count() - 1; }
    [[nodiscard]] int slices_of_projection() const { return k_projections * (count() - 2); }
    [[nodiscard]] bool done() const { return matched() && composed == count() && projections == slices_of_projection(); }

    /// What a later pair would refuse is refused now, by the model's own number.
    void place() {
        for (std::size_t k = 0; k < models.size(); ++k) {
            placed.emplace_back(models[k], name_of(k, models.size()));
            (void)align_markers(models.front().markers, models[k].markers, MatchStart::similarity);
        }
    }

    void begin_pair() { pair.emplace(std::vector<MatchModel>{models.front(), models[results.size() + 1]}, options); }

    void match() {
        if (pair->step()) return;
        results.push_back(pair->result());
        pair.reset();
        if (!matched()) return begin_pair();
        const MatchResult& first = results.front();
        skins = first.skins;
        skins.points.resize(models.size());
        kept.assign(static_cast<std::size_t>(skins.vertex_count()), 0);
        refused.assign(models.size(), 0);
        for (const int v : first.marker_vertices) kept[v] = 1;
        if (models.front().ignored.empty()) return;
        const Placed& source = placed.front();
        const Points points = source.inwards(skins.points.front());
        for (int v = 0; v < skins.vertex_count(); ++v) {
            masked.push_back(source.surface.nearest(points.row(v), Eigen::Vector3d::Zero(), -1, k_anywhere).ignored);
            kept[v] = kept[v] || masked.back();
        }
    }

    /// Section 4, lines 1 to 8; markers are met.
    void compose() {
        const MatchResult& other = results[static_cast<std::size_t>(composed) - 1];
        Points& points = skins.points[static_cast<std::size_t>(composed)];
        points = carried_places(other.skins.mesh(0), other.skins.points[1], skins.points.front());
        const std::vector<int>& here = results.front().marker_vertices;
        for (std::size_t m = 0; m < here.size(); ++m) points.row(here[m]) = other.skins.points[1].row(other.marker_vertices[m]);
        ++composed;
    }

    /// A composed skin may be tangled where the two first skins differ, and the guard keeps only what is clean.
    void project() {
        const int k = 2 + projections++ % (count() - 2);
        const Placed& on = placed[static_cast<std::size_t>(k)];
        Points& points = skins.points[static_cast<std::size_t>(k)];
        TriangleMesh mesh{on.inwards(points), skins.triangles};
        (void)untangle(mesh, kept, k_untangling_rounds);
        GuardedStep step(mesh);
        refused[static_cast<std::size_t>(k)] += step.take(mesh, projected(on.surface, mesh, k_projection_cosine, kept) - mesh.points).refused;
        const Points moved = on.outwards(mesh.points);
        for (int v = 0; v < skins.vertex_count(); ++v)
            if (!kept[v]) points.row(v) = moved.row(v);
    }

    [[nodiscard]] MatchReport report() const {
        Stopwatch watch;
        MatchReport found = results.front().report;
        for (int k = 2; k < count(); ++k) {
            const MatchReport& of_pair = results[static_cast<std::size_t>(k) - 1].report;
            const Placed& on = placed[static_cast<std::size_t>(k)];
            SkinReport skin = skin_report({on.inwards(skins.points[static_cast<std::size_t>(k)]), skins.triangles}, on, masked, false);
            skin.flatness = of_pair.skins[1].flatness;
            skin.bent = of_pair.skins[1].bent;
            for (MatchWarning warning : of_pair.warnings) {
                // What is about the source, or about all, the first pair says; crossings are those of the skin that came of it.
                if (warning.model != 1 || warning.code == "crossings-left" || warning.code == "step-refused" || warning.code == "sharp-failed" || warning.code == "sharp-held-back") continue;
                warning.model = k;
                found.warnings.push_back(std::move(warning));
            }
            if (skin.crossings > 0) found.warnings.push_back({"crossings-left", k, skin.crossings, {}});
            if (refused[static_cast<std::size_t>(k)] > 0) found.warnings.push_back({"step-refused", k, refused[static_cast<std::size_t>(k)], {}});
            if (of_pair.skins[1].sharp_curves > 0) found.warnings.push_back({"sharp-lost", k, of_pair.skins[1].sharp_curves, {}});
            found.flatness = std::min(found.flatness, skin.flatness);
            found.marker_error = std::max(found.marker_error, of_pair.marker_error);
            found.seconds.start += of_pair.seconds.start;
            found.seconds.carry += of_pair.seconds.carry;
            found.seconds.fine += of_pair.seconds.fine;
            found.seconds.connectivity += of_pair.seconds.connectivity;
            found.seconds.sharp += of_pair.seconds.sharp;
            found.skins.push_back(std::move(skin));
        }
        found.seconds.fine += seconds;
        found.seconds.report += watch.lap();
        return found;
    }
};

PairwiseMatch::PairwiseMatch(std::vector<MatchModel> models, const MatchOptions& options) : state_(std::make_unique<State>(State{std::move(models), options})) {
    check_options(state_->models, options);
    check_curves(state_->models);
    state_->place();
    state_->begin_pair();
}
PairwiseMatch::~PairwiseMatch() = default;
PairwiseMatch::PairwiseMatch(PairwiseMatch&&) noexcept = default;

bool PairwiseMatch::step() {
    State& s = *state_;
    Stopwatch watch;
    if (!s.matched()) s.match();
    else if (s.composed < s.count()) s.compose();
    else if (!s.done()) s.project();
    if (s.matched()) s.seconds += watch.lap();
    return !s.done();
}

double PairwiseMatch::fraction() const {
    const State& s = *state_;
    constexpr double paired = 0.95;
    if (!s.matched()) return paired * (static_cast<double>(s.results.size()) + s.pair->fraction()) / (s.count() - 1);
    if (s.done()) return 1;
    return paired + (1 - paired) * (s.composed - 2 + s.projections) / (s.count() - 2 + s.slices_of_projection());
}

MatchResult PairwiseMatch::result() const {
    const State& s = *state_;
    if (!s.matched() || s.composed < s.count()) throw InvalidInput("not-begun", "The skins of all models are not there yet. Call step() until it is done.");
    MatchResult out{s.skins, s.results.front().marker_vertices, s.report()};
    if (!s.done()) out.report.warnings.push_back({"stopped-early", -1, 1, {}});
    return out;
}

Points PairwiseMatch::positions(int model) const {
    const State& s = *state_;
    if (s.matched()) return s.skins.points[static_cast<std::size_t>(model)];
    const int target = static_cast<int>(s.results.size()) + 1;
    return model == 0 || model == target ? s.pair->positions(model == 0 ? 0 : 1) : Points(0, 3);
}

const Triangles& PairwiseMatch::triangles() const { return state_->matched() ? state_->skins.triangles : state_->pair->triangles(); }

} // namespace lissom
