#include "lissom/match/match_session.h"

#include "lissom/match/affine_fit.h"
#include "lissom/match/correspondences.h"
#include "lissom/match/fine_fit.h"
#include "lissom/match/folds.h"
#include "lissom/mesh/chance.h"
#include "lissom/mesh/errors.h"
#include "lissom/mesh/half_edges.h"
#include "lissom/mesh/operators.h"
#include "lissom/mesh/stopwatch.h"
#include "lissom/mesh/topology.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>

namespace lissom {

using Eigen::RowVector3d;
using Eigen::Vector3d;

namespace {

constexpr double k_anywhere = std::numeric_limits<double>::infinity();

/// How the skin is carried along: with markers it starts near, without it must find its way.
struct CarrySchedule {
    double radius;                     ///< of the first graph
    int iterations;                    ///< on each
    double first_reach, last_reach;
    double least_cosine;
};
constexpr CarrySchedule k_marked{0.12, 12, 0.15, 0.06, 0.3}, k_unmarked{0.2, 8, 0.4, 0.1, 0};
constexpr int k_fewest_markers = 3; // to turn by
constexpr double k_first_stiffness = 5, k_next_stiffness = 0.3, k_last_stiffness = 0.02;
constexpr double k_marker_pull = 30; // vertices
constexpr int k_most_asked = 6000; // vertices, and samples, that the finest graph is carried by; each coarser one by half as many
constexpr int k_most_nodes = 3000;

constexpr double k_fine_first = 20, k_fine_last = 0.3;
constexpr double k_fine_reach = 0.03, k_fine_cosine = 0.4;
constexpr int k_before_connectivity = 2, k_after_connectivity = 3; // fine steps without
constexpr double k_settled = 1e-3; // of the edges: so few changes are not worth another pass
constexpr int k_projections = 3;
constexpr int k_untangling_rounds = 24, k_mending_rounds = 4;
constexpr double k_projection_cosine = 0.5, k_back_cosine = 0.3;
/// Share of edges with one triangle above which a surface is a soup and has no rim.
constexpr double k_soup = 0.25;
constexpr double k_off_surface = 0.01; // of the size: a marker farther from its model is worth a word

/// From one value to another by equal factors: `at` in [0, 1].
double eased(double first, double last, double at) { return first * std::pow(last / first, at); }
double along(int step, int steps) { return steps > 1 ? static_cast<double>(step) / (steps - 1) : 1; }

bool is_soup(const TriangleMesh& mesh) {
    int all = 0, open = 0;
    for_each_edge(half_edges(mesh), [&](auto first, auto last) {
        ++all;
        open += last - first == 1;
    });
    return open > k_soup * all;
}

/// A model at unit size about its middle, and the way back.
struct Placed {
    const WorkingMesh& working;
    SurfaceSize size;
    TriangleMesh mesh;

    explicit Placed(const WorkingMesh& model, const char* which) : working(model), size(surface_size(model.mesh)), mesh(model.mesh) {
        if (!(size.size > 0)) throw InvalidInput("flat-model", std::string("The ") + which + " has no area to put a skin on. Choose another model.");
        mesh.points = (mesh.points.rowwise() - size.middle) / size.size;
    }
    [[nodiscard]] Points inwards(const Points& places) const {
        Points inside(places.rows(), 3);
        for (Eigen::Index i = 0; i < places.rows(); ++i) inside.row(i) = (working.to_working(Vector3d(places.row(i))).transpose() - size.middle) / size.size;
        return inside;
    }
    [[nodiscard]] Points outwards(const Points& places) const {
        Points outside(places.rows(), 3);
        for (Eigen::Index i = 0; i < places.rows(); ++i) outside.row(i) = working.to_source((size.size * places.row(i) + size.middle).transpose()).transpose();
        return outside;
    }
    [[nodiscard]] FitSurface::Rules rules() const { return {!is_soup(mesh), working.oriented}; }
};

void check(const MatchOptions& o) {
    const auto refuse = [](const std::string& sentence) { throw InvalidInput("bad-option", sentence); };
    if (!(o.edge_length >= 0 && o.edge_length < 1)) refuse("The edge length is " + std::to_string(o.edge_length) + " of the source's size; it must be below 1, or 0 for its own.");
    if (o.levels < 1 || o.levels > 4) refuse("The number of levels is " + std::to_string(o.levels) + "; it must be between 1 and 4.");
    if (o.fine_steps < 1 || o.fine_steps > 60) refuse("The number of fine steps is " + std::to_string(o.fine_steps) + "; it must be between 1 and 60.");
    if (o.most_vertices < 0) refuse("The most vertices a skin may have are " + std::to_string(o.most_vertices) + "; give 0 or more.");
}

} // namespace

struct MatchSession::State {
    enum class Stage { start, carry, untangle, fine, edges, relax, project, done };

    MatchOptions options;
    Placed source, target;
    FitSurface source_surface, target_surface;
    Points from, to; ///< markers on the surfaces, unit size
    MarkerAlignment alignment{};
    CarrySchedule schedule = k_marked;

    SkinPair skins{};
    Points rest{}; ///< the target's skin before it was carried
    std::optional<NodeGraph> graph{};
    std::optional<AffineFit> affine{};
    std::optional<Correspondences> correspondences{};
    int asked = 0; ///< vertices, and samples, by which the present graph is carried
    std::optional<FineFit> fine{};
    std::optional<GuardedStep> guard{};
    ConnectivityOptions edges{};

    Stage stage = Stage::start;
    int iteration = 0;
    ConnectivityChange changes{};
    int refused = 0;
    bool full = false, settled = false; ///< no more splits; no more changes of edges
    std::vector<Finding> warnings{};
    MatchSeconds seconds{};

    State(const WorkingMesh& a, const WorkingMesh& b, const Points& source_markers, const Points& target_markers, const MatchOptions& o)
        : options(o), source(a, "source"), target(b, "target"), source_surface(source.mesh, source.rules()), target_surface(target.mesh, target.rules()),
          from(source.inwards(source_markers)), to(target.inwards(target_markers)) {}

    [[nodiscard]] int carry_iterations() const { return options.levels * schedule.iterations; }

    void bring_onto(const FitSurface& surface, Points& markers) {
        Finding off{"markers-moved", 0, {}, true};
        for (Eigen::Index i = 0; i < markers.rows(); ++i) {
            const auto place = surface.nearest(markers.row(i), Vector3d::Zero(), -1, k_anywhere);
            markers.row(i) = place.point.transpose();
            if (!(place.distance > k_off_surface)) continue;
            ++off.count;
            if (off.examples.size() < 8) off.examples.push_back(static_cast<int>(i));
        }
        if (off.count > 0) warnings.push_back(std::move(off));
    }

    void align() {
        // Counted and looked at before they are brought anywhere.
        (void)align_markers(from, to, MatchStart::similarity);
        bring_onto(source_surface, from);
        bring_onto(target_surface, to);
        alignment = align_markers(from, to, options.start);
        schedule = from.rows() < k_fewest_markers ? k_unmarked : k_marked;
        const auto warn = [&](const char* code, std::vector<int> examples) { warnings.push_back({code, std::max(1, static_cast<int>(examples.size())), std::move(examples), false}); };
        if (alignment.mirrored) warn("markers-mirrored", {});
        if (alignment.swapped) warn("markers-swapped", {alignment.swapped->first, alignment.swapped->second});
        if (from.rows() >= 4 && alignment.flatness < k_flat_markers) warn("markers-flat", {});
    }

    /// The source's mesh is the first skin; each marker takes the nearest vertex that is still free and moves it onto its place.
    void make_skins() {
        skins.triangles = source.mesh.triangles;
        skins.source = source.mesh.points;
        skins.marker.assign(static_cast<std::size_t>(skins.source.rows()), -1);
        for (Eigen::Index i = 0; i < from.rows(); ++i) {
            int nearest = -1;
            double least = k_anywhere;
            for (int v = 0; v < skins.vertex_count(); ++v)
                if (const double d = (source.mesh.points.row(v) - from.row(i)).squaredNorm(); skins.marker[v] < 0 && d < least) {
                    least = d;
                    nearest = v;
                }
            if (nearest < 0) throw InvalidInput("marker-count", "There are more markers than the source has vertices. Remove some.");
            skins.marker[nearest] = static_cast<int>(i);
            skins.source.row(nearest) = from.row(i);
        }
        rest = skins.target = alignment(skins.source);
        if (!rest.allFinite()) throw SolverFailure("The markers bend the source beyond all numbers. Start by a similarity.");
        edges.edge_length = options.edge_length > 0 ? options.edge_length : mean_edge_length(source.mesh);
        edges.most_vertices = options.most_vertices > 0 ? options.most_vertices : 4 * skins.vertex_count();
    }

    [[nodiscard]] std::vector<char> locked() const {
        std::vector<char> flags;
        for (const int marker : skins.marker) flags.push_back(marker >= 0);
        return flags;
    }

    void begin_level(int level) {
        // So many nodes that a finer graph would not be worth its factor: their number falls with the square of the radius.
        const double least = std::sqrt(triangle_areas(source.mesh).sum() / (0.7 * k_most_nodes));
        const double radius = std::max(schedule.radius * std::pow(0.5, level), least);
        asked = std::min(k_most_asked, 2 * skins.vertex_count()) >> (options.levels - 1 - level);
        correspondences.emplace(target_surface, sample_surface(target.mesh, asked, options.seed), target.working.oriented);
        graph.emplace(edge_graph(skins.source_mesh()), radius, options.seed);
        affine.emplace(rest, skins.triangles, *graph, skins.target);
    }

    void carry() {
        const int level = iteration / schedule.iterations, k = iteration % schedule.iterations;
        if (k == 0) begin_level(level);
        CorrespondenceRules rules{schedule.least_cosine, eased(schedule.first_reach, schedule.last_reach, along(iteration, carry_iterations()))};
        // A node has enough of some vertices.
        const double share = std::min(1.0, static_cast<double>(asked) / skins.vertex_count());
        std::vector<char> left_out = locked();
        for (int v = 0; v < skins.vertex_count(); ++v) left_out[v] = left_out[v] || chance(options.seed, static_cast<std::uint64_t>(v), 1) >= share;
        std::vector<Pull> pulls = correspondences->find(skins.target_mesh(), rules, left_out);
        for (int v = 0; v < skins.vertex_count(); ++v)
            if (skins.marker[v] >= 0) pulls.push_back(Pull::of_vertex(v, to.row(skins.marker[v]).transpose(), share * k_marker_pull));
        const double stiffness = eased(level == 0 ? k_first_stiffness : k_next_stiffness, k_last_stiffness, along(k, schedule.iterations));
        if (!pulls.empty()) skins.target = affine->solve(pulls, stiffness);
        if (++iteration < carry_iterations()) return;
        affine.reset();
        graph.reset();
        next(Stage::untangle);
    }

    void next(Stage after) {
        stage = after;
        iteration = 0;
    }

    void mend(Points& points, int rounds) {
        TriangleMesh mesh{std::move(points), skins.triangles};
        (void)untangle(mesh, locked(), rounds);
        points = std::move(mesh.points);
    }

    bool take_step(GuardedStep& step, Points& points, const Points& to_places) {
        TriangleMesh mesh{std::move(points), skins.triangles};
        const bool taken = !step.take(mesh, to_places - mesh.points).refused;
        points = std::move(mesh.points);
        return taken;
    }
    void take_step(const Points& to_places) {
        if (!guard) guard.emplace(skins.target_mesh());
        refused += !take_step(*guard, skins.target, to_places);
    }

    void fit_finely() {
        if (!fine) fine.emplace(skins.target_mesh());
        const CorrespondenceRules rules{k_fine_cosine, k_fine_reach, 0};
        const auto pulls = correspondences->find(skins.target_mesh(), rules, locked());
        std::vector<FineFit::Held> held;
        for (int v = 0; v < skins.vertex_count(); ++v)
            if (skins.marker[v] >= 0) held.push_back({v, to.row(skins.marker[v]).transpose()});
        take_step(skins.target + fine->solve(skins.target, pulls, held, eased(k_fine_first, k_fine_last, along(iteration, options.fine_steps))));
        const bool edits = options.connectivity && !settled && iteration >= k_before_connectivity && iteration < options.fine_steps - k_after_connectivity;
        if (edits) stage = Stage::edges;
        else end_fine_step();
    }

    void end_fine_step() {
        stage = Stage::fine;
        if (++iteration == options.fine_steps) next(Stage::project);
    }

    void change_edges() {
        const ConnectivityChange change = improve_connectivity(skins, edges);
        changes.splits += change.splits;
        changes.collapses += change.collapses;
        changes.swaps += change.swaps;
        settled = change.splits + change.collapses + change.swaps <= k_settled * 3 * skins.vertex_count();
        full = full || skins.vertex_count() >= edges.most_vertices;
        // Edits may have made a few triangles meet. More than a few rounds would smooth away what is meant to be thin.
        mend(skins.source, k_mending_rounds);
        mend(skins.target, k_mending_rounds);
        fine.reset();
        guard.reset();
        stage = Stage::relax;
    }

    void relax() {
        SkinPair relaxed = skins;
        relax_tangentially(relaxed);
        take_step(relaxed.target);
        GuardedStep of_source(skins.source_mesh());
        take_step(of_source, skins.source, on_surface(source_surface, relaxed.source_mesh(), k_back_cosine));
        end_fine_step();
    }

    /// Each vertex at its nearest place of the surface that faces as it does; markers stay.
    [[nodiscard]] Points on_surface(const FitSurface& surface, const TriangleMesh& skin, double least_cosine) const {
        Points places = skin.points;
        const Points normals = vertex_normals(skin);
        const std::vector<bool> border = surface.has_border() ? boundary_vertices(skin) : std::vector<bool>(places.rows(), false);
        for (int v = 0; v < skin.vertex_count(); ++v) {
            if (skins.marker[v] >= 0) continue;
            const Vector3d p = skin.points.row(v);
            const auto place = border[v] ? surface.nearest_on_border(p, k_fine_reach) : surface.nearest(p, normals.row(v), least_cosine, k_fine_reach);
            if (place.triangle >= 0 && (border[v] || !place.on_border)) places.row(v) = place.point.transpose();
        }
        return places;
    }

    void project() {
        take_step(on_surface(target_surface, skins.target_mesh(), k_projection_cosine));
        if (iteration == 0 && changes.any()) {
            GuardedStep of_source(skins.source_mesh());
            take_step(of_source, skins.source, on_surface(source_surface, skins.source_mesh(), k_projection_cosine));
        }
        if (++iteration == k_projections) next(Stage::done);
    }

    void advance() {
        Stopwatch watch;
        switch (stage) {
        case Stage::start:
            make_skins();
            next(Stage::carry);
            seconds.start += watch.lap();
            break;
        case Stage::carry:
            carry();
            seconds.carry += watch.lap();
            break;
        case Stage::untangle:
            mend(skins.target, k_untangling_rounds);
            next(Stage::fine);
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
        case Stage::relax:
            relax();
            seconds.connectivity += watch.lap();
            break;
        case Stage::project:
            project();
            seconds.fine += watch.lap();
            break;
        case Stage::done: break;
        }
    }

    [[nodiscard]] MatchReport report(std::vector<int>& marker_vertices) const {
        Stopwatch watch;
        MatchReport found;
        const TriangleMesh on_source = skins.source_mesh(), on_target = skins.target_mesh();
        const auto distances = [](const TriangleMesh& skin, const Placed& model) { // working meshes have a unit diagonal
            SurfaceDistances d = surface_distances(skin, model.mesh);
            for (double* value : {&d.mean_there, &d.mean_back, &d.most}) *value *= model.size.size;
            return d;
        };
        found.source = distances(on_source, source);
        found.target = distances(on_target, target);
        marker_vertices.assign(static_cast<std::size_t>(from.rows()), -1);
        for (int v = 0; v < skins.vertex_count(); ++v)
            if (const int m = skins.marker[v]; m >= 0) {
                marker_vertices[m] = v;
                found.marker_error = std::max({found.marker_error, source.size.size * (skins.source.row(v) - from.row(m)).norm(), target.size.size * (skins.target.row(v) - to.row(m)).norm()});
            }
        const TrianglePairs pairs = neighbouring_triangles(on_source);
        found.source_folds = count_folds(on_source, pairs);
        found.target_folds = count_folds(on_target, pairs);
        found.source_crossings = static_cast<int>(self_intersections(on_source).triangles.size());
        found.target_crossings = static_cast<int>(self_intersections(on_target).triangles.size());
        const Points normals = triangle_normals(on_target);
        for (int t = 0; t < on_target.triangle_count(); ++t) {
            Vector3d middle = Vector3d::Zero();
            double longest = 0;
            for (int k = 0; k < 3; ++k) {
                const RowVector3d p = on_target.points.row(on_target.triangles(t, k));
                middle += p.transpose() / 3;
                longest = std::max(longest, (on_target.points.row(on_target.triangles(t, (k + 1) % 3)) - p).norm());
            }
            found.flipped += target_surface.nearest(middle, normals.row(t), 0, longest).triangle < 0;
        }
        for (int v = 0; v < skins.vertex_count(); ++v)
            found.residuals.push_back(static_cast<float>(target.size.size * target_surface.nearest(skins.target.row(v), Vector3d::Zero(), -1, k_anywhere).distance));
        found.connectivity = changes;
        found.flatness = alignment.flatness;
        found.bent = alignment.radial.has_value();
        found.warnings = warnings;
        if (stage != Stage::done) found.warnings.push_back({"stopped-early", 1, {}, false});
        if (found.target_crossings > 0) found.warnings.push_back({"crossings-left", found.target_crossings, {}, false});
        if (refused > 0) found.warnings.push_back({"step-refused", refused, {}, false});
        if (full) found.warnings.push_back({"skins-full", 1, {}, false});
        found.seconds = seconds;
        found.seconds.report = watch.lap();
        return found;
    }
};

MatchSession::MatchSession(const WorkingMesh& source, const WorkingMesh& target, const Points& source_markers, const Points& target_markers, const MatchOptions& options) {
    Stopwatch watch;
    check(options);
    state_ = std::make_unique<State>(source, target, source_markers, target_markers, options);
    state_->align();
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
    // Shares of the time as measured.
    constexpr double carried = 0.35, fitted = 0.95;
    switch (s.stage) {
    case State::Stage::start: return 0;
    case State::Stage::carry: return carried * s.iteration / s.carry_iterations();
    case State::Stage::untangle: return carried;
    case State::Stage::fine:
    case State::Stage::edges:
    case State::Stage::relax: return carried + (fitted - carried) * s.iteration / s.options.fine_steps;
    case State::Stage::project: return fitted + (1 - fitted) * s.iteration / k_projections;
    case State::Stage::done: break;
    }
    return 1;
}

MatchResult MatchSession::result() const {
    const State& s = *state_;
    MatchResult out;
    if (s.stage == State::Stage::start) throw InvalidInput("not-begun", "The match has not begun. Call step() first.");
    out.report = s.report(out.marker_vertices);
    out.skins = s.skins;
    out.skins.source = s.source.outwards(s.skins.source);
    out.skins.target = s.target.outwards(s.skins.target);
    if (!out.skins.source.allFinite() || !out.skins.target.allFinite()) throw SolverFailure("The match ran out of numbers: a position is not finite. Try other markers.");
    return out;
}

const MarkerAlignment& MatchSession::alignment() const { return state_->alignment; }
Points MatchSession::target_positions() const { return state_->target.outwards(state_->skins.target); }
const Triangles& MatchSession::triangles() const { return state_->skins.triangles; }

} // namespace lissom
