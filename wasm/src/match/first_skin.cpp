#include "lissom/match/first_skin.h"

#include "lissom/mesh/errors.h"
#include "lissom/mesh/operators.h"
#include "lissom/mesh/surface_samples.h"
#include "lissom/mesh/triangle_tree.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <vector>

namespace lissom {

using Eigen::RowVector3d;
using Eigen::Vector3d;
using Eigen::Vector3i;

namespace {

constexpr double k_most_vertices = 1e6;
constexpr int k_samples = 5000;
constexpr double k_widest_tube = 0.95; // of the ring's radius

struct Extent {
    RowVector3d low, high;
    [[nodiscard]] double diagonal() const { return (high - low).norm(); }
};

/// Of the places that triangles use.
Extent extent_of(const TriangleMesh& model) {
    Extent e{RowVector3d::Constant(1e300), RowVector3d::Constant(-1e300)};
    for (const int v : model.triangles.reshaped()) {
        e.low = e.low.cwiseMin(model.points.row(v));
        e.high = e.high.cwiseMax(model.points.row(v));
    }
    if (model.triangle_count() == 0 || !(e.diagonal() > 0)) throw InvalidInput("flat-model", "There is nothing to put a skin around: the model is a single place. Choose another model.");
    return e;
}

void check(double edge_length, double vertices) {
    if (!(edge_length > 0 && std::isfinite(edge_length))) throw InvalidInput("bad-option", "A first skin needs an edge length above 0.");
    if (!(vertices <= k_most_vertices)) throw InvalidInput("bad-option", "Edges of " + std::to_string(edge_length) + " would need more than a million vertices. Choose longer ones.");
}

TriangleMesh mesh_of(const std::vector<Vector3d>& points, const std::vector<std::array<int, 3>>& triangles) {
    TriangleMesh mesh{Points(std::ssize(points), 3), Triangles(std::ssize(triangles), 3)};
    for (std::size_t i = 0; i < points.size(); ++i) mesh.points.row(static_cast<Eigen::Index>(i)) = points[i].transpose();
    for (std::size_t i = 0; i < triangles.size(); ++i) mesh.triangles.row(static_cast<Eigen::Index>(i)) << triangles[i][0], triangles[i][1], triangles[i][2];
    return mesh;
}

} // namespace

TriangleMesh box_around(const TriangleMesh& model, double edge_length, double margin) {
    Extent e = extent_of(model);
    const double more = margin * e.diagonal();
    e.low.array() -= more;
    e.high.array() += more;
    const Vector3d size = (e.high - e.low).transpose();
    check(edge_length, 2 * (size[0] * size[1] + size[1] * size[2] + size[2] * size[0]) / (edge_length * edge_length));
    Vector3i n;
    for (int k = 0; k < 3; ++k) n[k] = std::max(1, static_cast<int>(std::lround(size[k] / edge_length)));
    std::map<std::array<int, 3>, int> known;
    std::vector<Vector3d> points;
    std::vector<std::array<int, 3>> triangles;
    const auto vertex = [&](const Vector3i& at) {
        const auto [found, fresh] = known.try_emplace({at[0], at[1], at[2]}, static_cast<int>(points.size()));
        if (fresh) points.push_back(e.low.transpose() + (size.array() * at.cast<double>().array() / n.cast<double>().array()).matrix());
        return found->second;
    };
    for (int axis = 0; axis < 3; ++axis)
        for (const bool far : {false, true}) {
            const int u = (axis + 1) % 3, v = (axis + 2) % 3; // u × v = axis
            for (int j = 0; j < n[v]; ++j)
                for (int i = 0; i < n[u]; ++i) {
                    Vector3i at = Vector3i::Zero();
                    at[axis] = far ? n[axis] : 0;
                    const auto corner = [&](int di, int dj) {
                        at[u] = i + di;
                        at[v] = j + dj;
                        return vertex(at);
                    };
                    const int a = corner(0, 0), b = corner(1, 0), c = corner(1, 1), d = corner(0, 1);
                    // Diagonals change so that neither direction is preferred.
                    std::array<std::array<int, 3>, 2> two = (i + j) % 2 ? std::array<std::array<int, 3>, 2>{{{a, b, c}, {a, c, d}}} : std::array<std::array<int, 3>, 2>{{{a, b, d}, {b, c, d}}};
                    for (auto& t : two) {
                        if (!far) std::swap(t[1], t[2]);
                        triangles.push_back(t);
                    }
                }
        }
    return mesh_of(points, triangles);
}

TriangleMesh sphere_around(const TriangleMesh& model, double edge_length, double margin) {
    const Extent e = extent_of(model);
    const Vector3d middle = (e.low + e.high).transpose() / 2;
    double radius = 0;
    for (const int v : model.triangles.reshaped()) radius = std::max(radius, (model.points.row(v).transpose() - middle).norm());
    radius *= 1 + margin;
    check(edge_length, 4 * std::numbers::pi * radius * radius / (0.866 * edge_length * edge_length));
    const double golden = (1 + std::sqrt(5.0)) / 2;
    std::array<Vector3d, 12> corner;
    for (int k = 0; k < 3; ++k) // three golden rectangles
        for (int s = 0; s < 4; ++s) {
            Vector3d p = Vector3d::Zero();
            p[(k + 1) % 3] = s & 1 ? 1 : -1;
            p[(k + 2) % 3] = s & 2 ? golden : -golden;
            corner[4 * k + s] = p.normalized();
        }
    const double side = 2 / std::sqrt(1 + golden * golden);
    const int n = std::max(1, static_cast<int>(std::lround(1.1 * radius * side / edge_length))); // arcs are longer than sides
    std::vector<Vector3d> points;
    std::vector<std::array<int, 3>> triangles;
    std::map<std::array<int, 6>, int> known; // corners and their parts, ascending
    const auto joined = [&](int a, int b) { return std::abs((corner[a] - corner[b]).norm() - side) < 0.1; };
    for (int a = 0; a < 12; ++a)
        for (int b = a + 1; b < 12; ++b)
            for (int c = b + 1; c < 12; ++c) {
                if (!joined(a, b) || !joined(b, c) || !joined(c, a)) continue;
                const bool outward = (corner[b] - corner[a]).cross(corner[c] - corner[a]).dot(corner[a]) > 0;
                const int second = outward ? b : c, third = outward ? c : b;
                const auto vertex = [&](int i, int j) { // parts of the second and third corner
                    std::array<std::pair<int, int>, 3> parts{{{a, n - i - j}, {second, i}, {third, j}}};
                    for (auto& [which, part] : parts)
                        if (part == 0) which = -1;
                    std::sort(parts.begin(), parts.end());
                    const auto [found, fresh] = known.try_emplace({parts[0].first, parts[0].second, parts[1].first, parts[1].second, parts[2].first, parts[2].second}, static_cast<int>(points.size()));
                    if (fresh) points.push_back(middle + radius * ((n - i - j) * corner[a] + i * corner[second] + j * corner[third]).normalized());
                    return found->second;
                };
                for (int j = 0; j < n; ++j)
                    for (int i = 0; i + j < n; ++i) {
                        triangles.push_back({vertex(i, j), vertex(i + 1, j), vertex(i, j + 1)});
                        if (i + j + 1 < n) triangles.push_back({vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
                    }
            }
    return mesh_of(points, triangles);
}

TorusAround torus_around(const TriangleMesh& model, double edge_length, double margin) {
    const Extent extent = extent_of(model);
    Points samples = sample_surface(model, k_samples).on(model);
    if (samples.rows() == 0) samples = model.points;
    const RowVector3d middle = samples.colwise().mean();
    const Points about = samples.rowwise() - middle;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(Eigen::Matrix3d(about.transpose() * about));
    TorusAround out;
    Vector3d axis = axes.eigenvectors().col(0);
    const TriangleTree tree(model);
    for (int k = 0; k < 3 && !out.through; ++k) {
        const Vector3d along = axes.eigenvectors().col(k);
        out.through = tree.hits(middle.transpose() - 2 * extent.diagonal() * along, along).empty();
        if (out.through) axis = along;
    }
    Eigen::Index most = 0; // which of the two ways along the axis says the largest coordinate
    axis.cwiseAbs().maxCoeff(&most);
    if (axis[most] < 0) axis = -axis;
    double near = 1e300, far = 0, low = 1e300, high = -1e300;
    const auto look_at = [&](const Vector3d& p) {
        const Vector3d to = p - middle.transpose();
        const double z = to.dot(axis), r = (to - z * axis).norm();
        near = std::min(near, r);
        far = std::max(far, r);
        low = std::min(low, z);
        high = std::max(high, z);
    };
    for (const int v : model.triangles.reshaped()) look_at(model.points.row(v));
    for (Eigen::Index i = 0; i < samples.rows(); ++i) look_at(samples.row(i)); // sides come nearer than their ends
    const double ring = (near + far) / 2, around_box = std::numbers::sqrt2 * (1 + margin); // the ellipse around a rectangle
    const double width = std::min(around_box * (far - near) / 2, k_widest_tube * ring), height = around_box * std::max((high - low) / 2, 0.01 * ring), lift = (low + high) / 2;
    const double across = 2 * std::numbers::pi * std::sqrt((width * width + height * height) / 2);
    check(edge_length, 2 * std::numbers::pi * ring * across / (edge_length * edge_length));
    const int m = std::max(3, static_cast<int>(std::lround(2 * std::numbers::pi * ring / edge_length))), n = std::max(3, static_cast<int>(std::lround(across / edge_length)));
    Eigen::Index least = 0;
    axis.cwiseAbs().minCoeff(&least);
    const Vector3d u = axis.cross(Vector3d::Unit(least)).normalized(), v = axis.cross(u);
    std::vector<Vector3d> points;
    std::vector<std::array<int, 3>> triangles;
    for (int i = 0; i < m; ++i)
        for (int j = 0; j < n; ++j) {
            const double s = 2 * std::numbers::pi * i / m, t = 2 * std::numbers::pi * j / n;
            points.push_back(middle.transpose() + (ring + width * std::cos(t)) * (std::cos(s) * u + std::sin(s) * v) + (lift + height * std::sin(t)) * axis);
            const int a = i * n + j, b = (i + 1) % m * n + j, c = (i + 1) % m * n + (j + 1) % n, d = i * n + (j + 1) % n;
            triangles.push_back({a, b, c});
            triangles.push_back({a, c, d});
        }
    out.mesh = mesh_of(points, triangles);
    return out;
}

} // namespace lissom
