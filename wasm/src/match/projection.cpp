#include "projection.h"

#include "lissom/mesh/operators.h"
#include "lissom/mesh/topology.h"

namespace lissom {

using Eigen::Vector3d;

Points projected(const FitSurface& surface, const TriangleMesh& skin, double least_cosine, const std::vector<char>& kept, bool everywhere) {
    Points places = skin.points;
    const Points normals = vertex_normals(skin);
    const std::vector<bool> border = surface.has_border() ? boundary_vertices(skin) : std::vector<bool>(places.rows(), false);
    for (int v = 0; v < skin.vertex_count(); ++v) {
        if (kept[v]) continue;
        const Vector3d p = skin.points.row(v);
        const auto place = border[v] ? surface.nearest_on_border(p, k_projection_reach) : surface.nearest(p, normals.row(v), least_cosine, k_projection_reach);
        if (place.triangle >= 0 && (border[v] || !place.on_border) && (everywhere || !place.ignored)) places.row(v) = place.point.transpose();
    }
    return places;
}

} // namespace lissom
