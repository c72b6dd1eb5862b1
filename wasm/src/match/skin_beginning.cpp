#include "skin_beginning.h"

#include "lissom/match/denoise.h"
#include "lissom/match/first_skin.h"
#include "lissom/mesh/operators.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lissom {

namespace {

constexpr SettlingOptions k_onto_points{.first_stiffness = 10, .last_stiffness = 3, .projections = 0, .facing = false};

} // namespace

SkinBeginning::SkinBeginning(const PlacedModel& source, const std::vector<EdgeCurve>& curves, const Options& options) : source_(source) {
    const TriangleMesh& model = source.mesh();
    const FirstSkin kind = options.kind;
    // Even triangles of edge L: one vertex for each √3/2 L² of area.
    const double shortest = std::sqrt(triangle_areas(model).sum() / (std::sqrt(0.75) * options.most_vertices));
    const double edge_length = std::max(options.edge_length, shortest);
    if (kind != FirstSkin::copy) warn("first-full", options.edge_length < shortest);
    switch (kind) {
    case FirstSkin::automatic:
    case FirstSkin::copy:
        mesh_ = model;
        curves_ = curves;
        break;
    case FirstSkin::remesh: remesher_.emplace(model, curves, std::vector<int>{}, RemeshOptions{.edge_length = edge_length, .adapt = options.adapt}); break;
    case FirstSkin::wrap:
        if (source.is_points()) wrapped_ = as_triangles(denoised(model.points));
        wrapper_.emplace(source.is_points() ? wrapped_ : model, WrapOptions{.genus = options.genus, .edge_length = edge_length});
        break;
    case FirstSkin::box: mesh_ = box_around(model, edge_length); break;
    case FirstSkin::sphere: mesh_ = sphere_around(model, edge_length); break;
    case FirstSkin::torus: {
        TorusAround torus = torus_around(model, edge_length);
        mesh_ = std::move(torus.mesh);
        if (!torus.through) warn("torus-guessed", 1);
        break;
    }
    }
    if (kind == FirstSkin::box || kind == FirstSkin::sphere || kind == FirstSkin::torus) settle({.reach = 0.5, .facing = source.surface.has_facing()}); // they stand far off
}

void SkinBeginning::warn(const char* code, int count) {
    if (count > 0) warnings_.push_back({code, 0, count, {}});
}

void SkinBeginning::settle(SettlingOptions options) {
    if (source_.is_points()) {
        if (wrapped_.points.rows() == 0) wrapped_ = as_triangles(denoised(source_.mesh().points));
        of_points_.emplace(wrapped_, FitSurface::Rules{.borders = false, .facing = false});
        options = k_onto_points;
    }
    settling_.emplace(mesh_, of_points_ ? *of_points_ : source_.surface, options);
}

bool SkinBeginning::step() {
    if (remesher_) {
        if (remesher_->step()) return true;
        Remeshed made = remesher_->result();
        mesh_ = std::move(made.mesh);
        curves_ = std::move(made.curves);
        if (warnings_.empty()) warn("first-full", made.full);
        remesher_.reset();
        return false;
    }
    if (wrapper_) {
        if (wrapper_->step()) return true;
        const Wrapped& made = wrapper_->result();
        mesh_ = made.mesh;
        if (made.genus_missed) warnings_.push_back({"genus-missed", 0, std::max(1, made.genus), {}});
        warn("webs", made.webs);
        warn("pieces-left-out", made.left_out);
        wrapper_.reset();
        settle({.facing = source_.surface.has_facing()});
        return true;
    }
    if (!settling_) return false;
    ++settled_;
    return settling_->step(mesh_);
}

double SkinBeginning::fraction() const {
    constexpr double wrapped = 0.5;
    if (remesher_) return remesher_->fraction();
    if (wrapper_) return wrapped * wrapper_->fraction();
    if (!settling_) return 1;
    return wrapped + (1 - wrapped) * settled_ / settling_->slices();
}

} // namespace lissom
