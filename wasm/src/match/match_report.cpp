#include "match_report.h"

#include "lissom/match/folds.h"
#include "lissom/mesh/self_intersections.h"

#include <algorithm>
#include <limits>

namespace lissom {

using Eigen::RowVector3d;
using Eigen::Vector3d;

namespace {

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

} // namespace

SkinReport skin_report(const TriangleMesh& skin, const PlacedModel& model) {
    // Working meshes have a unit diagonal.
    const double size = model.size.size;
    SkinReport found;
    found.distances = surface_distances(skin, model.mesh());
    for (double* value : {&found.distances.mean_there, &found.distances.mean_back, &found.distances.most}) *value *= size;
    found.folds = count_folds(skin, neighbouring_triangles(skin));
    found.crossings = static_cast<int>(self_intersections(skin).triangles.size());
    found.flipped = count_flipped(skin, model.surface);
    for (int v = 0; v < skin.vertex_count(); ++v)
        found.residuals.push_back(static_cast<float>(size * model.surface.nearest(skin.points.row(v), Vector3d::Zero(), -1, std::numeric_limits<double>::infinity()).distance));
    return found;
}

double marker_error(const SkinSet& skins, int skin, const Points& markers, const PlacedModel& model) {
    double most = 0;
    for (int v = 0; v < skins.vertex_count(); ++v)
        if (const int m = skins.marker[v]; m >= 0) most = std::max(most, model.size.size * (skins.points[static_cast<std::size_t>(skin)].row(v) - markers.row(m)).norm());
    return most;
}

} // namespace lissom
