#include "lissom/wear/body_map.h"

#include "lissom/mesh/corner_weights.h"
#include "lissom/mesh/errors.h"
#include "lissom/mesh/operators.h"
#include "lissom/mesh/polar.h"
#include "lissom/mesh/surface_samples.h"
#include "lissom/wear/surface_turns.h"

#include "skin_checks.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace lissom {

using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

/// σ in shares of √area: 2 cm of a person.
constexpr double k_near = 0.0155;
constexpr int k_places = 1200;
/// People whose sizes differ by less than this wear the same ease; dolls and giants theirs in proportion.
constexpr double k_alike = 1.25;

} // namespace

struct BodyMap::State {
    Similarity similarity;
    TriangleMesh from, to; ///< the first as the similarity lays it on the second
    double size = 1;
    double ease = 1; ///< of what leads away from the skin, by which the similarity's scale is taken back
    std::optional<TriangleTree> tree;
    std::vector<Matrix3d> turns;
    Points normals;
    std::optional<BiharmonicMap> far;
};

BodyMap::BodyMap(const Triangles& triangles, const Points& from, const Points& to) : state_(std::make_unique<State>()) {
    check_skins(triangles, from, to);
    State& s = *state_;
    s.to = {to, triangles};
    s.from = {from, triangles};
    // By places that stand for the same area each, so that it does not depend on the triangles.
    const SurfacePlaces places = sample_surface(s.to, k_places);
    if (places.size() == 0 || !(triangle_areas(s.from).sum() > 0)) throw InvalidInput("flat-skin", "A skin has no area. Match the models again.");
    s.similarity = fit_similarity(places.on(s.from), places.on(s.to));
    const Eigen::Affine3d lay = s.similarity.affine();
    for (int v = 0; v < s.from.vertex_count(); ++v) s.from.points.row(v) = (lay * s.from.points.row(v).transpose()).transpose();
    s.ease = 1 / std::clamp(s.similarity.scale, 1 / k_alike, k_alike);
    s.size = std::sqrt(triangle_areas(s.to).sum());
}

BodyMap::~BodyMap() = default;
BodyMap::BodyMap(BodyMap&&) noexcept = default;

bool BodyMap::step() {
    State& s = *state_;
    if (!s.tree) {
        s.tree.emplace(s.from);
        s.turns = surface_turns(s.from, s.to.points);
        s.normals = vertex_normals(s.to);
        return true;
    }
    if (s.far) return false;
    const SurfacePlaces places = sample_surface(s.from, k_places);
    try {
        s.far.emplace(places.on(s.from), places.on(s.to));
    } catch (const SolverFailure&) {
        throw InvalidInput("flat-skin", "A skin lies in one plane: it has no outside to wear things on. Match models with volume.");
    }
    return false;
}

BodyMap::Carried BodyMap::carry(const Vector3d& given) const {
    const State& s = *state_;
    const Vector3d place = s.similarity.affine() * given;
    const TriangleTree::Nearest at = s.tree->nearest(place);
    Carried carried;
    carried.triangle = at.triangle;
    carried.weights = corner_weights(s.from, at.triangle, at.point);
    Vector3d there = Vector3d::Zero(), normal = Vector3d::Zero();
    Matrix3d turn = Matrix3d::Zero();
    for (int k = 0; k < 3; ++k) {
        const int v = s.to.triangles(at.triangle, k);
        there += carried.weights[k] * s.to.points.row(v).transpose();
        normal += carried.weights[k] * s.normals.row(v).transpose();
        turn += carried.weights[k] * s.turns[v];
    }
    const Vector3d off = s.ease * (nearest_rotation(turn) * (place - at.point));
    const double sigma = k_near * s.size, near = std::exp(-std::pow(at.distance / sigma, 2));
    carried.place = there + off;
    if (near < 1 - 1e-12) carried.place += (1 - near) * ((*s.far)(place) - carried.place);
    carried.away = (off + sigma * normal).stableNormalized();
    return carried;
}

const Similarity& BodyMap::similarity() const { return state_->similarity; }
const TriangleMesh& BodyMap::to() const { return state_->to; }
double BodyMap::size() const { return state_->size; }

} // namespace lissom
