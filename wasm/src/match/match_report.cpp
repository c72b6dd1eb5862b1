#include "match_report.h"

#include "lissom/match/folds.h"
#include "lissom/mesh/self_intersections.h"
#include "lissom/mesh/surface_samples.h"
#include "lissom/mesh/triangle_tree.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace lissom {

using Eigen::RowVector3d;
using Eigen::Vector3d;

namespace {

constexpr double k_anywhere = std::numeric_limits<double>::infinity();
constexpr int k_samples = 20000, k_residual_samples = 10000;

int count_flipped(const TriangleMesh& skin, const FitSurface& surface) {
    int count = 0;
    const Points normals = triangle_normals(skin);
    for (int t = 0; t < skin.triangle_count(); ++t) {
        Vector3d middle = Vector3d::Zero();
        double longest = 0;
        for (int k = 0; k < 3; ++k) {
            const RowVector3d p = skin.points.row(skin.triangles(t, k));
            middle += p.transpose() / 3;
            longest = std::max(longest, (skin.points.row(skin.triangles(t, (k + 1) % 3)) - p).norm());
        }
        count += surface.nearest(middle, normals.row(t), 0, longest).triangle < 0;
    }
    return count;
}

/// Up to five vertices of large residual, none nearer to another than a tenth of the size.
std::vector<int> worst_places(const TriangleMesh& skin, const std::vector<float>& residuals) {
    constexpr std::size_t most = 5;
    constexpr double apart = 0.1;
    std::vector<int> order(residuals.size()), found;
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return residuals[a] > residuals[b]; });
    for (const int v : order) {
        if (found.size() == most || !(residuals[v] > 0)) break;
        if (std::all_of(found.begin(), found.end(), [&](int w) { return (skin.points.row(v) - skin.points.row(w)).norm() > apart; })) found.push_back(v);
    }
    return found;
}

} // namespace

SkinReport skin_report(const TriangleMesh& skin, const PlacedModel& model, const std::vector<char>& masked, bool whole) {
    // Working meshes have a unit diagonal.
    const double size = model.size.size;
    const bool parts = !masked.empty() || (!whole && model.surface.ignores_some());
    SkinReport found;
    std::vector<char> out_vertex(static_cast<std::size_t>(skin.vertex_count()), 0), out_here, out_there;
    for (int v = 0; v < skin.vertex_count(); ++v) {
        const auto place = model.surface.nearest(skin.points.row(v), Vector3d::Zero(), -1, k_anywhere);
        out_vertex[v] = (!masked.empty() && masked[v]) || (!whole && place.ignored);
        found.residuals.push_back(out_vertex[v] ? 0 : static_cast<float>(size * place.distance));
    }
    if (parts) {
        for (int t = 0; t < skin.triangle_count(); ++t) out_here.push_back(out_vertex[skin.triangles(t, 0)] || out_vertex[skin.triangles(t, 1)] || out_vertex[skin.triangles(t, 2)]);
        for (int t = 0; t < model.mesh().triangle_count(); ++t) out_there.push_back(!whole && model.surface.ignores(t));
    }
    found.distances = surface_distances(skin, model.mesh(), k_samples, out_here, out_there);
    for (double* value : {&found.distances.mean_there, &found.distances.mean_back, &found.distances.most}) *value *= size;
    found.folds = count_folds(skin, neighbouring_triangles(skin));
    found.crossings = static_cast<int>(self_intersections(skin).triangles.size());
    found.flipped = count_flipped(parts ? without_triangles(skin, out_here) : skin, model.surface);

    // Back: what of the model the skin leaves out is missed by the vertex nearest to it.
    const SurfacePlaces samples = sample_surface(model.mesh(), k_residual_samples);
    const Points places = samples.on(model.mesh());
    const TriangleTree tree(skin);
    int hint = -1;
    for (int i = 0; i < samples.size(); ++i) {
        if (!whole && model.surface.ignores(samples.triangle[i])) continue;
        const auto at = tree.nearest_where(places.row(i), k_anywhere, hint, [](int) { return true; });
        hint = at.triangle;
        if (hint < 0) break;
        int corner = 0;
        corner_weights(skin, at.triangle, at.point).maxCoeff(&corner);
        const int v = skin.triangles(at.triangle, corner);
        if (!out_vertex[v]) found.residuals[v] = std::max(found.residuals[v], static_cast<float>(size * at.distance));
    }
    found.worst = worst_places(skin, found.residuals);
    return found;
}

double marker_error(const SkinSet& skins, int skin, const Points& markers, const PlacedModel& model) {
    double most = 0;
    for (int v = 0; v < skins.vertex_count(); ++v)
        if (const int m = skins.marker[v]; m >= 0) most = std::max(most, model.size.size * (skins.points[static_cast<std::size_t>(skin)].row(v) - markers.row(m)).norm());
    return most;
}

} // namespace lissom
