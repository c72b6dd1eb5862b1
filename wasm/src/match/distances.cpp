#include "lissom/match/distances.h"

#include "lissom/mesh/operators.h"
#include "lissom/mesh/surface_samples.h"
#include "lissom/mesh/triangle_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace lissom {

namespace {

struct OneWay {
    double mean, most;
};

OneWay one_way(const TriangleMesh& from, const TriangleMesh& to, int count) {
    const SurfacePlaces samples = sample_surface(from, count);
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    if (samples.size() == 0 || to.triangle_count() == 0) return {none, none};
    const Points places = samples.on(from);
    const TriangleTree tree(to);
    std::vector<double> distances;
    int hint = -1;
    double sum = 0;
    for (Eigen::Index i = 0; i < places.rows(); ++i) {
        const auto found = tree.nearest_where(places.row(i), std::numeric_limits<double>::infinity(), hint, [](int) { return true; });
        hint = found.triangle;
        distances.push_back(found.distance);
        sum += found.distance;
    }
    const auto last = distances.begin() + static_cast<std::ptrdiff_t>(0.99 * static_cast<double>(distances.size() - 1));
    std::nth_element(distances.begin(), last, distances.end());
    return {sum / static_cast<double>(distances.size()), *last};
}

} // namespace

TriangleMesh without_triangles(const TriangleMesh& mesh, const std::vector<char>& out) {
    TriangleMesh part{mesh.points, Triangles(std::count(out.begin(), out.end(), 0), 3)};
    for (int t = 0, row = 0; t < mesh.triangle_count(); ++t)
        if (!out[t]) part.triangles.row(row++) = mesh.triangles.row(t);
    return part;
}

SurfaceDistances surface_distances(const TriangleMesh& first, const TriangleMesh& second, int samples, const std::vector<char>& first_out, const std::vector<char>& second_out) {
    const auto measured = [&](const TriangleMesh& from, const std::vector<char>& out, const TriangleMesh& to) { return out.empty() ? one_way(from, to, samples) : one_way(without_triangles(from, out), to, samples); };
    const OneWay there = measured(first, first_out, second), back = measured(second, second_out, first);
    return {there.mean, back.mean, std::max(there.most, back.most)};
}

SurfaceSize surface_size(const TriangleMesh& mesh) {
    SurfaceSize found;
    const Eigen::VectorXd areas = triangle_areas(mesh);
    const double whole = areas.sum();
    if (!(whole > 0)) return found;
    for (int t = 0; t < mesh.triangle_count(); ++t)
        for (const int v : mesh.triangles.row(t)) found.middle += areas[t] / (3 * whole) * mesh.points.row(v);
    // ∫ over a triangle of a square is exact from the middles of its sides.
    double square = 0;
    for (int t = 0; t < mesh.triangle_count(); ++t)
        for (int k = 0; k < 3; ++k)
            square += areas[t] / (3 * whole) *
                      ((mesh.points.row(mesh.triangles(t, k)) + mesh.points.row(mesh.triangles(t, (k + 1) % 3))) / 2 - found.middle).squaredNorm();
    found.size = std::sqrt(12 * square);
    return found;
}

} // namespace lissom
