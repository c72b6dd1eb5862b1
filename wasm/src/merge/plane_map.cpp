#include "lissom/merge/plane_map.h"

#include "lissom/mesh/topology.h"
#include "lissom/solve/sparse_cholesky.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace lissom {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double k_inside = -1e-9; // barycentric weights down to this count as inside: shared edges have no gaps

double cross(const Vector2d& a, const Vector2d& b) {
    return a.x() * b.y() - a.y() * b.x();
}

} // namespace

PlaneLocator::PlaneLocator(const PlanePoints& points, const Triangles& triangles) : points_(points), triangles_(triangles) {
    low_ = points.rows() > 0 ? Vector2d(points.colwise().minCoeff().transpose()) : Vector2d::Zero();
    const Vector2d high = points.rows() > 0 ? Vector2d(points.colwise().maxCoeff().transpose()) : Vector2d::Zero();
    const Vector2d extent = high - low_;
    size_ = std::max(std::sqrt(std::max(extent.x() * extent.y(), 1e-300) / std::max<double>(1, static_cast<double>(triangles.rows()))), 1e-9 * extent.norm());
    if (!(size_ > 0)) size_ = 1;
    for (int axis = 0; axis < 2; ++axis) count_[axis] = std::clamp(static_cast<int>(extent[axis] / size_) + 1, 1, 4096);
    offsets_.assign(static_cast<std::size_t>(count_[0] * count_[1]) + 1, 0);
    for (const bool counting : {true, false}) {
        std::vector<int> next(offsets_.begin(), offsets_.end() - 1);
        for (int t = 0; t < triangles.rows(); ++t) {
            Vector2d from = points.row(triangles(t, 0)).transpose(), to = from;
            for (int c = 1; c < 3; ++c) {
                from = from.cwiseMin(points.row(triangles(t, c)).transpose());
                to = to.cwiseMax(points.row(triangles(t, c)).transpose());
            }
            for (int y = cell(from.y(), 1); y <= cell(to.y(), 1); ++y)
                for (int x = cell(from.x(), 0); x <= cell(to.x(), 0); ++x)
                    if (counting) ++offsets_[y * count_[0] + x + 1];
                    else entries_[next[y * count_[0] + x]++] = t;
        }
        if (counting) {
            for (std::size_t k = 1; k < offsets_.size(); ++k) offsets_[k] += offsets_[k - 1];
            entries_.resize(static_cast<std::size_t>(offsets_.back()));
        }
    }
}

int PlaneLocator::cell(double value, int axis) const {
    return std::clamp(static_cast<int>(std::floor((value - low_[axis]) / size_)), 0, count_[axis] - 1);
}

PlanePlace PlaneLocator::in_triangle(int t, const Vector2d& point) const {
    const Vector2d a = points_.row(triangles_(t, 0)).transpose(), b = points_.row(triangles_(t, 1)).transpose(), c = points_.row(triangles_(t, 2)).transpose();
    const double area = cross(b - a, c - a);
    if (area == 0) return {};
    PlanePlace place{t, {cross(b - point, c - point) / area, cross(c - point, a - point) / area, 0}};
    place.weight[2] = 1 - place.weight[0] - place.weight[1];
    return place;
}

PlanePlace PlaneLocator::locate(const Vector2d& point, bool nearest) const {
    const int x = cell(point.x(), 0), y = cell(point.y(), 1);
    for (int e = offsets_[y * count_[0] + x]; e < offsets_[y * count_[0] + x + 1]; ++e) {
        const PlanePlace place = in_triangle(entries_[e], point);
        if (place.triangle >= 0 && *std::min_element(place.weight.begin(), place.weight.end()) >= k_inside) return place;
    }
    if (!nearest) return {};
    PlanePlace best;
    double least = std::numeric_limits<double>::infinity();
    for (int t = 0; t < triangles_.rows(); ++t)
        for (int c = 0; c < 3; ++c) {
            const Vector2d a = points_.row(triangles_(t, c)).transpose(), b = points_.row(triangles_(t, (c + 1) % 3)).transpose();
            const double f = (b - a).squaredNorm() > 0 ? std::clamp((point - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0) : 0;
            const double distance = (a + f * (b - a) - point).norm();
            if (distance >= least) continue;
            least = distance;
            best.triangle = t;
            best.weight = {};
            best.weight[c] = 1 - f;
            best.weight[(c + 1) % 3] = f;
        }
    return best;
}

PlanePoints tutte_map(const TriangleMesh& mesh, std::span<const int> fixed, const PlanePoints& where) {
    const int n = mesh.vertex_count();
    PlanePoints map = PlanePoints::Zero(n, 2);
    std::vector<int> unknown(static_cast<std::size_t>(n), 0);
    for (std::size_t k = 0; k < fixed.size(); ++k) {
        unknown[fixed[k]] = -1;
        map.row(fixed[k]) = where.row(static_cast<Eigen::Index>(k));
    }
    const VertexRings rings = vertex_rings(mesh);
    int count = 0;
    for (int v = 0; v < n; ++v)
        if (unknown[v] == 0) unknown[v] = rings[v].empty() ? -1 : count++;
    if (count == 0) return map;
    std::vector<Eigen::Triplet<double>> entries;
    Columns rhs = Columns::Zero(count, 2);
    Points coordinates(count, 3);
    for (int v = 0; v < n; ++v) {
        if (unknown[v] < 0) continue;
        coordinates.row(unknown[v]) = mesh.points.row(v);
        entries.emplace_back(unknown[v], unknown[v], static_cast<double>(rings[v].size()));
        for (const int w : rings[v])
            if (unknown[w] < 0) rhs.row(unknown[v]) += map.row(w);
            else if (unknown[w] < unknown[v]) entries.emplace_back(unknown[v], unknown[w], -1.0);
    }
    SparseMatrix A(count, count);
    A.setFromTriplets(entries.begin(), entries.end());
    SparseCholesky factor(A, &coordinates);
    factor.factorize(A);
    factor.solve(rhs);
    for (int v = 0; v < n; ++v)
        if (unknown[v] >= 0) map.row(v) = rhs.row(unknown[v]);
    return map;
}

PlanePoints conformal_map(const TriangleMesh& mesh, const std::vector<int>& border) {
    const int n = mesh.vertex_count();
    const auto farthest = [&](int from) {
        int best = border.front() != from ? border.front() : border.back();
        for (const int v : border)
            if ((mesh.points.row(v) - mesh.points.row(from)).norm() > (mesh.points.row(best) - mesh.points.row(from)).norm() * (1 + 1e-9)) best = v;
        return best;
    };
    const int p = farthest(border.front()), q = farthest(p); // twice to the farthest: about a diameter
    std::vector<int> unknown(static_cast<std::size_t>(n), -1);
    int count = 0;
    for (int v = 0; v < n; ++v)
        if (v != p && v != q) unknown[v] = count++;

    // Per triangle one complex equation Σ_k W_k (x_k + i y_k) = 0, W_k the edge opposite to k in the triangle's own plane
    // over √(2·area) (Lévy et al. 2002, section 2.3). Unknowns: x first, then y.
    const auto column = [&](int v, bool imaginary) { return unknown[v] + (imaginary ? count : 0); };
    std::vector<Eigen::Triplet<double>> entries;
    Columns rhs = Columns::Zero(2 * count, 1);
    const auto pinned = [&](int v) { return Vector2d(v == q ? 1.0 : 0.0, 0.0); };
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        Vector3d a[3];
        for (int c = 0; c < 3; ++c) a[c] = mesh.points.row(mesh.triangles(t, c)).transpose();
        const Vector3d x = (a[1] - a[0]).normalized(), normal = (a[1] - a[0]).cross(a[2] - a[0]);
        const double twice_area = normal.norm();
        const double floor = 1e-8 * (a[1] - a[0]).squaredNorm();
        if (!(twice_area > floor)) continue; // a line says nothing about angles
        const Vector3d y = normal.cross(x).normalized();
        Vector2d flat[3], W[3];
        for (int c = 0; c < 3; ++c) flat[c] = {(a[c] - a[0]).dot(x), (a[c] - a[0]).dot(y)};
        for (int c = 0; c < 3; ++c) W[c] = (flat[(c + 2) % 3] - flat[(c + 1) % 3]) / std::sqrt(twice_area);
        // Real part: Σ Wx·x − Wy·y; imaginary part: Σ Wy·x + Wx·y.
        for (const bool imaginary : {false, true}) {
            const auto factor = [&](int c, bool of_y) { return of_y ? (imaginary ? W[c].x() : -W[c].y()) : (imaginary ? W[c].y() : W[c].x()); };
            double known = 0;
            for (int c = 0; c < 3; ++c)
                if (const int v = mesh.triangles(t, c); unknown[v] < 0) known += factor(c, false) * pinned(v).x() + factor(c, true) * pinned(v).y();
            for (int c = 0; c < 3; ++c)
                for (const bool cy : {false, true}) {
                    const int v = mesh.triangles(t, c);
                    if (unknown[v] < 0) continue;
                    rhs(column(v, cy), 0) -= factor(c, cy) * known;
                    for (int d = 0; d < 3; ++d)
                        for (const bool dy : {false, true}) {
                            const int w = mesh.triangles(t, d);
                            if (unknown[w] >= 0 && column(w, dy) <= column(v, cy)) entries.emplace_back(column(v, cy), column(w, dy), factor(c, cy) * factor(d, dy));
                        }
                }
        }
    }
    SparseMatrix A(2 * count, 2 * count);
    A.setFromTriplets(entries.begin(), entries.end());
    Points coordinates(2 * count, 3);
    for (int v = 0; v < n; ++v)
        if (unknown[v] >= 0) coordinates.row(column(v, false)) = coordinates.row(column(v, true)) = mesh.points.row(v);
    SparseCholesky factor(A, &coordinates);
    factor.factorize(A);
    factor.solve(rhs);
    PlanePoints map(n, 2);
    for (int v = 0; v < n; ++v) map.row(v) = unknown[v] < 0 ? Eigen::RowVector2d(pinned(v).transpose()) : Eigen::RowVector2d(rhs(column(v, false), 0), rhs(column(v, true), 0));

    double area = 0;
    Eigen::RowVector2d centre = Eigen::RowVector2d::Zero();
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        const Eigen::RowVector2d a = map.row(mesh.triangles(t, 0)), b = map.row(mesh.triangles(t, 1)), c = map.row(mesh.triangles(t, 2));
        const double part = std::abs(cross((b - a).transpose(), (c - a).transpose())) / 2;
        area += part;
        centre += part * (a + b + c) / 3;
    }
    if (area > 0) map = (map.rowwise() - centre / area) * std::sqrt(std::numbers::pi / area);
    return map;
}

} // namespace lissom
