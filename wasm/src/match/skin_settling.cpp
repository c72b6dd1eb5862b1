#include "lissom/match/skin_settling.h"

#include "lissom/match/distances.h"
#include "lissom/mesh/operators.h"
#include "lissom/mesh/topology.h"

#include <algorithm>
#include <cmath>

namespace lissom {

namespace {

constexpr int k_most_samples = 12000;

SurfacePlaces samples_of(const TriangleMesh& mesh, int vertices) {
    SurfacePlaces samples = sample_surface(mesh, std::min(k_most_samples, 2 * vertices));
    if (samples.size() > 0 || mesh.triangle_count() == 0) return samples;
    // Scattered points are their own samples, evenly chosen.
    const int count = std::min(k_most_samples, mesh.triangle_count());
    samples.weights.resize(count, 3);
    for (int i = 0; i < count; ++i) {
        samples.triangle.push_back(static_cast<int>(static_cast<long long>(i) * mesh.triangle_count() / count));
        samples.weights.row(i) << 1, 0, 0;
    }
    return samples;
}

double size_of(const TriangleMesh& mesh) {
    const double size = surface_size(mesh).size;
    return size > 0 ? size : diagonal(mesh.points);
}

} // namespace

SkinSettling::SkinSettling(const TriangleMesh& skin, const FitSurface& surface, const SettlingOptions& options)
    : surface_(surface), options_(options), size_(size_of(surface.mesh())), correspondences_(surface, samples_of(surface.mesh(), skin.vertex_count()), options.facing), fit_(skin), guard_(skin) {}

bool SkinSettling::step(TriangleMesh& skin) {
    if (slice_ >= slices()) return false;
    if (slice_ < options_.steps) {
        const double at = options_.steps > 1 ? static_cast<double>(slice_) / (options_.steps - 1) : 1;
        const double stiffness = options_.first_stiffness * std::pow(options_.last_stiffness / options_.first_stiffness, at);
        const auto pulls = correspondences_.find(skin, {options_.facing ? options_.least_cosine : -1, options_.reach * size_, options_.reverse});
        if (!pulls.empty()) guard_.take(skin, fit_.solve(skin.points, pulls, {}, stiffness));
    } else project(skin);
    return ++slice_ < slices();
}

void SkinSettling::project(TriangleMesh& skin) {
    const Points normals = vertex_normals(skin);
    Points moves = Points::Zero(skin.points.rows(), 3);
    for (int v = 0; v < skin.vertex_count(); ++v) {
        const auto place = surface_.nearest(skin.points.row(v).transpose(), normals.row(v).transpose(), options_.facing ? options_.least_cosine : -1, options_.reach * size_);
        if (place.triangle >= 0 && !place.on_border) moves.row(v) = place.point.transpose() - skin.points.row(v);
    }
    guard_.take(skin, moves);
}

} // namespace lissom
