#include "lissom/match/correspondences.h"

#include "lissom/mesh/operators.h"
#include "lissom/mesh/topology.h"

#include <algorithm>

namespace lissom {

using Eigen::Vector3d;

namespace {

/// A third of the triangles around each vertex, as a share of the mean.
Eigen::VectorXd area_shares(const TriangleMesh& mesh) {
    const Eigen::VectorXd areas = triangle_areas(mesh);
    Eigen::VectorXd shares = Eigen::VectorXd::Zero(mesh.vertex_count());
    for (int t = 0; t < mesh.triangle_count(); ++t)
        for (const int v : mesh.triangles.row(t)) shares[v] += areas[t];
    const double mean = shares.mean();
    return mean > 0 ? Eigen::VectorXd(shares / mean) : shares;
}

} // namespace

Correspondences::Correspondences(const FitSurface& surface, const SurfacePlaces& samples, bool facing)
    : surface_(surface), places_(samples.on(surface.mesh())), facing_(samples.size(), 3), has_facing_(facing) {
    Eigen::Index kept = 0;
    for (int i = 0; i < samples.size(); ++i) {
        if (surface.ignores(samples.triangle[i])) continue;
        places_.row(kept) = places_.row(i);
        facing_.row(kept++) = surface.normals().row(samples.triangle[i]);
    }
    places_.conservativeResize(kept, 3);
    reverse_hints_.assign(static_cast<std::size_t>(kept), -1);
}

std::vector<Pull> Correspondences::find(const TriangleMesh& skin, const CorrespondenceRules& rules, const std::vector<char>& left_out, const std::vector<char>& masked) {
    std::vector<Pull> pulls;
    const int n = skin.vertex_count();
    if (triangles_ != skin.triangle_count() || std::ssize(hints_) != n) {
        hints_.assign(static_cast<std::size_t>(n), -1);
        std::fill(reverse_hints_.begin(), reverse_hints_.end(), -1);
        triangles_ = skin.triangle_count();
    }
    const Points normals = vertex_normals(skin);
    const Eigen::VectorXd shares = area_shares(skin);
    const std::vector<bool> border = surface_.has_border() ? boundary_vertices(skin) : std::vector<bool>(static_cast<std::size_t>(n), false);
    double asked = 0;
    for (int v = 0; v < n; ++v) {
        if (!left_out.empty() && left_out[v]) continue;
        asked += shares[v];
        const Vector3d p = skin.points.row(v), normal = normals.row(v);
        const FitSurface::Place place = border[v] ? surface_.nearest_on_border(p, rules.reach) : surface_.nearest(p, normal, rules.least_cosine, rules.reach, hints_[v]);
        if (place.triangle < 0) continue;
        if (!border[v]) {
            hints_[v] = place.triangle;
            if (place.on_border) continue;
        }
        if (place.ignored) continue;
        const double weight = shares[v] * std::max(place.cosine, 0.0);
        if (weight > 0) pulls.push_back(Pull::of_vertex(v, place.point, weight));
    }
    if (!(rules.reverse > 0) || places_.rows() == 0) return pulls;

    const FitSurface back(skin, {true, has_facing_});
    const double weight = rules.reverse * asked / static_cast<double>(places_.rows());
    for (Eigen::Index i = 0; i < places_.rows(); ++i) {
        const FitSurface::Place place = back.nearest(places_.row(i), facing_.row(i), rules.least_cosine, rules.reach, reverse_hints_[i]);
        if (place.triangle < 0) continue;
        reverse_hints_[i] = place.triangle;
        if (place.on_border) continue;
        const auto corners = skin.triangles.row(place.triangle);
        if (!masked.empty() && masked[corners[0]] && masked[corners[1]] && masked[corners[2]]) continue;
        pulls.push_back({{corners[0], corners[1], corners[2]}, corner_weights(skin, place.triangle, place.point), places_.row(i), weight});
    }
    return pulls;
}

} // namespace lissom
