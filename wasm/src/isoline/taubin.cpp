#include "lissom/isoline/taubin.h"

#include "lissom/mesh/operators.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace lissom {
namespace {

/// λ and μ of Taubin 1995; the pass band they leave is 1/λ + 1/μ = 0.11 of the umbrella's spectrum.
constexpr double k_forth = 0.5, k_back = -0.53;

/// Cotangents at most this large: those of flatter corners carry no shape.
constexpr double k_flattest = 1e4;

void towards_ring(Points& points, const VertexRings& rings, const std::vector<bool>& kept, double share) {
    const Points before = points;
    for (int v = 0; v < rings.vertex_count(); ++v) {
        const auto ring = rings[v];
        if (ring.empty() || (!kept.empty() && kept[static_cast<std::size_t>(v)])) continue;
        Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
        for (const int w : ring) sum += before.row(w);
        points.row(v) += share * (sum / static_cast<double>(ring.size()) - before.row(v));
    }
}

} // namespace

void taubin_step(Points& points, const VertexRings& rings, const std::vector<bool>& kept) {
    towards_ring(points, rings, kept, k_forth);
    towards_ring(points, rings, kept, k_back);
}

Eigen::VectorXd ring_areas(const TriangleMesh& mesh) {
    const Eigen::VectorXd triangles = triangle_areas(mesh);
    Eigen::VectorXd areas = Eigen::VectorXd::Zero(mesh.vertex_count());
    for (int t = 0; t < mesh.triangle_count(); ++t)
        for (int k = 0; k < 3; ++k) areas[mesh.triangles(t, k)] += triangles[t] / 3;
    return areas.size() == 0 ? areas : areas.cwiseMax(1e-6 * areas.mean()).eval();
}

double bending_energy(const TriangleMesh& mesh, const std::vector<bool>& left_out) {
    Points delta = Points::Zero(mesh.vertex_count(), 3); // L x, a triangle at a time: no matrix is needed for that
    for (int t = 0; t < mesh.triangle_count(); ++t)
        for (int k = 0; k < 3; ++k) {
            const int at = mesh.triangles(t, k), i = mesh.triangles(t, (k + 1) % 3), j = mesh.triangles(t, (k + 2) % 3);
            const Eigen::Vector3d u = mesh.points.row(i) - mesh.points.row(at), w = mesh.points.row(j) - mesh.points.row(at);
            const double area = u.cross(w).norm();
            const double cotangent = area > 0 ? std::clamp(u.dot(w) / area, -k_flattest, k_flattest) : 0;
            const Eigen::RowVector3d along = 0.5 * cotangent * (mesh.points.row(j) - mesh.points.row(i));
            delta.row(i) += along;
            delta.row(j) -= along;
        }
    const Eigen::VectorXd areas = ring_areas(mesh);
    double energy = 0;
    for (int v = 0; v < mesh.vertex_count(); ++v)
        if (left_out.empty() || !left_out[static_cast<std::size_t>(v)]) energy += delta.row(v).squaredNorm() / areas[v];
    return energy;
}

} // namespace lissom
