#include "lissom/match/fit_surface.h"

#include "lissom/mesh/half_edges.h"
#include "lissom/mesh/operators.h"

#include <algorithm>
#include <utility>

namespace lissom {

using Eigen::RowVector3d;
using Eigen::Vector3d;

Points triangle_normals(const TriangleMesh& mesh) {
    Points normals(mesh.triangle_count(), 3);
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        const Vector3d a = mesh.points.row(mesh.triangles(t, 0)), b = mesh.points.row(mesh.triangles(t, 1)), c = mesh.points.row(mesh.triangles(t, 2));
        normals.row(t) = (b - a).cross(c - a).stableNormalized().transpose();
    }
    return normals;
}

namespace {

/// Sides of edges of one triangle.
std::vector<HalfEdge> rim(const TriangleMesh& mesh) {
    std::vector<HalfEdge> sides;
    for_each_edge(half_edges(mesh), [&](auto first, auto last) {
        if (last - first == 1) sides.push_back(*first);
    });
    return sides;
}

TriangleMesh as_triangles(const Points& points, const std::vector<HalfEdge>& sides) {
    TriangleMesh edges{Points(0, 3), Triangles(std::ssize(sides), 3)};
    if (!sides.empty()) edges.points = points;
    for (std::size_t k = 0; k < sides.size(); ++k) edges.triangles.row(static_cast<Eigen::Index>(k)) << sides[k].a, sides[k].b, sides[k].b;
    return edges;
}

} // namespace

FitSurface::FitSurface(TriangleMesh mesh) : FitSurface(std::move(mesh), Rules{}) {}

FitSurface::FitSurface(TriangleMesh mesh, const Rules& rules) : FitSurface(std::move(mesh), rules, {}) {}

FitSurface::FitSurface(TriangleMesh mesh, const Rules& rules, std::vector<HalfEdge> sides)
    : mesh_(std::move(mesh)), rules_(rules), normals_(triangle_normals(mesh_)), vertex_normals_(vertex_normals(mesh_)),
      border_(as_triangles(mesh_.points, sides = rules.borders ? rim(mesh_) : std::vector<HalfEdge>{})), tree_(mesh_), border_tree_(border_) {
    if (sides.empty()) return;
    border_edge_.assign(static_cast<std::size_t>(3 * mesh_.triangle_count()), 0);
    border_vertex_.assign(static_cast<std::size_t>(mesh_.vertex_count()), 0);
    for (const HalfEdge& side : sides) {
        border_edge_[3 * side.triangle + (side.corner + 2) % 3] = 1;
        border_vertex_[side.a] = border_vertex_[side.b] = 1;
    }
}

FitSurface::Place FitSurface::nearest(const Vector3d& p, const Vector3d& normal, double least_cosine, double reach, int hint) const {
    const bool facing = rules_.facing && least_cosine > -1;
    const auto found = tree_.nearest_where(p, reach, hint, [&](int t) { return !facing || normals_.row(t).dot(normal) > least_cosine; });
    Place place{found.triangle, found.point, found.distance};
    if (found.triangle < 0) return place;
    place.ignored = ignores(found.triangle);
    if (rules_.facing) {
        const Vector3d weights = corner_weights(mesh_, found.triangle, found.point);
        RowVector3d blend = RowVector3d::Zero();
        for (int k = 0; k < 3; ++k) blend += weights[k] * vertex_normals_.row(mesh_.triangles(found.triangle, k));
        place.cosine = blend.stableNormalized().dot(normal);
    }
    if (has_border()) {
        if (found.feature < 3) place.on_border = border_vertex_[mesh_.triangles(found.triangle, found.feature)] != 0;
        else if (found.feature < 6) place.on_border = border_edge_[3 * found.triangle + found.feature - 3] != 0;
    }
    return place;
}

FitSurface::Place FitSurface::nearest_on_border(const Vector3d& p, double reach) const {
    const auto found = border_tree_.nearest_where(p, reach, -1, [](int) { return true; });
    Place place{found.triangle, found.point, found.distance, 1, true};
    if (found.triangle >= 0 && !ignored_.empty()) place.ignored = ignored_[border_.triangles(found.triangle, 0)] && ignored_[border_.triangles(found.triangle, 1)];
    return place;
}

void FitSurface::ignore(std::vector<char> vertices) {
    ignored_ = std::move(vertices);
}

bool FitSurface::ignores(int triangle) const {
    if (ignored_.empty()) return false;
    const auto corners = mesh_.triangles.row(triangle);
    return ignored_[corners[0]] && ignored_[corners[1]] && ignored_[corners[2]];
}

} // namespace lissom
