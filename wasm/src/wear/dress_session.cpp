#include "lissom/wear/dress_session.h"

#include "lissom/mesh/errors.h"
#include "lissom/mesh/operators.h"
#include "lissom/mesh/stopwatch.h"
#include "lissom/solve/sparse_cholesky.h"
#include "lissom/wear/body_map.h"

#include <cmath>
#include <optional>

namespace lissom {

using Eigen::RowVector3d;
using Eigen::Vector3d;

namespace {

/// Over how far what moves the garment is smoothed, in shares of √area. Measured on eighteen garments: docs/wear.md.
constexpr double k_smooth = 0.008;
/// How far outside pushed vertices end: 2 mm of a person.
constexpr double k_margin = 0.00155;

} // namespace

struct DressSession::State {
    const WorkingMesh& garment;
    BodyMap map;
    std::optional<TriangleMesh> model; ///< until its body is made
    int done = 0;                      ///< slices
    TriangleMesh laid;                 ///< the garment as the similarity lays it on the second body
    Points moves, away;                ///< per working vertex: what carries it there, and the way out
    Eigen::VectorXd areas;
    std::optional<SparseCholesky> smoothing;
    std::optional<Body> skin_body, model_body;
    bool with_model = false;
    DressSeconds seconds;
};

DressSession::DressSession(const WorkingMesh& garment, const Triangles& triangles, const Points& from, const Points& to, const WorkingMesh* model)
    : state_(new State{.garment = garment, .map = BodyMap(triangles, from, to), .model = {}, .laid = garment.mesh, .moves = {}, .away = {}, .areas = {},
                       .smoothing = {}, .skin_body = {}, .model_body = {}, .seconds = {}}) {
    if (!model) return;
    state_->with_model = true;
    state_->model = model->mesh;
    for (int v = 0; v < model->mesh.vertex_count(); ++v) state_->model->points.row(v) = model->to_source(model->mesh.points.row(v)).transpose();
}

DressSession::~DressSession() = default;
DressSession::DressSession(DressSession&&) noexcept = default;

bool DressSession::step() {
    State& s = *state_;
    Stopwatch watch;
    switch (s.done) {
    case 0:
        if (s.map.step()) return s.seconds.prepare += watch.lap(), true;
        break;
    case 1: {
        const Eigen::Affine3d lay = s.map.similarity().affine();
        const int n = s.laid.vertex_count();
        s.moves.resize(n, 3), s.away.resize(n, 3);
        for (int v = 0; v < n; ++v) {
            const Vector3d place = s.garment.to_source(s.garment.mesh.points.row(v)), at = lay * place;
            const BodyMap::Carried carried = s.map.carry(place);
            s.laid.points.row(v) = at.transpose();
            s.moves.row(v) = (carried.place - at).transpose();
            s.away.row(v) = carried.away.transpose();
        }
        break;
    }
    case 2: {
        // (M + ℓ² K) d̄ = M d: implicit smoothing over ℓ, in areas instead of rings so that the garment's triangles do not matter.
        s.areas = vertex_areas(s.laid);
        SparseMatrix A = -std::pow(k_smooth * s.map.size(), 2) * cotangent_laplacian(s.laid);
        A.diagonal() += s.areas;
        s.smoothing.emplace(A, &s.laid.points);
        s.smoothing->factorize(A);
        break;
    }
    case 3:
        s.skin_body.emplace(s.map.to(), s.map.size());
        break;
    default:
        if (s.model) s.model_body.emplace(*s.model, s.map.size());
        s.model.reset();
        s.seconds.prepare += watch.lap();
        return false;
    }
    s.seconds.prepare += watch.lap();
    ++s.done;
    return true;
}

double DressSession::fraction() const { return state_->done / 5.0; }

Dressed DressSession::dress(double ease) {
    if (!std::isfinite(ease)) throw InvalidInput("bad-option", "The ease is not a number.");
    State& s = *state_;
    Stopwatch watch;
    Columns moves = s.areas.asDiagonal() * (s.moves + ease * s.away);
    s.smoothing->solve(moves);
    TriangleMesh worn = s.laid;
    worn.points += moves;

    Dressed dressed;
    std::vector<const Body*> bodies;
    if (s.skin_body->has_inside()) bodies.push_back(&*s.skin_body);
    if (s.model_body && s.model_body->has_inside()) bodies.push_back(&*s.model_body);
    const PushedOut pushed = push_out(worn, bodies, k_margin * s.map.size());
    dressed.before = pushed.before, dressed.after = pushed.after, dressed.rounds = pushed.rounds;
    const auto warn = [&](const char* code, int count) { dressed.warnings.push_back({.code = code, .count = count, .examples = {}, .repaired = true}); };
    if (!s.skin_body->has_inside()) warn("body-without-inside", 1);
    if (s.with_model && !s.model_body->has_inside()) warn("model-without-inside", 1);
    if (!pushed.after.none()) warn("inside-left", pushed.after.vertices + pushed.after.face_centres);

    dressed.positions = s.garment.source;
    for (std::size_t v = 0; v < s.garment.working_of_source.size(); ++v) {
        const auto row = static_cast<Eigen::Index>(v);
        const int w = s.garment.working_of_source[v];
        if (w >= 0)
            dressed.positions.row(row) = worn.points.row(w);
        else if (s.garment.source.row(row).allFinite()) // in no triangle, but it goes along
            dressed.positions.row(row) = s.map.carry(s.garment.source.row(row)).place.transpose();
    }
    s.seconds.dress = watch.lap();
    return dressed;
}

const DressSeconds& DressSession::seconds() const { return state_->seconds; }

} // namespace lissom
