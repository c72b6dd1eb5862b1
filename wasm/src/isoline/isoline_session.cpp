#include "lissom/isoline/isoline_session.h"

#include "field_handles.h"

#include "lissom/isoline/free_handles.h"
#include "lissom/isoline/full_pass.h"
#include "lissom/isoline/harmonic_fields.h"
#include "lissom/isoline/reduced_solver.h"
#include "lissom/isoline/taubin.h"
#include "lissom/mesh/errors.h"
#include "lissom/mesh/stopwatch.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

namespace lissom {
namespace {

using Eigen::Affine3d;
using Eigen::Matrix3d;
using Eigen::Vector3d;

/// An edge between two handles this much longer than at rest is a tear.
constexpr double k_torn = 2;
/// Pairs of smoothing steps that tell details from the surface they lie on.
constexpr int k_detail_steps = 20;

void check(const IsolineOptions& o) {
    const auto refuse = [](const std::string& sentence) { throw InvalidInput("bad-option", sentence); };
    (void)FieldBasis(o.basis, o.controls);
    if (!(o.smoothness > 0 && o.smoothness <= 1)) refuse("The smoothness is " + std::to_string(o.smoothness) + "; it must be above 0 and at most 1.");
    if (o.patches < 1 || o.patches > 2000) refuse("The number of patches is " + std::to_string(o.patches) + "; it must be between 1 and 2000.");
    if (o.sampled_triangles < 1) refuse("The number of sampled triangles is " + std::to_string(o.sampled_triangles) + "; it must be 1 or more.");
    if (o.solves < 1) refuse("The number of solves is " + std::to_string(o.solves) + "; it must be 1 or more.");
    if (o.acceleration < 0 || o.acceleration > 50) refuse("The memory of the acceleration is " + std::to_string(o.acceleration) + "; it must be between 0 and 50.");
    if (o.free_handles < 0 || o.free_handles > 64) refuse("The number of free handles is " + std::to_string(o.free_handles) + "; it must be between 0 and 64.");
    if (o.settle_passes < 1 || o.settle_passes > 3) refuse("The number of full passes is " + std::to_string(o.settle_passes) + "; it must be 1, 2 or 3.");
}

} // namespace

struct IsolineSession::State {
    enum class Stage { fields, solve, free_fields, free_solve, reduce, done };

    const IsolineModel& model;
    IsolineOptions options;
    std::vector<DeformHandle> handles;
    std::vector<int> roi;

    FieldHandles held{};
    std::optional<HarmonicFields> harmonic{};
    Columns fields{};  ///< surface vertices × fields
    Columns guess{};   ///< the same before free handles were placed; empty where none were
    Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> working_fields{};
    ControlSets sets{FieldBasis(BasisKind::hats, 2)};
    std::optional<ReducedSolver> solver{}; ///< none where one handle holds all
    Columns lone{};                        ///< the controls then
    int free_handles = 0;
    Stage stage = Stage::fields;
    std::vector<Finding> warnings{};
    std::vector<std::pair<int, int>> unused_sources{}; ///< source vertices in no triangle and the region handle that names them
    IsolineSeconds seconds{};

    std::vector<Affine3d> targets{}; ///< of the user's handles, source space

    std::optional<FullPass> full{};
    Points base{};                   ///< working vertices without details
    VertexRings base_rings{};
    int base_steps = 0;
    bool settle_ready = false;

    [[nodiscard]] int field_count() const { return static_cast<int>(held.ends.size()); }
    [[nodiscard]] const Columns& controls() const { return solver ? solver->controls() : lone; }

    [[nodiscard]] std::span<const float> row(int w) const {
        return {working_fields.data() + static_cast<Eigen::Index>(w) * working_fields.cols(), static_cast<std::size_t>(working_fields.cols())};
    }

    /// Fields of working vertex w as numbers that sum to one; false: none rules there.
    bool fields_at(int w, std::vector<double>& values) const {
        values.assign(row(w).begin(), row(w).end());
        double sum = 0;
        for (const double value : values) sum += value;
        if (!(sum > 0)) return false;
        for (double& value : values) value /= sum; // their floats sum to one within 1e-7 only
        return true;
    }

    void begin_fields() { harmonic.emplace(model.surface().mesh, model.laplacian(), held.of_surface, field_count()); }

    void place_free() {
        FreeHandleOptions wanted;
        wanted.most = options.free_handles;
        std::vector<std::vector<int>> discs;
        if (options.free_handles > 0 && field_count() > 1)
            discs = place_free_handles(model.surface().mesh, model.rings(), fields, held.of_surface, wanted);
        free_handles = static_cast<int>(discs.size());
        for (const std::vector<int>& disc : discs) {
            for (const int s : disc) held.of_surface[s] = field_count();
            held.ends.push_back({HandleEnd::Kind::open});
        }
    }

    void reduce() {
        sets = {FieldBasis(options.basis, options.controls), field_count()};
        const TriangleMesh& mesh = model.surface().mesh;
        if (field_count() == 1) {
            lone = Columns::Zero(4 * sets.controls(), 3);
        } else {
            const int most = std::max(1, mesh.vertex_count() / 12); // a patch of a dozen vertices has triangles of its own
            const PatchOptions patches{std::min(options.patches, most), std::max(1, options.sampled_triangles / options.patches)};
            Carriers carriers = options.local == LocalStep::isolines
                                    ? isoline_carriers(mesh, fields, sets, held.ends, options.sampled_triangles)
                                    : patch_carriers(mesh, fields, held.of_surface, held.ends, patches);
            if (guess.size() > 0) carriers.guess_by(guess);
            guess.resize(0, 0);
            ReducedEnergy energy = reduced_energy(mesh, model.laplacian(), model.areas(), fields, sets, carriers.details, held.ends, options.smoothness);
            solver.emplace(mesh, model.laplacian(), model.areas(), fields, sets, std::move(carriers), std::move(energy), held.ends,
                           ReducedSolver::Options{options.acceleration, options.tolerance, options.scale_details, options.local == LocalStep::positions});
        }
        working_fields = model.to_working(fields);
        for (std::size_t w = 0; w < held.of_working.size(); ++w)
            if (held.of_working[w] >= 0) {
                working_fields.row(static_cast<Eigen::Index>(w)).setZero();
                working_fields(static_cast<Eigen::Index>(w), held.of_working[w]) = 1;
            }
    }

    void warn() {
        const WorkingMesh& working = model.working();
        Finding loose{"component-without-handle", 0, {}, true};
        const Components pieces = components(model.rings());
        std::vector<char> seen(static_cast<std::size_t>(pieces.count), 0);
        bool any_free = false;
        for (std::size_t s = 0; s < held.of_surface.size(); ++s) {
            any_free = any_free || held.of_surface[s] < 0;
            const int piece = pieces.of_vertex[s];
            if (seen[piece] || (fields.row(static_cast<Eigen::Index>(s)).array() != 0).any()) continue;
            seen[piece] = 1;
            ++loose.count;
            if (loose.examples.size() < 8) loose.examples.push_back(working.source_of_working[model.surface().fine[s]]);
        }
        if (loose.count > 0) warnings.push_back(std::move(loose));
        if (!any_free) warnings.push_back({"nothing-free", 1, {}, false});
        if (!held.touching.empty()) {
            Finding touching{"handles-touch", static_cast<int>(held.touching.size()), {}, false};
            for (const auto& pair : held.touching)
                for (const int h : {pair[0], pair[1]})
                    if (touching.examples.size() < 8 && std::find(touching.examples.begin(), touching.examples.end(), h) == touching.examples.end())
                        touching.examples.push_back(h);
            warnings.push_back(std::move(touching));
        }
        if (free_handles > 0) warnings.push_back({"free-handles", free_handles, {}, true});
        for (int h = 0; h < std::ssize(handles); ++h)
            for (const int v : handles[h].vertices)
                if (working.working_of_source[v] < 0 && working.source.row(v).allFinite()) unused_sources.emplace_back(v, h);
    }

    void advance() {
        Stopwatch watch;
        switch (stage) {
        case Stage::fields:
        case Stage::free_fields:
            if (!harmonic) begin_fields();
            else if (!harmonic->step()) stage = stage == Stage::fields ? Stage::solve : Stage::free_solve;
            break;
        case Stage::solve:
            fields = harmonic->solve();
            harmonic.reset();
            place_free();
            if (free_handles > 0) {
                guess = Columns::Zero(fields.rows(), field_count());
                guess.leftCols(fields.cols()) = fields;
            }
            stage = free_handles > 0 ? Stage::free_fields : Stage::reduce;
            break;
        case Stage::free_solve:
            fields = harmonic->solve();
            harmonic.reset();
            stage = Stage::reduce;
            break;
        case Stage::reduce:
            reduce();
            warn();
            stage = Stage::done;
            seconds.reduce += watch.lap();
            return;
        case Stage::done: return;
        }
        seconds.fields += watch.lap();
    }

    /// x + Σ w (D x + t) of every working vertex, D = 1; those in `points` stand for the rest.
    [[nodiscard]] Points blend(const Points& points) const {
        Points moved = points;
        std::vector<double> values;
        std::vector<ControlSets::Entry> entries;
        const Columns& d = controls();
        for (int w = 0; w < static_cast<int>(points.rows()); ++w) {
            if (!fields_at(w, values)) continue;
            sets.entries_at(values, entries);
            moved.row(w) = blended(points.row(w), entries, d).transpose();
        }
        return moved;
    }

    [[nodiscard]] Points to_source(const Points& moved) const {
        const WorkingMesh& working = model.working();
        Points out = working.source;
        for (std::size_t v = 0; v < working.working_of_source.size(); ++v) {
            const int w = working.working_of_source[v];
            if (w < 0) continue;
            const int h = held.of_working[w];
            if (h >= 0 && h < held.user) out.row(static_cast<Eigen::Index>(v)) = (targets[h] * Vector3d(working.source.row(static_cast<Eigen::Index>(v)))).transpose();
            else if (h < 0) out.row(static_cast<Eigen::Index>(v)) += working.scale * (moved.row(w) - working.mesh.points.row(w));
        }
        for (const auto& [v, h] : unused_sources)
            if (!handles[static_cast<std::size_t>(h)].is_point) out.row(v) = (targets[h] * Vector3d(working.source.row(v))).transpose();
        return out;
    }

    [[nodiscard]] Columns field_columns(int f) const {
        Columns one(working_fields.rows(), 1);
        one.col(0) = working_fields.col(f).cast<double>();
        return one;
    }

    template <class Value>
    [[nodiscard]] Eigen::VectorXf by_source(const Value& of_working) const {
        const std::vector<int>& map = model.working().working_of_source;
        Eigen::VectorXf out = Eigen::VectorXf::Zero(std::ssize(map));
        for (std::size_t v = 0; v < map.size(); ++v)
            if (map[v] >= 0) out[static_cast<Eigen::Index>(v)] = static_cast<float>(of_working(map[v]));
        return out;
    }
};

IsolineSession::IsolineSession(const IsolineModel& model, std::span<const int> roi, std::span<const DeformHandle> handles, IsolineOptions options)
    : state_(new State{.model = model, .options = options, .handles = {handles.begin(), handles.end()}, .roi = {roi.begin(), roi.end()}}) {
    check(options);
    state_->held = field_handles(model, roi, handles);
    state_->targets.assign(handles.size(), Affine3d::Identity());
}
IsolineSession::~IsolineSession() = default;
IsolineSession::IsolineSession(IsolineSession&&) noexcept = default;

bool IsolineSession::step() {
    state_->advance();
    return state_->stage != State::Stage::done;
}

double IsolineSession::fraction() const {
    const State& s = *state_;
    const double here = s.harmonic ? s.harmonic->fraction() : 0;
    switch (s.stage) {
    case State::Stage::fields: return 0.5 * here;
    case State::Stage::solve: return 0.5;
    case State::Stage::free_fields: return 0.55 + 0.2 * here;
    case State::Stage::free_solve: return 0.75;
    case State::Stage::reduce: return 0.8;
    case State::Stage::done: break;
    }
    if (s.settle_ready) return 1;
    if (s.full) return s.full->fraction();
    return s.base.rows() > 0 ? static_cast<double>(s.base_steps) / k_detail_steps : 1;
}

IsolineFrame IsolineSession::drag(std::span<const Affine3d> targets, int solves, bool afresh) {
    State& s = *state_;
    if (targets.size() != s.handles.size())
        throw InvalidInput("handle-count", "There are " + std::to_string(s.handles.size()) + " handles but " + std::to_string(targets.size()) +
                                               " targets. Give one for each handle.");
    for (std::size_t h = 0; h < targets.size(); ++h)
        if (!targets[h].matrix().allFinite())
            throw InvalidInput("non-finite-target", "The target of handle " + std::to_string(h + 1) + " holds a number that is not finite. Reset the handle.");
    s.targets.assign(targets.begin(), targets.end());
    const WorkingMesh& working = s.model.working();
    ReducedTargets there;
    for (const Affine3d& target : targets) there.maps.push_back(working.to_working(target));
    there.maps.resize(static_cast<std::size_t>(s.field_count()), Affine3d::Identity());

    IsolineFrame frame;
    if (s.solver) {
        const ReducedStep step = s.solver->frame(there, solves > 0 ? solves : s.options.solves, afresh);
        frame.solves = step.solves;
        frame.change = step.change;
        frame.local_seconds = step.local_seconds;
        frame.global_seconds = step.global_seconds;
    } else { // one handle holds everything: all of it follows, a point by its move alone
        const Affine3d& map = there.maps[0];
        const bool point = s.held.ends[0].kind == HandleEnd::Kind::point;
        const Eigen::Index end = 4 * s.sets.end_control(0);
        if (!point) s.lone.middleRows<3>(end) = (map.linear() - Matrix3d::Identity()).transpose();
        s.lone.row(end + 3) = (point ? Vector3d(map * s.held.ends[0].at - s.held.ends[0].at) : Vector3d(map.translation())).transpose();
    }
    Finding torn{"handles-pulled-apart", 0, {}, false};
    for (const auto& [a, b, v, w] : s.held.touching) {
        const Vector3d p = working.mesh.points.row(v), q = working.mesh.points.row(w);
        if (!((there.maps[a] * p - there.maps[b] * q).norm() > k_torn * (p - q).norm())) continue;
        ++torn.count;
        for (const int h : {a, b})
            if (torn.examples.size() < 8 && std::find(torn.examples.begin(), torn.examples.end(), h) == torn.examples.end()) torn.examples.push_back(h);
    }
    if (torn.count > 0) frame.warnings.push_back(std::move(torn));
    return frame;
}

Points IsolineSession::positions() const {
    const Points moved = state_->blend(state_->model.working().mesh.points);
    if (!moved.allFinite()) throw SolverFailure("The deformation ran out of numbers: a position is not finite. Move the handles less far.");
    return state_->to_source(moved);
}

Points IsolineSession::blended_normals(const Points& rest_normals) const {
    const State& s = *state_;
    const TriangleMesh& mesh = s.model.working().mesh;
    std::vector<Columns> gradients;
    for (int f = 0; f < s.field_count(); ++f) gradients.push_back(field_gradients(mesh, s.field_columns(f)));
    Points normals = rest_normals;
    std::vector<double> values;
    std::vector<ControlSets::Entry> entries;
    const Columns& d = s.controls();
    for (int w = 0; w < mesh.vertex_count(); ++w) {
        if (!s.fields_at(w, values)) continue;
        s.sets.entries_at(values, entries);
        const Vector3d x = mesh.points.row(w);
        Matrix3d J = Matrix3d::Identity();
        for (const ControlSets::Entry& e : entries) {
            const Eigen::Index row = 4 * e.control;
            const Matrix3d D = d.middleRows<3>(row).transpose();
            const int f = s.sets.field_of_set(e.control / s.sets.basis.controls());
            J += e.weight * D + e.slope * (D * x + d.row(row + 3).transpose()) * gradients[f].row(w);
        }
        Matrix3d cofactors;
        for (int k = 0; k < 3; ++k) cofactors.col(k) = J.col((k + 1) % 3).cross(J.col((k + 2) % 3));
        normals.row(w) = (cofactors * rest_normals.row(w).transpose()).normalized().transpose();
    }
    return normals;
}

bool IsolineSession::settles_fully() const { return state_->model.working().mesh.vertex_count() <= state_->options.settle_limit; }

bool IsolineSession::settle_step() {
    State& s = *state_;
    if (s.settle_ready) return false;
    Stopwatch watch;
    if (settles_fully()) {
        if (!s.full) s.full.emplace(s.model.working(), s.roi, s.handles);
        else s.settle_ready = !s.full->step();
    } else if (s.base.rows() == 0) {
        s.base = s.model.working().mesh.points;
        s.base_rings = vertex_rings(s.model.working().mesh);
    } else {
        taubin_step(s.base, s.base_rings);
        s.settle_ready = ++s.base_steps == k_detail_steps;
        if (s.settle_ready) s.base_rings = {};
    }
    s.seconds.settle += watch.lap();
    return !s.settle_ready;
}

Points IsolineSession::settled() const {
    const State& s = *state_;
    const WorkingMesh& working = s.model.working();
    if (s.full) return s.full->apply(positions(), s.targets, s.options.settle_passes);
    std::vector<bool> kept(s.held.of_working.size());
    for (std::size_t w = 0; w < kept.size(); ++w) kept[w] = s.held.of_working[w] >= 0 || !(working.mesh.points.row(static_cast<Eigen::Index>(w)).allFinite());
    const Points moved = with_turned_details(working.mesh, s.blend(working.mesh.points), s.base, s.blend(s.base), kept);
    if (!moved.allFinite()) throw SolverFailure("The deformation ran out of numbers: a position is not finite. Move the handles less far.");
    return s.to_source(moved);
}

const ControlSets& IsolineSession::sets() const { return state_->sets; }
int IsolineSession::field_count() const { return state_->field_count(); }
int IsolineSession::free_handle_count() const { return state_->free_handles; }
bool IsolineSession::holds_rest() const { return state_->held.rest; }

std::vector<float> IsolineSession::set_fields() const {
    const State& s = *state_;
    const std::vector<int>& map = s.model.working().working_of_source;
    const auto k = static_cast<std::size_t>(s.sets.sets());
    std::vector<float> out(map.size() * k, 0);
    for (std::size_t v = 0; v < map.size(); ++v)
        if (map[v] >= 0)
            for (std::size_t set = 0; set < k; ++set) out[v * k + set] = s.row(map[v])[static_cast<std::size_t>(s.sets.field_of_set(static_cast<int>(set)))];
    return out;
}

std::vector<float> IsolineSession::set_gradients() const {
    const State& s = *state_;
    const WorkingMesh& working = s.model.working();
    const std::vector<int>& map = working.working_of_source;
    const auto k = static_cast<std::size_t>(s.sets.sets());
    std::vector<float> out(3 * map.size() * k, 0);
    for (std::size_t set = 0; set < k; ++set) { // a set at a time: all of a large model's in double would not fit
        const Columns gradients = field_gradients(working.mesh, s.field_columns(s.sets.field_of_set(static_cast<int>(set))));
        for (std::size_t v = 0; v < map.size(); ++v)
            if (map[v] >= 0)
                for (std::size_t r = 0; r < 3; ++r)
                    out[3 * (v * k + set) + r] = static_cast<float>(gradients(map[v], static_cast<Eigen::Index>(r)) / working.scale);
    }
    return out;
}

std::vector<std::uint8_t> IsolineSession::still_vertices() const {
    const State& s = *state_;
    const std::vector<int>& map = s.model.working().working_of_source;
    std::vector<std::uint8_t> still(map.size(), 1);
    for (std::size_t v = 0; v < map.size(); ++v)
        if (map[v] >= 0)
            for (const float value : s.row(map[v])) still[v] = still[v] != 0 && value == 0;
    return still;
}

Eigen::VectorXf IsolineSession::field(int f) const {
    return state_->by_source([&](int w) { return state_->row(w)[static_cast<std::size_t>(f)]; });
}

Eigen::VectorXf IsolineSession::rigidity(int f) const {
    const State& s = *state_;
    Eigen::VectorXd squares = Eigen::VectorXd::Zero(s.working_fields.rows());
    for (int i = 0; i < s.field_count(); ++i) // a field at a time: all of a large model's at once would not fit
        if (f < 0 || i == f) squares += rigidity_fields(s.model.working().mesh, s.field_columns(i)).col(0).cwiseAbs2();
    return s.by_source([&](int w) { return std::sqrt(squares[w]) / s.model.working().scale; });
}

std::vector<double> IsolineSession::control_offsets() const {
    const WorkingMesh& working = state_->model.working();
    const Columns& d = state_->controls();
    std::vector<double> out;
    out.reserve(static_cast<std::size_t>(3 * d.rows()));
    for (Eigen::Index c = 0; c < d.rows() / 4; ++c)
        for (int axis = 0; axis < 3; ++axis) {
            const Eigen::RowVector3d linear = d.col(axis).segment<3>(4 * c).transpose();
            out.insert(out.end(), {linear[0], linear[1], linear[2], d(4 * c + 3, axis) * working.scale - linear.dot(working.centre)});
        }
    return out;
}

std::vector<Isoline> IsolineSession::isolines(int f, int count) const {
    const State& s = *state_;
    std::vector<Isoline> lines;
    for (int k = 1; k < count - 1; ++k) {
        lines.push_back(isoline(s.model.surface().mesh, s.fields.col(f), static_cast<double>(k) / (count - 1)));
        for (IsolineSegment& segment : lines.back().segments) {
            segment.from = s.model.working().to_source(segment.from);
            segment.to = s.model.working().to_source(segment.to);
            segment.length *= s.model.working().scale;
        }
    }
    return lines;
}

int IsolineSession::unknowns() const { return state_->solver ? state_->solver->unknowns() : 0; }
int IsolineSession::sampled_triangles() const { return state_->solver ? state_->solver->sampled_triangles() : 0; }
const IsolineSeconds& IsolineSession::seconds() const { return state_->seconds; }
const std::vector<Finding>& IsolineSession::warnings() const { return state_->warnings; }

double IsolineSession::memory_bytes() const {
    const State& s = *state_;
    return 8.0 * static_cast<double>(s.fields.size() + s.base.size()) + 4.0 * static_cast<double>(s.working_fields.size() + s.held.of_working.size()) +
           (s.harmonic ? s.harmonic->memory_bytes() : 0) + (s.solver ? s.solver->memory_bytes() : 0) + (s.full ? s.full->memory_bytes() : 0);
}

} // namespace lissom
