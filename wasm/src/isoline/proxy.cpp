#include "lissom/isoline/proxy.h"

#include "lissom/mesh/nearest_on_triangle.h"

#include <meshoptimizer/meshoptimizer.h>

#include <Eigen/Geometry>

#include <cmath>
#include <limits>
#include <utility>

namespace lissom {
namespace {

/// The triangles given over those vertices alone that they use.
Proxy compact(const Proxy& from, const std::vector<unsigned>& corners) {
    std::vector<int> place(static_cast<std::size_t>(from.mesh.vertex_count()), -1);
    for (const unsigned v : corners) place[v] = 0;
    Proxy kept;
    for (std::size_t v = 0; v < place.size(); ++v)
        if (place[v] == 0) {
            place[v] = static_cast<int>(kept.fine.size());
            kept.fine.push_back(from.fine[v]);
        }
    kept.mesh.points.resize(static_cast<Eigen::Index>(kept.fine.size()), 3);
    for (std::size_t v = 0; v < place.size(); ++v)
        if (place[v] >= 0) kept.mesh.points.row(place[v]) = from.mesh.points.row(static_cast<Eigen::Index>(v));
    kept.mesh.triangles.resize(static_cast<Eigen::Index>(corners.size() / 3), 3);
    for (std::size_t c = 0; c < corners.size(); ++c)
        kept.mesh.triangles(static_cast<Eigen::Index>(c / 3), static_cast<Eigen::Index>(c % 3)) = place[corners[c]];
    return kept;
}

std::vector<unsigned> corners_of(const TriangleMesh& mesh) {
    return {mesh.triangles.data(), mesh.triangles.data() + mesh.triangles.size()};
}

} // namespace

Proxy whole(const TriangleMesh& mesh) {
    Proxy all{mesh, std::vector<int>(static_cast<std::size_t>(mesh.vertex_count()))};
    for (std::size_t v = 0; v < all.fine.size(); ++v) all.fine[v] = static_cast<int>(v);
    return compact(all, corners_of(mesh));
}

Proxy simplified(const Proxy& from, int triangles) {
    if (from.mesh.triangle_count() <= triangles) return from;
    const std::vector<unsigned> corners = corners_of(from.mesh);
    const Eigen::Matrix<float, Eigen::Dynamic, 3, Eigen::RowMajor> points = from.mesh.points.cast<float>();
    std::vector<unsigned> kept(corners.size());
    const float any_error = std::numeric_limits<float>::max();
    kept.resize(meshopt_simplify(kept.data(), corners.data(), corners.size(), points.data(), static_cast<std::size_t>(points.rows()), 3 * sizeof(float),
                                 3 * static_cast<std::size_t>(triangles), any_error, meshopt_SimplifyRegularize, nullptr));
    return compact(from, kept);
}

SurfaceBinder::SurfaceBinder(const Points& fine, const VertexRings& rings, const Proxy& proxy) : fine_(fine), rings_(rings), proxy_(proxy) {
    const int n = proxy.mesh.vertex_count();
    around_offsets_.assign(static_cast<std::size_t>(n) + 1, 0);
    for (int t = 0; t < proxy.mesh.triangle_count(); ++t)
        for (int k = 0; k < 3; ++k) ++around_offsets_[proxy.mesh.triangles(t, k) + 1];
    for (int v = 0; v < n; ++v) around_offsets_[v + 1] += around_offsets_[v];
    around_.resize(static_cast<std::size_t>(around_offsets_[n]));
    std::vector<int> place(around_offsets_.begin(), around_offsets_.end() - 1);
    for (int t = 0; t < proxy.mesh.triangle_count(); ++t)
        for (int k = 0; k < 3; ++k) around_[place[proxy.mesh.triangles(t, k)]++] = t;

    binding_.triangle.assign(static_cast<std::size_t>(fine.rows()), -1);
    binding_.weights.setZero(fine.rows(), 2);
    queued_.assign(binding_.triangle.size(), 0);
    queue_.reserve(binding_.triangle.size());
    for (int p = 0; p < n; ++p) {
        const int v = proxy.fine[p], t = around_[around_offsets_[p]];
        binding_.triangle[v] = t;
        for (int k = 1; k < 3; ++k) binding_.weights(v, k - 1) = proxy.mesh.triangles(t, k) == p ? 1.0F : 0.0F;
        queued_[v] = 1;
        queue_.push_back(v);
    }
}

SurfaceBinder::Place SurfaceBinder::nearest_on(int triangle, const Eigen::Vector3d& p) const {
    std::array<Eigen::Vector3d, 3> c;
    for (int k = 0; k < 3; ++k) c[k] = proxy_.mesh.points.row(proxy_.mesh.triangles(triangle, k));
    const NearestOnTriangle found = nearest_on_triangle(p, c[0], c[1], c[2]);
    const Eigen::Vector3d normal = (c[1] - c[0]).cross(c[2] - c[0]);
    const double squared = normal.squaredNorm();
    Eigen::Vector2f weights = Eigen::Vector2f::Zero();
    if (squared > 0) {
        weights[0] = static_cast<float>((found.point - c[0]).cross(c[2] - c[0]).dot(normal) / squared);
        weights[1] = static_cast<float>((c[1] - c[0]).cross(found.point - c[0]).dot(normal) / squared);
    }
    return {triangle, (found.point - p).squaredNorm(), weights};
}

void SurfaceBinder::bind(int v) {
    const Eigen::Vector3d p = fine_.row(v);
    Place best{-1, INFINITY, Eigen::Vector2f::Zero()};
    for (const int w : rings_[v]) // starts: where bound neighbours lie
        if (const int t = binding_.triangle[w]; t >= 0 && t != best.triangle)
            if (const Place place = nearest_on(t, p); place.distance < best.distance) best = place;
    for (bool closer = best.triangle >= 0; closer;) {
        closer = false;
        const int from = best.triangle;
        for (int k = 0; k < 3; ++k) {
            const int corner = proxy_.mesh.triangles(from, k);
            for (int a = around_offsets_[corner]; a < around_offsets_[corner + 1]; ++a)
                if (around_[a] != from)
                    if (const Place place = nearest_on(around_[a], p); place.distance < best.distance) {
                        best = place;
                        closer = true;
                    }
        }
    }
    binding_.triangle[v] = best.triangle;
    binding_.weights.row(v) = best.weights.transpose();
}

bool SurfaceBinder::step(int vertices) {
    for (int k = 0; k < vertices && next_ < queue_.size(); ++k, ++next_) {
        const int v = queue_[next_];
        if (binding_.triangle[v] < 0) bind(v);
        for (const int w : rings_[v])
            if (!queued_[w]) {
                queued_[w] = 1;
                queue_.push_back(w);
            }
    }
    return next_ < queue_.size();
}

double SurfaceBinder::fraction() const { return fine_.rows() > 0 ? static_cast<double>(next_) / static_cast<double>(fine_.rows()) : 1; }

} // namespace lissom
