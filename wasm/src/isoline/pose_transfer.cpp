#include "lissom/isoline/pose_transfer.h"

#include "field_handles.h"

#include "lissom/deform/held_region.h"
#include "lissom/isoline/field_basis.h"
#include "lissom/isoline/harmonic_fields.h"
#include "lissom/isoline/reduced_solver.h"
#include "lissom/isoline/triangle_frames.h"
#include "lissom/mesh/errors.h"
#include "lissom/mesh/operators.h"
#include "lissom/mesh/polar.h"
#include "lissom/mesh/stopwatch.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include <algorithm>
#include <numeric>
#include <optional>
#include <string>
#include <utility>

namespace lissom {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Floats = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

constexpr int k_controls = 10;
constexpr double k_smoothness = 0.01;
/// Weight of a handle's place beside the target's stiffness (D = 1), shared by its vertices: says where a piece stands and pulls at nothing.
constexpr double k_anchor = 1e-4;
/// A handle this far (D = 1) from where the source's went is moved a quarter of the way there, a nearer one almost all of it: directions add up
/// errors along limbs (feet of people end 0.03 off), but ten times as much is a difference in build or stretch, and to be left.
constexpr double k_plausible = 0.1;
/// Solves in which triangles that only turn may keep the stretch they came to.
constexpr int k_stretch_rounds = 2;
/// What they may keep (Frobenius norm of the stretch less the identity): a thick bar bent by a right angle needs 0.2, a triangle about to fold has 1.
constexpr double k_most_stretch = 0.25;
/// Cotangents at most this, as in cotangent_laplacian.
constexpr double k_height_floor = 1e-4;

/// Fields of the handles on one of the models.
struct Side {
    const WorkingMesh& working;
    const char* name;
    std::vector<DeformHandle> handles{};
    IsolineModel model;
    FieldHandles held{};
    std::optional<HarmonicFields> harmonic{};
    Floats fields{};  ///< working vertices × handles
    bool ready = false;

    Side(const WorkingMesh& mesh, const char* called, std::span<const std::vector<int>> groups) : working(mesh), name(called), model(mesh) {
        for (const std::vector<int>& group : groups) handles.push_back({group.size() == 1, group});
        (void)said([&] { return assign_all(); }); // before anything takes long
    }

    /// What is wrong with handles, with the model they are on.
    template <class Work>
    auto said(Work work) const -> decltype(work()) {
        try {
            return work();
        } catch (const InvalidInput& error) {
            throw InvalidInput(error.code(), std::string("On the ") + name + ": " + error.what());
        }
    }
    [[nodiscard]] std::vector<int> everything() const {
        std::vector<int> all(working.working_of_source.size());
        std::iota(all.begin(), all.end(), 0);
        return all;
    }
    [[nodiscard]] Roles assign_all() const { return assign_roles(working, everything(), handles); }

    bool step() {
        if (ready || model.step()) return !ready;
        if (!harmonic) {
            held = said([&] { return field_handles(model, everything(), handles); });
            harmonic.emplace(model.surface().mesh, model.laplacian(), held.of_surface, static_cast<int>(held.ends.size()));
            return true;
        }
        if (harmonic->step()) return true;
        fields = model.to_working(harmonic->solve());
        harmonic.reset();
        for (std::size_t w = 0; w < held.of_working.size(); ++w)
            if (held.of_working[w] >= 0) {
                fields.row(static_cast<Eigen::Index>(w)).setZero();
                fields(static_cast<Eigen::Index>(w), held.of_working[w]) = 1;
            }
        ready = true;
        return false;
    }
    [[nodiscard]] double fraction() const { return ready ? 1 : 0.5 * model.fraction() + (harmonic ? 0.5 * harmonic->fraction() : 0); }

    /// Controls that act on a triangle, by the mean of its corners' fields. @returns false where no field reaches
    bool entries(const ControlSets& sets, int t, std::vector<ControlSets::Entry>& found) const {
        const Triangles& T = working.mesh.triangles;
        std::vector<double> mean(static_cast<std::size_t>(fields.cols()));
        double sum = 0;
        for (Eigen::Index f = 0; f < fields.cols(); ++f) {
            mean[static_cast<std::size_t>(f)] = static_cast<double>(fields(T(t, 0), f)) + fields(T(t, 1), f) + fields(T(t, 2), f);
            sum += mean[static_cast<std::size_t>(f)];
        }
        found.clear();
        if (!(sum > 0)) return false;
        for (double& value : mean) value /= sum;
        sets.entries_at(mean, found);
        return true;
    }
};

bool same_shape(const WorkingMesh& a, const WorkingMesh& b) {
    return a.working_of_source.size() == b.working_of_source.size() && a.mesh.triangle_count() == b.mesh.triangle_count() &&
           a.mesh.vertex_count() == b.mesh.vertex_count() && a.mesh.triangles == b.mesh.triangles &&
           (a.mesh.points - b.mesh.points).cwiseAbs().maxCoeff() < 1e-9; // D = 1
}

/// The rotation of B to a power, and its stretch as far.
Matrix3d powered(const Matrix3d& B, const TransferOptions& options) {
    const Matrix3d R = nearest_rotation(B);
    const Matrix3d turned = options.strength == 1 ? R : rotation_of(options.strength * rotation_vector(R));
    if (!options.keep_stretch) return turned;
    return turned * (Matrix3d::Identity() + options.strength * (R.transpose() * B - Matrix3d::Identity()));
}

} // namespace

struct PoseTransfer::State {
    Side source, target;
    ControlSets sets;
    bool same = false;
    Eigen::LLT<Eigen::MatrixXd> fit{};   ///< controls²
    Eigen::VectorXd source_areas{};
    Eigen::Matrix<double, Eigen::Dynamic, 3> cotangents{}; ///< half of them, of the target's corners
    std::vector<int> unknown{};          ///< of the target's working vertices; −1: no field reaches it
    std::optional<SparseCholesky> factor{};
    bool factored = false;
    std::vector<Finding> warnings{};
    TransferSeconds seconds{};

    void reduce() {
        const TriangleMesh& mesh = source.working.mesh;
        source_areas = triangle_areas(mesh);
        Eigen::MatrixXd M = Eigen::MatrixXd::Zero(sets.controls(), sets.controls());
        std::vector<ControlSets::Entry> entries;
        for (int t = 0; t < mesh.triangle_count(); ++t)
            if (source.entries(sets, t, entries))
                for (const auto& a : entries)
                    for (const auto& b : entries) M(a.control, b.control) += source_areas[t] * a.weight * b.weight;
        const double smoothness = k_smoothness * k_smoothness * (k_controls - 1);
        for (int c = 0; c + 1 < sets.controls(); ++c) {
            if ((c + 1) % k_controls == 0) continue; // the next set's
            M(c, c) += smoothness;
            M(c + 1, c + 1) += smoothness;
            M(c, c + 1) -= smoothness;
            M(c + 1, c) -= smoothness;
        }
        // A set none of whose field lies on the surface is left open by all of that: rest.
        M.diagonal().array() += 1e-9 * M.diagonal().mean();
        fit.compute(M);
        if (fit.info() != Eigen::Success) throw SolverFailure("The fit of the source's pose is not positive definite. Place its handles farther apart.");
    }

    void begin_factor() {
        const TriangleMesh& mesh = target.working.mesh;
        unknown.assign(static_cast<std::size_t>(mesh.vertex_count()), -1);
        int count = 0;
        for (int v = 0; v < mesh.vertex_count(); ++v)
            if ((target.fields.row(v).array() != 0).any()) unknown[v] = count++;
        cotangents.resize(mesh.triangle_count(), 3);
        std::vector<Eigen::Triplet<double>> entries;
        Points coordinates(count, 3);
        for (int v = 0; v < mesh.vertex_count(); ++v)
            if (unknown[v] >= 0) coordinates.row(unknown[v]) = mesh.points.row(v);
        for (int t = 0; t < mesh.triangle_count(); ++t)
            for (int k = 0; k < 3; ++k) {
                const int i = mesh.triangles(t, (k + 1) % 3), j = mesh.triangles(t, (k + 2) % 3);
                const Vector3d u = mesh.points.row(i) - mesh.points.row(mesh.triangles(t, k)), w = mesh.points.row(j) - mesh.points.row(mesh.triangles(t, k));
                const double longest = std::max({u.squaredNorm(), w.squaredNorm(), (u - w).squaredNorm()});
                cotangents(t, k) = longest > 0 ? 0.5 * u.dot(w) / std::max(u.cross(w).norm(), k_height_floor * longest) : 0;
                if (unknown[i] < 0 || unknown[j] < 0) continue;
                entries.emplace_back(unknown[i], unknown[i], cotangents(t, k));
                entries.emplace_back(unknown[j], unknown[j], cotangents(t, k));
                entries.emplace_back(std::max(unknown[i], unknown[j]), std::min(unknown[i], unknown[j]), -cotangents(t, k));
            }
        const std::vector<int> sizes = handle_sizes(target);
        for (int v = 0; v < mesh.vertex_count(); ++v)
            if (const int h = target.held.of_working[v]; h >= 0) entries.emplace_back(unknown[v], unknown[v], k_anchor / sizes[h]);
        SparseMatrix A(count, count);
        A.setFromTriplets(entries.begin(), entries.end());
        factor.emplace(A, &coordinates);
        factor->begin(A);
    }

    [[nodiscard]] static std::vector<int> handle_sizes(const Side& side) {
        std::vector<int> sizes(side.handles.size(), 0);
        for (const int h : side.held.of_working)
            if (h >= 0) ++sizes[h];
        return sizes;
    }

    void warn() {
        const WorkingMesh& working = target.working;
        const Components pieces = components(vertex_rings(working.mesh));
        std::vector<char> seen(static_cast<std::size_t>(pieces.count), 0);
        Finding loose{"component-without-handle", 0, {}, true};
        for (int v = 0; v < working.mesh.vertex_count(); ++v) {
            if (unknown[v] >= 0 || seen[pieces.of_vertex[v]]) continue;
            seen[pieces.of_vertex[v]] = 1;
            ++loose.count;
            if (loose.examples.size() < 8) loose.examples.push_back(working.source_of_working[v]);
        }
        if (loose.count > 0) warnings.push_back(std::move(loose));
    }

    /// Working positions of a posed source.
    [[nodiscard]] Points posed(const Points& pose) const {
        if (pose.rows() != source.working.source.rows())
            throw InvalidInput("wrong-size", "The pose has " + std::to_string(pose.rows()) + " vertices, but its model has " +
                                                 std::to_string(source.working.source.rows()) + ".");
        Points moved(source.working.mesh.vertex_count(), 3);
        for (Eigen::Index v = 0; v < moved.rows(); ++v) {
            const int at = source.working.source_of_working[static_cast<std::size_t>(v)];
            if (!pose.row(at).allFinite())
                throw InvalidInput("non-finite-position", "Vertex " + std::to_string(at) + " of the pose is not a finite point. Compute the pose again.");
            moved.row(v) = source.working.to_working(Vector3d(pose.row(at))).transpose();
        }
        return moved;
    }

    /// Linear maps of the controls less the identity, each as a row of nine (column by column).
    [[nodiscard]] Eigen::Matrix<double, Eigen::Dynamic, 9> fitted(const std::vector<Matrix3d>& gradients) const {
        Eigen::Matrix<double, Eigen::Dynamic, 9> right = Eigen::Matrix<double, Eigen::Dynamic, 9>::Zero(sets.controls(), 9);
        std::vector<ControlSets::Entry> entries;
        for (int t = 0; t < static_cast<int>(gradients.size()); ++t) {
            if (!source.entries(sets, t, entries)) continue;
            const Matrix3d offset = source_areas[t] * (gradients[static_cast<std::size_t>(t)] - Matrix3d::Identity());
            for (const auto& e : entries) right.row(e.control) += e.weight * Eigen::Map<const Eigen::Matrix<double, 1, 9>>(offset.data());
        }
        return fit.solve(right);
    }

    /// What the whole source does in a pose, and what its handles do beside that: in the target's place.
    struct Places {
        Matrix3d turn;
        Points handles; ///< where each handle of the target is wanted in the mean
    };
    [[nodiscard]] Places places(const Points& moved, const std::vector<Matrix3d>& gradients, const TransferOptions& options) const {
        const TriangleMesh& rest = source.working.mesh;
        Matrix3d mean = Matrix3d::Zero();
        for (std::size_t t = 0; t < gradients.size(); ++t) mean += source_areas[static_cast<Eigen::Index>(t)] * gradients[t];
        const Matrix3d R = nearest_rotation(mean);
        const Eigen::RowVector3d from = middle(rest, rest.points), to = middle(rest, moved);
        const Points before = handle_means(source, rest.points), after = handle_means(source, moved), here = handle_means(target, target.working.mesh.points);
        const Eigen::RowVector3d there = middle(target.working.mesh, target.working.mesh.points);
        const Matrix3d turn = powered(R, {options.strength, false});
        const Points beside = (after.rowwise() - to) * R - (before.rowwise() - from); // Rᵀ of each, as rows
        Points wanted = ((here.rowwise() - there) + options.strength * beside) * turn.transpose();
        wanted.rowwise() += there + options.strength * (to - from);
        return {turn, std::move(wanted)};
    }

    /// Area-weighted middle of a surface.
    [[nodiscard]] static Eigen::RowVector3d middle(const TriangleMesh& mesh, const Points& points) {
        const Eigen::VectorXd areas = triangle_areas(mesh);
        Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
        for (int t = 0; t < mesh.triangle_count(); ++t)
            for (int k = 0; k < 3; ++k) sum += areas[t] / 3 * points.row(mesh.triangles(t, k));
        return areas.sum() > 0 ? Eigen::RowVector3d(sum / areas.sum()) : sum;
    }

    [[nodiscard]] static Points handle_means(const Side& side, const Points& points) {
        const std::vector<int> sizes = handle_sizes(side);
        Points means = Points::Zero(std::ssize(side.handles), 3);
        for (Eigen::Index v = 0; v < points.rows(); ++v)
            if (const int h = side.held.of_working[static_cast<std::size_t>(v)]; h >= 0) means.row(h) += points.row(v) / sizes[h];
        return means;
    }

    /// Displacements of the target's unknowns in one pose: right-hand side, and after `factor->solve` the rest.
    struct Pose {
        Points moved;
        std::vector<Matrix3d> gradients;
        Places to;
    };
    [[nodiscard]] Pose read(const Points& pose, const TransferOptions& options) const {
        Pose read{posed(pose), {}, {}};
        read.gradients = triangle_gradients(source.working.mesh, read.moved);
        read.to = places(read.moved, read.gradients, options);
        return read;
    }

    /// Linear maps that the target's triangles should have; the identity where no field reaches.
    [[nodiscard]] std::vector<Matrix3d> wanted(const Pose& pose, const TransferOptions& options) const {
        const TriangleMesh& mesh = target.working.mesh;
        const Eigen::Matrix<double, Eigen::Dynamic, 9> maps = fitted(pose.gradients);
        const TransferOptions whole{options.strength, options.keep_stretch || same};
        std::vector<ControlSets::Entry> entries;
        std::vector<Matrix3d> found(static_cast<std::size_t>(mesh.triangle_count()), Matrix3d::Identity());
        for (int t = 0; t < mesh.triangle_count(); ++t) {
            if (unknown[mesh.triangles(t, 0)] < 0 || !target.entries(sets, t, entries)) continue;
            Matrix3d B = Matrix3d::Identity();
            if (same) B = pose.gradients[static_cast<std::size_t>(t)];
            else
                for (const auto& e : entries) {
                    const Eigen::Matrix<double, 9, 1> flat = maps.row(e.control).transpose();
                    B += e.weight * Eigen::Map<const Matrix3d>(flat.data());
                }
            found[static_cast<std::size_t>(t)] = powered(B, whole);
        }
        return found;
    }

    /// Right-hand side of Eq 12 for these maps, and of the places.
    [[nodiscard]] Points right_side(const Pose& pose, const std::vector<Matrix3d>& maps, const TransferOptions& options) const {
        const TriangleMesh& mesh = target.working.mesh;
        Points right = Points::Zero(factor->size(), 3);
        for (int t = 0; t < mesh.triangle_count(); ++t) {
            if (unknown[mesh.triangles(t, 0)] < 0) continue;
            const Matrix3d offset = maps[static_cast<std::size_t>(t)] - Matrix3d::Identity();
            for (int k = 0; k < 3; ++k) { // each edge by its cotangent
                const int i = mesh.triangles(t, (k + 1) % 3), j = mesh.triangles(t, (k + 2) % 3);
                const Eigen::RowVector3d along = cotangents(t, k) * (mesh.points.row(i) - mesh.points.row(j)) * offset.transpose();
                right.row(unknown[i]) += along;
                right.row(unknown[j]) -= along;
            }
        }
        const std::vector<int> sizes = handle_sizes(target);
        const Points here = handle_means(target, mesh.points);
        for (int v = 0; v < mesh.vertex_count(); ++v)
            if (const int h = target.held.of_working[v]; h >= 0) {
                Eigen::RowVector3d there = pose.to.handles.row(h) + (mesh.points.row(v) - here.row(h)) * pose.to.turn.transpose() - mesh.points.row(v);
                if (same) there = options.strength * (pose.moved.row(v) - mesh.points.row(v));
                right.row(unknown[v]) += k_anchor / sizes[h] * there;
            }
        return right;
    }

    /// Lets triangles keep the stretch that they came to, in the frame of their own rotation: rotations alone fit no bent surface, and
    /// what does not fit turns back at the ends of a bend.
    void allow_stretch(const Points& u, std::vector<Matrix3d>& maps) const {
        const TriangleMesh& mesh = target.working.mesh;
        Points moved = mesh.points;
        for (int v = 0; v < mesh.vertex_count(); ++v)
            if (unknown[v] >= 0) moved.row(v) += u.row(unknown[v]);
        const std::vector<Matrix3d> came = triangle_gradients(mesh, moved);
        for (std::size_t t = 0; t < maps.size(); ++t) {
            const Matrix3d stretch = nearest_rotation(came[t]).transpose() * came[t] - Matrix3d::Identity();
            maps[t] *= Matrix3d::Identity() + std::min(1.0, k_most_stretch / std::max(stretch.norm(), 1e-300)) * stretch;
        }
    }

    /// Where the target is, D = 1, handles drawn to their places along their fields. @param u  displacements of the unknowns
    [[nodiscard]] Points placed(const Pose& pose, const Points& u) const {
        const TriangleMesh& mesh = target.working.mesh;
        Points moved = mesh.points;
        for (int v = 0; v < mesh.vertex_count(); ++v)
            if (unknown[v] >= 0) moved.row(v) += u.row(unknown[v]);
        if (same) return moved;
        Points way = pose.to.handles - handle_means(target, moved);
        for (Eigen::Index h = 0; h < way.rows(); ++h) {
            const double far = way.row(h).norm() / k_plausible, kept = 1 / (1 + far * far);
            way.row(h) *= kept * kept;
        }
        for (int v = 0; v < mesh.vertex_count(); ++v)
            if (unknown[v] >= 0) moved.row(v) += target.fields.row(v).cast<double>() * way / static_cast<double>(target.fields.row(v).sum());
        return moved;
    }
};

PoseTransfer::PoseTransfer(const WorkingMesh& source, std::span<const std::vector<int>> source_handles, const WorkingMesh& target,
                           std::span<const std::vector<int>> target_handles) {
    if (source_handles.size() != target_handles.size())
        throw InvalidInput("handle-count", "The source has " + std::to_string(source_handles.size()) + " handles and the target " +
                                               std::to_string(target_handles.size()) + ". Pair each handle with one on the other model.");
    state_.reset(new State{.source = Side(source, "source", source_handles),
                           .target = Side(target, "target", target_handles),
                           .sets = {FieldBasis(BasisKind::quadratic, k_controls), static_cast<int>(source_handles.size())}});
    state_->same = same_shape(source, target);
}
PoseTransfer::~PoseTransfer() = default;
PoseTransfer::PoseTransfer(PoseTransfer&&) noexcept = default;

bool PoseTransfer::step() {
    State& s = *state_;
    if (s.factored) return false;
    Stopwatch watch;
    if (s.source.step() || s.target.step()) {
        s.seconds.fields += watch.lap();
        return true;
    }
    if (!s.factor) {
        s.reduce();
        s.begin_factor();
        s.warn();
    } else s.factored = !s.factor->step();
    s.seconds.reduce += watch.lap();
    return !s.factored;
}

double PoseTransfer::fraction() const {
    const State& s = *state_;
    if (s.factored) return 1;
    return 0.3 * s.source.fraction() + 0.3 * s.target.fraction() + (s.factor ? 0.4 * s.factor->fraction() : 0);
}

std::vector<Points> PoseTransfer::transfer(std::span<const Points> poses, const TransferOptions& options) const {
    const State& s = *state_;
    if (!(options.strength >= -10 && options.strength <= 10))
        throw InvalidInput("bad-option", "The strength is " + std::to_string(options.strength) + "; it must be between -10 and 10.");
    Columns u(s.factor->size(), 3 * static_cast<Eigen::Index>(poses.size()));
    std::vector<State::Pose> read;
    std::vector<std::vector<Matrix3d>> maps;
    const int rounds = s.same || options.keep_stretch ? 1 : 1 + k_stretch_rounds;
    for (const Points& pose : poses) {
        read.push_back(s.read(pose, options));
        maps.push_back(s.wanted(read.back(), options));
    }
    std::vector<std::vector<Matrix3d>> rounded = maps;
    for (int round = 0; round < rounds; ++round) {
        for (std::size_t p = 0; p < poses.size(); ++p) {
            if (round > 0) {
                rounded[p] = maps[p];
                s.allow_stretch(u.middleCols<3>(3 * static_cast<Eigen::Index>(p)), rounded[p]);
            }
            u.middleCols<3>(3 * static_cast<Eigen::Index>(p)) = s.right_side(read[p], rounded[p], options);
        }
        if (u.size() > 0) s.factor->solve(u);
    }
    std::vector<Points> results;
    const WorkingMesh& working = s.target.working;
    for (std::size_t p = 0; p < poses.size(); ++p) {
        const Points there = s.placed(read[p], u.middleCols<3>(3 * static_cast<Eigen::Index>(p)));
        Points moved = working.source;
        for (std::size_t v = 0; v < working.working_of_source.size(); ++v)
            if (const int w = working.working_of_source[v]; w >= 0 && s.unknown[w] >= 0)
                moved.row(static_cast<Eigen::Index>(v)) += working.scale * (there.row(w) - working.mesh.points.row(w));
        results.push_back(std::move(moved));
    }
    return results;
}

int PoseTransfer::unknowns() const { return 4 * state_->sets.controls(); }
const TransferSeconds& PoseTransfer::seconds() const { return state_->seconds; }
const std::vector<Finding>& PoseTransfer::warnings() const { return state_->warnings; }
double PoseTransfer::memory_bytes() const {
    const State& s = *state_;
    return s.source.model.memory_bytes() + s.target.model.memory_bytes() + 4.0 * static_cast<double>(s.source.fields.size() + s.target.fields.size()) +
           24.0 * static_cast<double>(s.cotangents.rows()) + (s.factor ? 8 * s.factor->factor_entries() : 0);
}

} // namespace lissom
