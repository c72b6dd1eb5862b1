#include "lissom/merge/seam.h"

#include "lissom/mesh/half_edges.h"
#include "lissom/mesh/topology.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

namespace lissom {
namespace {

using Eigen::Vector3d;

constexpr double k_degrees = 180 / std::numbers::pi;

double quantile(std::vector<double>& values, double share) {
    if (values.empty()) return 0;
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1) + 0.5);
    std::nth_element(values.begin(), at, values.end());
    return *at;
}

Vector3d normal_of(const TriangleMesh& mesh, int t) {
    const Vector3d a = mesh.points.row(mesh.triangles(t, 0)), b = mesh.points.row(mesh.triangles(t, 1)), c = mesh.points.row(mesh.triangles(t, 2));
    return (b - a).cross(c - a);
}

} // namespace

SeamFigures seam_figures(const JoinedMesh& joined) {
    SeamFigures figures;
    std::set<int> on_seam;
    for (const std::vector<int>& seam : joined.seams) on_seam.insert(seam.begin(), seam.end());
    figures.vertices = static_cast<int>(on_seam.size());
    std::vector<double> seam, own;
    for_each_edge(half_edges(joined.mesh), [&](auto first, auto last) {
        if (last - first != 2) return;
        const Vector3d n = normal_of(joined.mesh, first->triangle), o = normal_of(joined.mesh, (first + 1)->triangle);
        if (n.squaredNorm() == 0 || o.squaredNorm() == 0) return;
        const double dihedral = k_degrees * std::atan2(n.cross(o).norm(), n.dot(o));
        const bool across = joined.from_source[first->triangle] != joined.from_source[(first + 1)->triangle];
        (across ? seam : own).push_back(dihedral);
    });
    figures.median_dihedral = quantile(seam, 0.5);
    figures.high_dihedral = quantile(seam, 0.9);
    figures.max_dihedral = quantile(seam, 1);
    figures.own_high_dihedral = quantile(own, 0.9);
    for (int t = 0; t < joined.mesh.triangle_count(); ++t) {
        if (!joined.is_new[t]) continue;
        for (int c = 0; c < 3; ++c) {
            const Vector3d a = joined.mesh.points.row(joined.mesh.triangles(t, c));
            const Vector3d b = joined.mesh.points.row(joined.mesh.triangles(t, (c + 1) % 3)), e = joined.mesh.points.row(joined.mesh.triangles(t, (c + 2) % 3));
            figures.least_angle = std::min(figures.least_angle, k_degrees * std::atan2((b - a).cross(e - a).norm(), (b - a).dot(e - a)));
        }
    }
    return figures;
}

void smooth_seam(JoinedMesh& joined, int iterations) {
    if (iterations <= 0) return;
    const VertexRings rings = vertex_rings(joined.mesh);
    Points& points = joined.mesh.points;
    std::vector<std::pair<int, Eigen::RowVector3d>> moved;
    for (int round = 0; round < iterations; ++round) {
        moved.clear();
        for (const std::vector<int>& seam : joined.seams)
            for (const int v : seam) {
                Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
                double weights = 0;
                for (const int w : rings[v]) {
                    const double length = (points.row(w) - points.row(v)).norm();
                    if (!(length > 0)) continue;
                    sum += (points.row(w) - points.row(v)) / length;
                    weights += 1 / length;
                }
                if (weights > 0) moved.emplace_back(v, points.row(v) + 0.5 * sum / weights);
            }
        for (const auto& [v, p] : moved) points.row(v) = p;
    }
}

} // namespace lissom
