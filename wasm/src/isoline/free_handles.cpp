#include "lissom/isoline/free_handles.h"

#include "lissom/isoline/harmonic_fields.h"
#include "lissom/isoline/isolines.h"
#include "lissom/isoline/taubin.h"

#include <Eigen/Geometry>

#include <cmath>

namespace lissom {
namespace {

/// Isolines looked at a field; between them a vertex takes what the nearest one along the surface says.
constexpr int k_lines = 20;

Eigen::Vector3d normal_of(const TriangleMesh& mesh, int t) {
    const auto p = [&](int k) -> Eigen::Vector3d { return mesh.points.row(mesh.triangles(t, k)); };
    return (p(1) - p(0)).cross(p(2) - p(0)).normalized();
}

/// Flatness of the isolines of one field, per vertex.
Eigen::VectorXd flatness_of(const TriangleMesh& mesh, const VertexRings& rings, const Eigen::VectorXd& field, double least_length) {
    const auto n = static_cast<std::size_t>(mesh.vertex_count());
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(mesh.vertex_count()), count = sum;
    for (int k = 0; k < k_lines; ++k) {
        const Isoline line = isoline(mesh, field, (k + 0.5) / k_lines);
        for (const std::vector<int>& loop : line.loops) {
            Eigen::Vector3d normal = Eigen::Vector3d::Zero();
            double length = 0;
            for (const int s : loop) {
                normal += line.segments[s].length * normal_of(mesh, line.segments[s].triangle);
                length += line.segments[s].length;
            }
            const double flat = length > 0 && length >= least_length ? normal.norm() / length : 0;
            for (const int s : loop)
                for (int c = 0; c < 3; ++c) {
                    sum[mesh.triangles(line.segments[s].triangle, c)] += flat;
                    ++count[mesh.triangles(line.segments[s].triangle, c)];
                }
        }
    }
    std::vector<int> front;
    for (std::size_t v = 0; v < n; ++v)
        if (const auto row = static_cast<Eigen::Index>(v); count[row] > 0) {
            sum[row] /= count[row];
            front.push_back(static_cast<int>(v));
        }
    for (std::size_t next = 0; next < front.size(); ++next) // breadth first from the isolines
        for (const int w : rings[front[next]])
            if (count[w] == 0) {
                count[w] = 1;
                sum[w] = sum[front[next]];
                front.push_back(w);
            }
    return sum;
}

} // namespace

Eigen::VectorXd isoline_flatness(const TriangleMesh& mesh, const VertexRings& rings, const Columns& fields, double least_length) {
    const Columns weights = rigidity_fields(mesh, fields).cwiseAbs2();
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(mesh.vertex_count());
    for (Eigen::Index f = 0; f < fields.cols(); ++f) sum += flatness_of(mesh, rings, fields.col(f), least_length).cwiseProduct(weights.col(f));
    const Eigen::VectorXd all = weights.rowwise().sum();
    for (Eigen::Index v = 0; v < sum.size(); ++v) sum[v] = all[v] > 0 ? sum[v] / all[v] : 0;
    return sum;
}

std::vector<std::vector<int>> place_free_handles(const TriangleMesh& mesh, const VertexRings& rings, const Columns& fields, const std::vector<int>& handle,
                                                 const FreeHandleOptions& options) {
    const Eigen::VectorXd flatness = isoline_flatness(mesh, rings, fields, options.least_length), areas = ring_areas(mesh);
    std::vector<int> flat;
    double area = 0;
    for (int v = 0; v < mesh.vertex_count(); ++v)
        // Near a handle, or where one rules alone, isolines hardly move against each other.
        if (handle[v] < 0 && flatness[v] > options.flat && fields.row(v).maxCoeff() < 0.95) {
            flat.push_back(v);
            area += areas[v];
        }
    std::vector<std::vector<int>> placed;
    if (area < options.least_area * areas.sum()) return placed;

    // How far each flat vertex lies from the nearest handle, and then from the nearest one placed.
    std::vector<double> distance(flat.size(), INFINITY);
    const auto take = [&](const Eigen::RowVector3d& p) {
        for (std::size_t k = 0; k < flat.size(); ++k) distance[k] = std::min(distance[k], (mesh.points.row(flat[k]) - p).norm());
    };
    for (int v = 0; v < mesh.vertex_count(); ++v)
        if (handle[v] >= 0 && std::any_of(rings[v].begin(), rings[v].end(), [&](int w) { return handle[w] < 0; })) take(mesh.points.row(v));
    std::vector<char> used(static_cast<std::size_t>(mesh.vertex_count()), 0);
    while (static_cast<int>(placed.size()) < options.most) {
        const auto far = static_cast<std::size_t>(std::max_element(distance.begin(), distance.end()) - distance.begin());
        if (distance[far] < 2.5 * options.radius) break; // two discs and a ring between them no longer fit
        const int v = flat[far];
        placed.push_back(disc_around(mesh, rings, mesh.points.row(v), {v}, options.radius, [&](int w) { return handle[w] < 0 && !used[w]; }));
        for (const int w : placed.back()) used[w] = 1;
        take(mesh.points.row(v));
    }
    return placed;
}

} // namespace lissom
