#include "lissom/wear/skin_pose.h"

#include "lissom/mesh/errors.h"
#include "lissom/mesh/operators.h"
#include "lissom/mesh/polar.h"
#include "lissom/mesh/similarity.h"
#include "lissom/mesh/stopwatch.h"
#include "lissom/mesh/surface_places.h"
#include "lissom/mesh/surface_samples.h"
#include "lissom/wear/gradient_fit.h"
#include "lissom/wear/surface_turns.h"

#include "skin_checks.h"

#include <algorithm>
#include <numbers>
#include <optional>
#include <string>

namespace lissom {

using Eigen::AngleAxisd;
using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

constexpr int k_places = 1200;
/// Bodies of other builds that stand in one space differ by a degree or two; a turn of the whole is then about the same axis for both.
constexpr double k_alike = 15 * std::numbers::pi / 180;
/// Solves in which triangles that only turn may keep the stretch they came to. Given to other bodies and back a walk is off by 0.75 cm instead of
/// 1.1 to 1.3, raised arms by 1.35 instead of 1.3; volumes lose one per cent more.
constexpr int k_stretch_rounds = 2;
/// What they may keep (Frobenius norm of the stretch less the identity): a triangle about to fold has 1.
constexpr double k_most_stretch = 0.25;

/// Points that go along with a surface: each with its nearest place.
struct Riders {
    SurfacePlaces places;
    Points offsets; ///< from the place, at rest

    Riders(const TriangleMesh& surface, const Points& points) : places(places_on(surface, points)), offsets(Points::Zero(points.rows(), 3)) {
        for (Eigen::Index i = 0; i < points.rows(); ++i) {
            const int t = places.triangle[static_cast<std::size_t>(i)];
            if (t >= 0) offsets.row(i) = points.row(i) - places.weights.row(i) * corners(surface.triangles, surface.points, t);
        }
    }

    [[nodiscard]] static Matrix3d corners(const Triangles& triangles, const Points& points, int t) {
        Matrix3d rows;
        rows << points.row(triangles(t, 0)), points.row(triangles(t, 1)), points.row(triangles(t, 2));
        return rows;
    }

    /// Those without a place are left as given.
    void ride(const TriangleMesh& surface, const Points& moved, Points& points) const {
        const std::vector<Matrix3d> turns = surface_turns(surface, moved);
        for (Eigen::Index i = 0; i < points.rows(); ++i) {
            const int t = places.triangle[static_cast<std::size_t>(i)];
            if (t < 0) continue;
            Matrix3d turn = Matrix3d::Zero();
            for (int k = 0; k < 3; ++k) turn += places.weights(i, k) * turns[static_cast<std::size_t>(surface.triangles(t, k))];
            points.row(i) = places.weights.row(i) * corners(surface.triangles, moved, t) + offsets.row(i) * nearest_rotation(turn).transpose();
        }
    }
};

/// The rotation of F to a power, and its stretch as far.
Matrix3d powered(const Matrix3d& F, const SkinPoseOptions& options) {
    const Matrix3d R = nearest_rotation(F);
    AngleAxisd turn(R);
    turn.angle() *= options.strength;
    const Matrix3d turned = options.strength == 1 ? R : turn.toRotationMatrix();
    if (!options.keep_stretch) return turned;
    return turned * (Matrix3d::Identity() + options.strength * (R.transpose() * F - Matrix3d::Identity()));
}

/// Where the working vertices of a model are, in its own space.
Points on_surface(const WorkingMesh& model, const Points& positions) {
    Points points(model.mesh.vertex_count(), 3);
    for (Eigen::Index w = 0; w < points.rows(); ++w) points.row(w) = positions.row(model.source_of_working[static_cast<std::size_t>(w)]);
    return points;
}

} // namespace

struct SkinPose::State {
    TriangleMesh source;               ///< the model with the pose, at rest
    std::vector<int> source_vertices;  ///< of its vertices
    Eigen::Index pose_size = 0;        ///< rows of a pose
    Points target;                     ///< what gets it, per source vertex
    TriangleMesh from, to;             ///< the skins
    Matrix3d lay = Matrix3d::Identity(); ///< turns directions of the first space into those of the second
    double scale = 1;
    std::optional<Riders> skin, model; ///< the first skin on its model, the second model on its skin
    std::optional<GradientFit> fit;
    int rounds = 0;
    bool done = false;
    SkinPoseSeconds seconds;

    /// How the triangles of the first skin are mapped; one that tells nothing as what is around it turns.
    [[nodiscard]] std::vector<Matrix3d> maps(const Points& moved) const {
        std::vector<Matrix3d> found = surface_maps(from, moved);
        const std::vector<Matrix3d> turns = surface_turns(from, moved);
        for (std::size_t t = 0; t < found.size(); ++t) {
            if (!found[t].isZero(0)) continue;
            for (int k = 0; k < 3; ++k) found[t] += turns[static_cast<std::size_t>(from.triangles(static_cast<Eigen::Index>(t), k))];
            found[t] = nearest_rotation(found[t]);
        }
        return found;
    }

    /// Lets triangles keep the stretch that they came to, in the frame of their own rotation.
    void allow_stretch(const Points& moved, std::vector<Matrix3d>& wanted) const {
        const std::vector<Matrix3d> came = surface_maps(to, moved);
        for (std::size_t t = 0; t < wanted.size(); ++t) {
            if (came[t].isZero(0)) continue;
            const Matrix3d stretch = nearest_rotation(came[t]).transpose() * came[t] - Matrix3d::Identity();
            wanted[t] = nearest_rotation(wanted[t]) * (Matrix3d::Identity() + std::min(1.0, k_most_stretch / std::max(stretch.norm(), 1e-300)) * stretch);
        }
    }
};

SkinPose::SkinPose(const WorkingMesh& source, const WorkingMesh& target, const Triangles& triangles, const Points& from, const Points& to) : state_(std::make_unique<State>()) {
    check_skins(triangles, from, to);
    State& s = *state_;
    s.source = {on_surface(source, source.source), source.mesh.triangles};
    s.source_vertices = source.source_of_working;
    s.pose_size = source.source.rows();
    s.target = target.source;
    s.from = {from, triangles};
    s.to = {to, triangles};
    const SurfacePlaces places = sample_surface(s.to, k_places);
    if (places.size() == 0 || !(triangle_areas(s.from).sum() > 0)) throw InvalidInput("flat-skin", "A skin has no area. Match the models again.");
    const Similarity laid = fit_similarity(places.on(s.from), places.on(s.to));
    s.scale = laid.scale;
    if (AngleAxisd(laid.rotation).angle() > k_alike) s.lay = laid.rotation;
}

SkinPose::~SkinPose() = default;
SkinPose::SkinPose(SkinPose&&) noexcept = default;

bool SkinPose::step() {
    State& s = *state_;
    if (s.done) return false;
    Stopwatch watch;
    if (!s.skin) s.skin.emplace(s.source, s.from.points);
    else if (!s.model) s.model.emplace(s.to, s.target);
    else if (!s.fit) s.fit.emplace(s.to);
    else s.done = !s.fit->step();
    s.seconds.prepare += watch.lap();
    return !s.done;
}

double SkinPose::fraction() const {
    const State& s = *state_;
    return 0.25 * (s.skin ? 1 : 0) + 0.25 * (s.model ? 1 : 0) + (s.fit ? 0.5 * s.fit->fraction() : 0);
}

Points SkinPose::give(const Points& pose, const SkinPoseOptions& options) {
    State& s = *state_;
    if (!(options.strength >= -10 && options.strength <= 10))
        throw InvalidInput("bad-option", "The strength is " + std::to_string(options.strength) + "; it must be between -10 and 10.");
    if (pose.rows() != s.pose_size)
        throw InvalidInput("wrong-size", "The pose has " + std::to_string(pose.rows()) + " vertices, but its model has " + std::to_string(s.pose_size) + ".");
    Stopwatch watch;
    Points posed(s.source.vertex_count(), 3);
    for (Eigen::Index v = 0; v < posed.rows(); ++v) {
        const int at = s.source_vertices[static_cast<std::size_t>(v)];
        if (!pose.row(at).allFinite())
            throw InvalidInput("non-finite-position", "Vertex " + std::to_string(at) + " of the pose is not a finite point. Compute the pose again.");
        posed.row(v) = pose.row(at);
    }
    Points skin = s.from.points;
    s.skin->ride(s.source, posed, skin);

    std::vector<Matrix3d> wanted = s.maps(skin);
    for (Matrix3d& map : wanted) map = s.lay * powered(map, options) * s.lay.transpose();
    const Points means = options.strength * s.scale * (skin - s.from.points) * s.lay.transpose();
    Points moved = s.fit->fit(wanted, means);
    s.rounds = 1;
    for (; !options.keep_stretch && s.rounds <= k_stretch_rounds; ++s.rounds) {
        s.allow_stretch(moved, wanted);
        moved = s.fit->fit(wanted, means);
    }
    Points given = s.target;
    s.model->ride(s.to, moved, given);
    s.seconds.solve = watch.lap();
    return given;
}

int SkinPose::unknowns() const { return state_->to.vertex_count(); }
int SkinPose::rounds() const { return state_->rounds; }
const SkinPoseSeconds& SkinPose::seconds() const { return state_->seconds; }

} // namespace lissom
