#include "lissom/deform/measure.h"

#include "lissom/mesh/errors.h"
#include "lissom/mesh/operators.h"
#include "lissom/mesh/topology.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <string>

namespace lissom {

namespace {

/// Edges shorter than this (diagonals) are rounding: their ratio says nothing.
constexpr double k_shortest = 1e-12;

/// The working mesh as it stands after the edit.
TriangleMesh edited(const WorkingMesh& working, const Points& positions) {
    if (positions.rows() != std::ssize(working.working_of_source))
        throw InvalidInput("wrong-size", "The edit has " + std::to_string(positions.rows()) + " positions, but the model has "
                                             + std::to_string(working.working_of_source.size()) + " vertices.");
    TriangleMesh after = working.mesh;
    for (int w = 0; w < after.vertex_count(); ++w)
        after.points.row(w) = working.to_working(Eigen::Vector3d(positions.row(working.source_of_working[w])));
    return after;
}

double volume_ratio(const WorkingMesh& working, const TriangleMesh& after) {
    const double area = triangle_areas(working.mesh).sum();
    if (working.closed && working.oriented) {
        const double volume = signed_volume(working.mesh);
        if (std::abs(volume) > 1e-9 * std::pow(area, 1.5)) // a flattened shell encloses nothing to compare with
            return signed_volume(after) / volume;
    }
    return area > 0 ? std::pow(triangle_areas(after).sum() / area, 1.5) : 1;
}

void measure_edges(const WorkingMesh& working, const TriangleMesh& after, Measures& measures) {
    const int n = after.vertex_count();
    Eigen::VectorXd stretch = Eigen::VectorXd::Zero(n), degree = Eigen::VectorXd::Zero(n);
    double squares = 0, worst = 0;
    int count = 0;
    for (const Edge& e : edges(after)) {
        const double before = (working.mesh.points.row(e.a) - working.mesh.points.row(e.b)).norm();
        if (before < k_shortest)
            continue;
        const double ratio = (after.points.row(e.a) - after.points.row(e.b)).norm() / before;
        squares += (ratio - 1) * (ratio - 1);
        ++count;
        if (const double away = std::abs(std::log(ratio)); away > worst) {
            worst = away;
            measures.worst_stretch = ratio;
        }
        for (const int v : {e.a, e.b}) {
            stretch[v] += ratio - 1;
            degree[v] += 1;
        }
    }
    measures.edge_rms = count > 0 ? std::sqrt(squares / count) : 0;
    measures.vertex_stretch.assign(working.working_of_source.size(), 0);
    for (std::size_t v = 0; v < measures.vertex_stretch.size(); ++v)
        if (const int w = working.working_of_source[v]; w >= 0 && degree[w] > 0)
            measures.vertex_stretch[v] = static_cast<float>(stretch[w] / degree[w]);
}

/// First side, normal and the direction across both, as columns; false where the triangle has no area.
bool frame(const TriangleMesh& mesh, int t, Eigen::Matrix3d& axes) {
    const auto p = [&](int k) -> Eigen::Vector3d { return mesh.points.row(mesh.triangles(t, k)); };
    const Eigen::Vector3d side = p(1) - p(0), normal = side.cross(p(2) - p(0));
    const double twice_area = normal.norm();
    if (!(twice_area > 1e-12 * std::max(side.squaredNorm(), (p(2) - p(0)).squaredNorm())))
        return false;
    axes.col(0) = side.normalized();
    axes.col(1) = normal / twice_area;
    axes.col(2) = axes.col(0).cross(axes.col(1));
    return true;
}

int flipped_triangles(const TriangleMesh& before, const TriangleMesh& after) {
    const int n = before.vertex_count(), m = before.triangle_count();
    std::vector<Eigen::Matrix3d> turn(m, Eigen::Matrix3d::Zero()), around(n, Eigen::Matrix3d::Zero());
    const Eigen::VectorXd areas = triangle_areas(before);
    for (int t = 0; t < m; ++t) {
        Eigen::Matrix3d rest, now;
        if (!frame(before, t, rest) || !frame(after, t, now))
            continue;
        turn[t] = areas[t] * (now * rest.transpose());
        for (int k = 0; k < 3; ++k)
            around[before.triangles(t, k)] += turn[t];
    }
    int flipped = 0;
    for (int t = 0; t < m; ++t) {
        Eigen::Matrix3d rest, now;
        if (!frame(before, t, rest) || !frame(after, t, now))
            continue;
        // Only the direction of the mean counts, so the sum of its neighbours' turns will do.
        Eigen::Matrix3d mean = -3 * turn[t];
        for (int k = 0; k < 3; ++k)
            mean += around[before.triangles(t, k)];
        flipped += (mean * rest.col(1)).dot(now.col(1)) < 0 ? 1 : 0;
    }
    return flipped;
}

} // namespace

Measures measure(const WorkingMesh& working, const Points& positions) {
    const TriangleMesh after = edited(working, positions);
    if (!after.points.allFinite())
        throw InvalidInput("non-finite-position", "The edit has positions that are not numbers.");
    Measures measures;
    measures.volume_ratio = volume_ratio(working, after);
    measure_edges(working, after, measures);
    measures.flipped_triangles = flipped_triangles(working.mesh, after);
    return measures;
}

} // namespace lissom
