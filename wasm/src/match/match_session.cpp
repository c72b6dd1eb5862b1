#include "lissom/match/match_session.h"

#include "lissom/match/correspondences.h"
#include "lissom/match/fine_fit.h"
#include "lissom/match/folds.h"
#include "lissom/match/marker_curves.h"
#include "lissom/match/particles.h"
#include "lissom/match/skin_carrier.h"
#include "lissom/mesh/errors.h"
#include "lissom/mesh/operators.h"
#include "lissom/mesh/stopwatch.h"
#include "lissom/mesh/topology.h"

#include "easing.h"
#include "match_checks.h"
#include "match_report.h"
#include "outer_parts.h"
#include "placed_model.h"
#include "projection.h"
#include "sharp_finish.h"
#include "skin_beginning.h"

#include <algorithm>
#include <deque>
#include <limits>
#include <optional>
#include <memory>
#include <string>
#include <utility>

namespace lissom {

using Eigen::Vector3d;

namespace {

constexpr double k_anywhere = std::numeric_limits<double>::infinity();

/// The radial start is kept where it leaves less than this share of the energy that the similarity does. Measured after the first graph: a quarter and less on
/// bodies of different poses, where it halves the error; 0.6 and more on heads and bodies of one pose, where it doubles it.
constexpr double k_bends_better = 1.0 / 3;

constexpr double k_marker_pull = 30; // vertices, while carried
constexpr double k_curve_pull = 10, k_fine_curve_pull = 5; // a place of a curve: drawn by hand, it is not exact
constexpr double k_fine_first = 20, k_fine_last = 0.3;
constexpr double k_fine_reach = 0.03, k_fine_cosine = 0.4;
constexpr int k_before_connectivity = 2, k_after_connectivity = 3; // fine steps without
constexpr double k_settled = 1e-3; // of the edges: so few changes are not worth another pass
constexpr int k_projections = 3;
constexpr int k_untangling_rounds = 24, k_mending_rounds = 4;
constexpr double k_projection_cosine = 0.5, k_back_cosine = 0.3;
constexpr int k_most_at_first = 100000; // vertices of a first skin made anew, where no number is given
constexpr int k_particle_passes = 60;
constexpr double k_particle_share = 0.1;   // of the edges that should change, in a pass of the paper's loop
constexpr double k_particles_rest = 1e-3;  // of L: particles that move less in the mean have arrived
constexpr double k_coincide = 0.05; // of L: markers nearer to one another are the same
constexpr double k_posed = 0.25; // misfit of the similarity: heads 0.11, bodies in one pose 0.05, walking 0.43
constexpr double k_one_sided = 0.02; // of the size, beyond the middle
constexpr double k_held_back = 1e-3; // of L: rounding is less
constexpr double k_snap = 0.5; // of L: a marker so near to a sharp curve is meant to be on it
constexpr double k_off_surface = 0.01; // of the size: a marker farther from its model is worth a word

int crossings_of(const TriangleMesh& mesh) {
    IntersectionFinder finder(mesh, IntersectionFinder::Neighbours::looked_at);
    return static_cast<int>(finder.find(mesh.points).triangles.size());
}

/// A model and what is made for its skin while it is fitted.
struct Fitted {
    PlacedModel placed;
    Points markers;              ///< on the surface, unit size
    std::vector<Points> curves;  ///< unit size
    Points curve_places{};       ///< of the source's curves, on this surface
    MarkerAlignment alignment{};
    std::unique_ptr<SkinCarrier> carrier{}, bent{}; ///< the second where both starts are tried
    std::optional<Correspondences> correspondences{};
    std::optional<GuardedStep> guard{};
    SharpFinish sharp;

    Fitted(const MatchModel& model, std::optional<OuterSurface> outer, double sharp_angle, const std::string& which)
        : placed(*model.model, which, std::move(outer)), markers(placed.inwards(model.markers)), sharp(placed, sharp_angle, model.sharp) {
        placed.ignore(model.ignored, which);
        for (const Points& curve : model.curves) curves.push_back(placed.inwards(curve));
    }
    [[nodiscard]] const FitSurface& surface() const { return placed.surface; }
};

} // namespace

struct MatchSession::State {
    enum class Stage { outer, first, start, particles, carry, untangle, fine, edges, mend, relax, project, sharp, done };

    MatchOptions options;
    std::vector<MatchModel> given;
    OuterParts outer;
    std::deque<Fitted> models{}; ///< the source first; none before their outer surfaces are known

    std::optional<SkinBeginning> beginning{};
    SkinSet skins{};
    std::optional<MarkerCurves> curves{};
    std::vector<char> masked{}; ///< per vertex of the skins: the source ignores where it is; empty: none
    std::optional<GraphLevels> graphs{};
    std::optional<FineFit> fine{}; ///< of all skins, for it knows the triangles alone
    ConnectivityOptions edges{};

    Stage stage = Stage::outer;
    int carries = 0, carried = 0;  ///< slices of carrying: all, and done
    int iteration = 0, model = 1; ///< which skin the next slice is about
    ConnectivityChange changes{};
    double moved = 0;         ///< the farthest mean way of a skin's particles in this pass
    std::vector<int> refused; ///< steps, per model
    std::vector<int> used_marker{}; ///< per marker that was given, the number of the one that stands for it
    bool full = false, settled = false; ///< no more splits; no more changes of edges
    std::vector<MatchWarning> warnings{};
    MatchSeconds seconds{};

    State(const std::vector<MatchModel>& m, const MatchOptions& o) : options(o), given(m), outer(m, o.first), refused(m.size(), 0) {}

    void find_outer() {
        if (outer.step()) return;
        options.first = outer.first();
        for (std::size_t k = 0; k < given.size(); ++k) models.emplace_back(given[k], outer.take(k), options.sharp_angle, name_of(k, given.size()));
        const PlacedModel& placed = source().placed;
        edges.edge_length = options.edge_length > 0 ? options.edge_length : mean_edge_length(placed.working.mesh) / placed.size.size;
        edges.adapt = options.adapt;
        align();
        next(Stage::first);
    }

    [[nodiscard]] int count() const { return static_cast<int>(models.size()); }
    [[nodiscard]] Fitted& source() { return models.front(); }
    [[nodiscard]] Fitted& present() { return models[static_cast<std::size_t>(model)]; }
    [[nodiscard]] Points& present_points() { return skins.points[static_cast<std::size_t>(model)]; }

    void bring_onto_surface(int k) {
        Fitted& on = models[static_cast<std::size_t>(k)];
        MatchWarning off{"markers-moved", k, 0, {}};
        for (Eigen::Index i = 0; i < on.markers.rows(); ++i) {
            const auto place = on.surface().nearest(on.markers.row(i), Vector3d::Zero(), -1, k_anywhere);
            on.markers.row(i) = (on.sharp.empty() ? place.point : on.sharp.snapped(place.point, k_snap * edges.edge_length)).transpose();
            if (!(place.distance > k_off_surface)) continue;
            ++off.count;
            if (off.examples.size() < 8) off.examples.push_back(static_cast<int>(i));
        }
        if (off.count > 0) warnings.push_back(std::move(off));
    }

    /// Of markers that coincide on any model only the first is used: a vertex cannot be at two places, nor two at one.
    void leave_out_coinciding() {
        const Eigen::Index n = source().markers.rows();
        std::vector<Eigen::Index> used;
        for (int k = 0; k < count(); ++k) {
            MatchWarning same{"markers-coincide", k, 0, {}};
            const Points& markers = models[static_cast<std::size_t>(k)].markers;
            for (Eigen::Index i = 0; i < n; ++i)
                for (Eigen::Index j = 0; j < i; ++j)
                    if ((markers.row(i) - markers.row(j)).norm() < k_coincide * edges.edge_length) {
                        ++same.count;
                        if (same.examples.size() + 2 <= 8) same.examples.insert(same.examples.end(), {static_cast<int>(j), static_cast<int>(i)});
                        break;
                    }
            if (same.count > 0) warnings.push_back(std::move(same));
        }
        for (Eigen::Index i = 0; i < n; ++i) {
            int stands_for = static_cast<int>(used.size());
            for (std::size_t u = 0; u < used.size() && stands_for == std::ssize(used); ++u)
                for (const Fitted& each : models)
                    if ((each.markers.row(i) - each.markers.row(used[u])).norm() < k_coincide * edges.edge_length) stands_for = static_cast<int>(u);
            if (stands_for == std::ssize(used)) used.push_back(i);
            used_marker.push_back(stands_for);
        }
        for (Fitted& each : models) each.markers = Points(each.markers(used, Eigen::all));
    }

    void align() {
        // Counted and looked at before they are brought anywhere.
        for (const Fitted& target : models) (void)align_markers(source().markers, target.markers, MatchStart::similarity);
        for (int k = 0; k < count(); ++k) bring_onto_surface(k);
        leave_out_coinciding();
        for (int k = 0; k < count(); ++k)
            if (const Points& markers = models[static_cast<std::size_t>(k)].markers; markers.rows() >= 4 && one_sided(markers, k_one_sided)) warnings.push_back({"markers-one-sided", k, 1, {}});
        for (int k = 1; k < count(); ++k) {
            MarkerAlignment& found = models[static_cast<std::size_t>(k)].alignment;
            found = align_markers(source().markers, models[static_cast<std::size_t>(k)].markers, options.start);
            const auto warn = [&](const char* code, std::vector<int> examples) { warnings.push_back({code, k, std::max(1, static_cast<int>(examples.size())), std::move(examples)}); };
            if (found.mirrored) warn("markers-mirrored", {});
            if (found.swapped) warn("markers-swapped", {found.swapped->first, found.swapped->second});
            if (source().markers.rows() >= 4 && found.flatness < k_flat_markers) warn("markers-flat", {});
            if (!found.mirrored && found.misfit > k_posed) warn("poses-differ", {});
            for (const char* code : differences(source().placed, models[static_cast<std::size_t>(k)].placed)) warn(code, {});
        }
    }

    void begin() {
        if (!beginning) {
            const int most = options.most_vertices > 0 ? options.most_vertices : std::max(k_most_at_first, 4 * source().placed.mesh().vertex_count());
            beginning.emplace(source().placed, source().sharp.curves(), SkinBeginning::Options{options.first, options.genus, edges.edge_length, options.adapt, most});
        }
        if (beginning->step()) return;
        warnings.insert(warnings.end(), beginning->warnings().begin(), beginning->warnings().end());
        next(Stage::start);
    }

    /// The first skin, and what becomes of it on each model; each marker takes the nearest vertex that is still free and moves it onto its place.
    void make_skins() {
        const TriangleMesh& mesh = beginning->mesh();
        skins.triangles = mesh.triangles;
        skins.points.assign(models.size(), mesh.points);
        skins.marker.assign(static_cast<std::size_t>(mesh.vertex_count()), -1);
        Points& first = skins.points.front();
        for (Eigen::Index i = 0; i < source().markers.rows(); ++i) {
            int nearest = -1;
            double least = k_anywhere;
            for (int v = 0; v < skins.vertex_count(); ++v)
                if (const double d = (mesh.points.row(v) - source().markers.row(i)).squaredNorm(); skins.marker[v] < 0 && d < least) {
                    least = d;
                    nearest = v;
                }
            if (nearest < 0) throw InvalidInput("marker-count", "There are more markers than the first skin has vertices. Remove some.");
            skins.marker[nearest] = static_cast<int>(i);
            first.row(nearest) = source().markers.row(i);
        }
        edges.most_vertices = options.most_vertices > 0 ? options.most_vertices : 4 * skins.vertex_count();
        curves.emplace(source().curves, source().surface(), edges.edge_length);
        for (Fitted& each : models) each.curve_places = curves->on(each.curves, each.surface());
        find_masked();
        if (options.method == MatchMethod::paper) {
            edges.share = k_particle_share;
            for (int k = 1; k < count(); ++k) {
                Points& points = skins.points[static_cast<std::size_t>(k)];
                points = models[static_cast<std::size_t>(k)].alignment(first);
                if (!points.allFinite()) throw SolverFailure("The markers bend the source beyond all numbers. Start by a similarity.");
                for (int v = 0; v < skins.vertex_count(); ++v)
                    if (skins.marker[v] >= 0) points.row(v) = models[static_cast<std::size_t>(k)].markers.row(skins.marker[v]);
            }
            return;
        }
        const CarrySchedule schedule = carry_schedule(static_cast<int>(source().markers.rows()));
        if (!beginning->curves().empty()) {
            std::vector<int> fixed;
            for (int v = 0; v < skins.vertex_count(); ++v)
                if (skins.marker[v] >= 0) fixed.push_back(v);
            skins.curves.emplace(skins.vertex_count(), beginning->curves(), fixed, EdgeCurves::Along::edited);
        }
        graphs.emplace(skins.mesh(0), schedule.radius, options.levels, options.seed);
        for (int k = 1; k < count(); ++k) {
            Fitted& target = models[static_cast<std::size_t>(k)];
            const auto carrier = [&](const MarkerAlignment& start) {
                const Points points = start(first);
                if (!points.allFinite()) throw SolverFailure("The markers bend the source beyond all numbers. Start by a similarity.");
                carries += schedule.iterations;
                return std::make_unique<SkinCarrier>(points, skins.triangles, *graphs, target.surface(), CarryGuides{guides(target), told(), masked}, schedule, options.seed);
            };
            carries += (options.levels - 1) * schedule.iterations;
            if (options.start == MatchStart::automatic && target.alignment.radial) {
                target.bent = carrier(target.alignment);
                MarkerAlignment straight = target.alignment;
                straight.radial.reset();
                target.carrier = carrier(straight);
            } else target.carrier = carrier(target.alignment);
            skins.points[static_cast<std::size_t>(k)] = target.carrier->points();
        }
    }

    /// What comes from where the source is ignored. Asked anew when edges have changed.
    void find_masked() {
        if (!source().surface().ignores_some()) return;
        masked.assign(static_cast<std::size_t>(skins.vertex_count()), 0);
        for (int v = 0; v < skins.vertex_count(); ++v) masked[v] = source().surface().nearest(skins.points.front().row(v), Vector3d::Zero(), -1, k_anywhere).ignored;
    }

    /// Where markers and curves belong on a target, as its skin is carried.
    [[nodiscard]] std::vector<Pull> guides(const Fitted& target) const {
        std::vector<Pull> pulls = curves->pulls(skins.mesh(0), target.curve_places);
        for (Pull& pull : pulls) pull.weight = k_curve_pull;
        for (int v = 0; v < skins.vertex_count(); ++v)
            if (skins.marker[v] >= 0) pulls.push_back(Pull::of_vertex(v, target.markers.row(skins.marker[v]).transpose(), k_marker_pull));
        return pulls;
    }

    /// Vertices that nothing is asked about: they are told where to go, or left to those around them.
    [[nodiscard]] std::vector<char> told() const {
        std::vector<char> flags = locked();
        for (std::size_t v = 0; v < masked.size(); ++v) flags[v] = flags[v] || masked[v];
        return flags;
    }

    [[nodiscard]] std::vector<char> locked() const {
        std::vector<char> flags;
        for (const int marker : skins.marker) flags.push_back(marker >= 0);
        return flags;
    }
    /// On the source's skin its sharp curves stay where they are, too.
    [[nodiscard]] std::vector<char> locked_on_source() const {
        std::vector<char> flags = locked();
        if (skins.curves)
            for (int v = 0; v < skins.vertex_count(); ++v) flags[v] = flags[v] || skins.curves->tied(v);
        return flags;
    }

    /// On to the next skin. @returns false after the last
    bool next_model() {
        if (++model < count()) return true;
        model = 1;
        return false;
    }
    void next(Stage after) {
        stage = after;
        iteration = 0;
        model = 1;
    }

    void carry() {
        Fitted& at = present();
        SkinCarrier& carrier = at.bent && at.bent->levels_done() == 0 ? *at.bent : *at.carrier;
        (void)carrier.step();
        ++carried;
        present_points() = carrier.points();
        if (at.bent && at.carrier->levels_done() > 0) choose_start();
        if (at.carrier->fraction() < 1) return;
        at.carrier.reset();
        if (!next_model()) {
            graphs.reset();
            next(Stage::untangle);
        }
    }

    void choose_start() {
        Fitted& at = present();
        const auto crossings = [&](const SkinCarrier& carrier) { return crossings_of({carrier.points(), skins.triangles}); };
        if (at.bent->energy() < k_bends_better * at.carrier->energy() && crossings(*at.bent) <= crossings(*at.carrier)) at.carrier = std::move(at.bent);
        else at.alignment.radial.reset();
        at.bent.reset();
        present_points() = at.carrier->points();
    }

    /// The paper's loop: the particles of all skins in tandem, the source's among them, then their edges (Skins 3.1, lines 5 to 9).
    void reposition() {
        const bool on_source = model == 0;
        std::vector<char> held = on_source ? locked_on_source() : told();
        Points& points = present_points();
        const Points places = repositioned({points, skins.triangles}, present().surface(), held, ParticleWeights::at(iteration));
        const double mean = (places - points).rowwise().norm().mean();
        moved = on_source ? mean : std::max(moved, mean);
        points = places;
        if (++model < count()) return;
        ConnectivityChange change;
        if (options.connectivity) {
            change = improve_connectivity(skins, edges);
            changes += change;
            full = full || skins.vertex_count() >= edges.most_vertices;
            find_masked();
        }
        settled = moved < k_particles_rest * edges.edge_length && change.sum() <= k_settled * 3 * skins.vertex_count();
        model = 0;
        if (++iteration == k_particle_passes || settled) finish();
    }

    void mend(int k, int rounds) {
        Points& points = skins.points[static_cast<std::size_t>(k)];
        TriangleMesh mesh{std::move(points), skins.triangles};
        (void)untangle(mesh, k == 0 ? locked_on_source() : locked(), rounds);
        points = std::move(mesh.points);
    }

    void take_step(GuardedStep& step, int k, const Points& to_places) {
        Points& points = skins.points[static_cast<std::size_t>(k)];
        TriangleMesh mesh{std::move(points), skins.triangles};
        refused[static_cast<std::size_t>(k)] += step.take(mesh, to_places - mesh.points).refused;
        points = std::move(mesh.points);
    }
    void take_step(const Points& to_places) {
        if (!present().guard) present().guard.emplace(skins.mesh(model));
        take_step(*present().guard, model, to_places);
    }
    void take_source_step(const Points& to_places) {
        GuardedStep step(skins.mesh(0));
        take_step(step, 0, to_places);
    }

    void fit_finely() {
        if (!fine) fine.emplace(skins.mesh(1));
        if (!present().correspondences) present().correspondences.emplace(present().surface(), SurfacePlaces{}, present().surface().has_facing());
        const CorrespondenceRules rules{k_fine_cosine, k_fine_reach, 0};
        std::vector<Pull> pulls = present().correspondences->find(skins.mesh(model), rules, told());
        for (Pull pull : curves->pulls(skins.mesh(0), present().curve_places)) {
            pull.weight = k_fine_curve_pull;
            pulls.push_back(pull);
        }
        std::vector<FineFit::Held> held;
        for (int v = 0; v < skins.vertex_count(); ++v)
            if (skins.marker[v] >= 0) held.push_back({v, present().markers.row(skins.marker[v]).transpose()});
        take_step(present_points() + fine->solve(present_points(), pulls, held, eased(k_fine_first, k_fine_last, along(iteration, options.fine_steps))));
        if (next_model()) return;
        const bool edits = options.connectivity && !settled && iteration >= k_before_connectivity && iteration < options.fine_steps - k_after_connectivity;
        if (edits) stage = Stage::edges;
        else end_fine_step();
    }

    void end_fine_step() {
        stage = Stage::fine;
        model = 1;
        if (++iteration == options.fine_steps) next(Stage::project);
    }

    void change_edges() {
        const ConnectivityChange change = improve_connectivity(skins, edges);
        changes += change;
        settled = change.sum() <= k_settled * 3 * skins.vertex_count();
        full = full || skins.vertex_count() >= edges.most_vertices;
        fine.reset();
        for (Fitted& each : models) each.guard.reset();
        stage = Stage::mend;
        model = 0;
    }

    /// Edits may have made a few triangles meet. More than a few rounds would smooth away what is meant to be thin.
    void mend_edits() {
        mend(model, k_mending_rounds);
        if (next_model()) return;
        find_masked();
        stage = Stage::relax;
    }

    /// Every target's skin by the same weights, then the source's, which goes back onto its model.
    void relax() {
        if (model > 0) {
            take_step(relaxed_tangentially(skins, model));
            if (!next_model()) model = 0;
            return;
        }
        take_source_step(on_source({relaxed_tangentially(skins, 0), skins.triangles}, k_back_cosine));
        end_fine_step();
    }

    /// The source's skin began on its model, and stays there even where that is masked.
    [[nodiscard]] Points on_source(const TriangleMesh& skin, double least_cosine) {
        if (source().placed.is_points()) return skin.points; // a surface drawn through points is rougher than the skin
        return projected(source().surface(), skin, least_cosine, locked_on_source(), true);
    }

    void project() {
        take_step(projected(present().surface(), skins.mesh(model), k_projection_cosine, told()));
        if (next_model()) return;
        if (iteration == 0 && changes.any()) take_source_step(on_source(skins.mesh(0), k_projection_cosine));
        if (++iteration == k_projections) finish();
    }

    void finish() {
        next(has_sharp() ? Stage::sharp : Stage::done);
        model = 0;
    }

    [[nodiscard]] bool has_sharp() const {
        return std::any_of(models.begin(), models.end(), [](const Fitted& each) { return !each.sharp.empty(); });
    }

    void track_sharp() {
        Points& points = present_points();
        TriangleMesh mesh{std::move(points), skins.triangles};
        const bool more = present().sharp.step(mesh, present().surface(), skins.marker, edges.edge_length);
        points = std::move(mesh.points);
        if (!more && ++model == count()) next(Stage::done);
    }

    void advance() {
        Stopwatch watch;
        switch (stage) {
        case Stage::outer:
            find_outer();
            seconds.start += watch.lap();
            break;
        case Stage::first:
            begin();
            seconds.start += watch.lap();
            if (stage == Stage::first) break;
            [[fallthrough]];
        case Stage::start:
            make_skins();
            beginning.reset();
            next(options.method == MatchMethod::paper ? Stage::particles : Stage::carry);
            if (options.method == MatchMethod::paper) model = 0;
            seconds.start += watch.lap();
            break;
        case Stage::particles:
            reposition();
            seconds.fine += watch.lap();
            break;
        case Stage::carry:
            carry();
            seconds.carry += watch.lap();
            break;
        case Stage::untangle:
            mend(model, k_untangling_rounds);
            if (!next_model()) next(Stage::fine);
            seconds.fine += watch.lap();
            break;
        case Stage::fine:
            fit_finely();
            seconds.fine += watch.lap();
            break;
        case Stage::edges:
            change_edges();
            seconds.connectivity += watch.lap();
            break;
        case Stage::mend:
            mend_edits();
            seconds.connectivity += watch.lap();
            break;
        case Stage::relax:
            relax();
            seconds.connectivity += watch.lap();
            break;
        case Stage::project:
            project();
            seconds.fine += watch.lap();
            break;
        case Stage::sharp:
            track_sharp();
            seconds.sharp += watch.lap();
            break;
        case Stage::done: break;
        }
    }

    /// How far the present stage has come, in skins.
    [[nodiscard]] double part_of_models() const { return static_cast<double>(model - 1) / (count() - 1); }

    [[nodiscard]] MatchReport report() const {
        Stopwatch watch;
        MatchReport found;
        found.flatness = models.back().alignment.flatness;
        found.warnings = warnings;
        const auto warn = [&](const char* code, int k, int times) {
            if (times > 0) found.warnings.push_back({code, k, times, {}});
        };
        warn("stopped-early", -1, stage != Stage::done);
        for (int k = 0; k < count(); ++k) {
            const Fitted& on = models[static_cast<std::size_t>(k)];
            found.skins.push_back(skin_report(skins.mesh(k), on.placed, k > 0 ? masked : std::vector<char>{}, k == 0));
            found.marker_error = std::max(found.marker_error, marker_error(skins, k, on.markers, on.placed));
            if (k > 0) found.flatness = std::min(found.flatness, found.skins.back().flatness = on.alignment.flatness);
            found.skins.back().bent = on.alignment.radial.has_value();
            SkinReport& skin = found.skins.back();
            if (stage == Stage::done && !on.sharp.empty()) {
                const Points& points = skins.points[static_cast<std::size_t>(k)];
                skin.sharp_curves = on.sharp.lines();
                skin.sharp_failed = on.sharp.failed();
                skin.sharp_error = on.placed.size.size * on.sharp.error(points);
                for (const SharpPath& path : on.sharp.paths()) skin.sharp.push_back(path.curve.vertices);
                warn("sharp-failed", k, skin.sharp_failed);
                warn("sharp-held-back", k, on.sharp.farthest(points) > k_held_back * edges.edge_length);
            }
            warn("crossings-left", k, k > 0 ? found.skins.back().crossings : 0);
            warn("step-refused", k, refused[static_cast<std::size_t>(k)]);
        }
        warn("skins-full", -1, full);
        warn("not-settled", -1, options.method == MatchMethod::paper && stage == Stage::done && !settled);
        found.connectivity = changes;
        found.seconds = seconds;
        found.seconds.report = watch.lap();
        return found;
    }
};

MatchSession::MatchSession(const std::vector<MatchModel>& models, const MatchOptions& options) {
    Stopwatch watch;
    check_options(models, options);
    check_curves(models);
    state_ = std::make_unique<State>(models, options);
    const bool whole = std::all_of(models.begin(), models.end(), [](const MatchModel& each) { return each.model->component_count < 2; });
    if (whole) state_->find_outer(); // at once: what is wrong with markers is told here
    state_->seconds.start = watch.lap();
}
MatchSession::~MatchSession() = default;
MatchSession::MatchSession(MatchSession&&) noexcept = default;

bool MatchSession::step() {
    state_->advance();
    return state_->stage != State::Stage::done;
}

double MatchSession::fraction() const {
    const State& s = *state_;
    // Shares of the time as measured; of a fine step where edges change as much goes into those.
    const double begun = s.options.first == FirstSkin::copy ? 0 : 0.15, carried = 0.35;
    constexpr double of_fit = 0.5;
    const double projected = s.has_sharp() ? 0.8 : 1, fitted = projected - 0.05;
    const auto fine_step = [&](double part) { return carried + (fitted - carried) * (s.iteration + part) / s.options.fine_steps; };
    switch (s.stage) {
    case State::Stage::outer: return 0;
    case State::Stage::first: return s.beginning ? begun * s.beginning->fraction() : 0;
    case State::Stage::start: return begun;
    case State::Stage::particles: return begun + (projected - begun) * (s.iteration + static_cast<double>(s.model) / s.count()) / k_particle_passes;
    case State::Stage::carry: return begun + (carried - begun) * s.carried / s.carries;
    case State::Stage::untangle: return carried;
    case State::Stage::fine: return fine_step(of_fit * s.part_of_models());
    case State::Stage::edges: return fine_step(of_fit);
    case State::Stage::mend: return fine_step(of_fit + (1 - of_fit) * (0.2 + 0.3 * s.model / s.count()));
    case State::Stage::relax: return fine_step(of_fit + (1 - of_fit) * (s.model > 0 ? 0.5 + 0.4 * s.part_of_models() : 0.9));
    case State::Stage::project: return fitted + (projected - fitted) * (s.iteration + s.part_of_models()) / k_projections;
    case State::Stage::sharp: return projected + (1 - projected) * (s.model + s.models[static_cast<std::size_t>(s.model)].sharp.fraction()) / s.count();
    case State::Stage::done: break;
    }
    return 1;
}

MatchResult MatchSession::result() const {
    const State& s = *state_;
    if (s.skins.count() == 0) throw InvalidInput("not-begun", "The match has not begun. Call step() first.");
    MatchResult out{s.skins, {}, s.report()};
    std::vector<int> vertex(static_cast<std::size_t>(s.models.front().markers.rows()), -1);
    for (int v = 0; v < s.skins.vertex_count(); ++v)
        if (const int m = s.skins.marker[v]; m >= 0) vertex[m] = v;
    for (const int m : s.used_marker) out.marker_vertices.push_back(vertex[m]);
    for (int k = 0; k < s.count(); ++k) {
        out.skins.points[static_cast<std::size_t>(k)] = positions(k);
        if (!out.skins.points[static_cast<std::size_t>(k)].allFinite()) throw SolverFailure("The match ran out of numbers: a position is not finite. Try other markers.");
    }
    return out;
}

const MarkerAlignment& MatchSession::alignment(int model) const {
    if (state_->models.empty()) throw InvalidInput("not-begun", "The match has not begun. Call step() first.");
    return state_->models[static_cast<std::size_t>(model)].alignment;
}
Points MatchSession::positions(int model) const {
    const State& s = *state_;
    const auto k = static_cast<std::size_t>(model);
    if (s.skins.count() == 0) return Points(0, 3);
    return s.models[k].placed.outwards(s.skins.points[k]);
}
const Triangles& MatchSession::triangles() const { return state_->skins.triangles; }

} // namespace lissom
