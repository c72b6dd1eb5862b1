#include "lissom/mesh/points_surface.h"

#include "lissom/mesh/topology.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>

using namespace lissom;
using Eigen::Vector3d;

namespace {

/// As even as points on a sphere can be (Fibonacci's spiral).
Points sphere(int n) {
    Points points(n, 3);
    const double turn = std::numbers::pi * (3 - std::sqrt(5.0));
    for (int v = 0; v < n; ++v) {
        const double y = 1 - 2 * (v + 0.5) / n, r = std::sqrt(1 - y * y);
        points.row(v) << r * std::cos(turn * v), y, r * std::sin(turn * v);
    }
    return points;
}

/// Anywhere, as scanners leave them.
Points torus(int n, unsigned seed) {
    std::mt19937 chance(seed);
    const auto one = [&] { return chance() / 4294967296.0; };
    Points points(n, 3);
    for (int v = 0; v < n;) {
        const double a = 2 * std::numbers::pi * one(), b = 2 * std::numbers::pi * one();
        if (one() > (1 + 0.4 * std::cos(b)) / 1.4) continue; // evenly by area
        points.row(v++) << (1 + 0.4 * std::cos(b)) * std::cos(a), 0.4 * std::sin(b), (1 + 0.4 * std::cos(b)) * std::sin(a);
    }
    return points;
}

Points grid(int n, double height = 0) {
    Points points(n * n, 3);
    for (int v = 0; v < n * n; ++v) points.row(v) << v % n, height, v / n;
    return points;
}

struct Quality {
    double closed = 0; ///< share of the edges with two faces
    double tilt = 0;   ///< largest angle between a face and the surface, degrees
    int used = 0;      ///< points that are corners
};

Quality quality(const Points& points, const Triangles& triangles, const std::function<Vector3d(const Vector3d&)>& normal) {
    Quality found;
    const TriangleMesh mesh{points, triangles};
    int two = 0, all = 0;
    for (const Edge& e : edges(mesh)) {
        ++all;
        two += e.forward + e.backward == 2;
        CHECK(e.forward + e.backward <= 2);
    }
    found.closed = static_cast<double>(two) / all;
    std::vector<char> used(points.rows(), 0);
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        const auto p = [&](int k) -> Vector3d { return points.row(triangles(t, k)); };
        for (int k = 0; k < 3; ++k) used[triangles(t, k)] = 1;
        const Vector3d across = (p(1) - p(0)).cross(p(2) - p(0)).normalized();
        const double cosine = std::abs(across.dot(normal((p(0) + p(1) + p(2)) / 3)));
        found.tilt = std::max(found.tilt, std::acos(std::min(1.0, cosine)) * 180 / std::numbers::pi);
    }
    found.used = static_cast<int>(std::count(used.begin(), used.end(), 1));
    return found;
}

Vector3d torus_normal(const Vector3d& p) {
    const Vector3d ring = Vector3d(p.x(), 0, p.z()).normalized();
    return (p - ring).normalized();
}

} // namespace

TEST_CASE("even points on a sphere become a closed sphere") {
    const Points points = sphere(3000);
    const Triangles triangles = surface_through(points);
    const Quality q = quality(points, triangles, [](const Vector3d& p) -> Vector3d { return p.normalized(); });
    CHECK(q.used == 3000);
    CHECK(q.closed > 0.999);
    CHECK(q.tilt < 5);
    CHECK(triangles.rows() >= 2 * 3000 - 10);
    for (int t = 0; t < triangles.rows(); ++t) {
        const auto p = [&](int k) -> Vector3d { return points.row(triangles(t, k)); };
        CHECK((p(1) - p(0)).cross(p(2) - p(0)).dot(p(0)) > 0);
    }
}

TEST_CASE("points anywhere on a torus become a torus with few gaps") {
    const Points points = torus(6000, 7);
    const Quality q = quality(points, surface_through(points), torus_normal);
    MESSAGE("torus of 6,000 scattered points: " << 100 * q.closed << " % of the edges closed, faces tilted by up to " << q.tilt << " degrees");
    CHECK(q.used > 5950);
    CHECK(q.closed > 0.95);
    CHECK(q.tilt < 60);
}

TEST_CASE("a regular grid gets one diagonal everywhere") {
    const Points points = grid(20);
    const Triangles triangles = surface_through(points);
    CHECK(triangles.rows() == 2 * 19 * 19);
    int rising = 0, falling = 0;
    for (const Edge& e : edges(TriangleMesh{points, triangles})) {
        const Vector3d arm = points.row(e.b) - points.row(e.a);
        if (std::abs(arm.x()) > 0.5 && std::abs(arm.z()) > 0.5) ++(arm.x() * arm.z() > 0 ? rising : falling);
    }
    CHECK(rising + falling == 19 * 19);
    CHECK(std::min(rising, falling) == 0);
}

TEST_CASE("two sheets above one another stay two") {
    Points points(2 * 225, 3);
    points << grid(15), grid(15, 6); // at a corner the neighbours reach five spacings far
    const Triangles triangles = surface_through(points);
    CHECK(triangles.rows() == 4 * 14 * 14);
    for (int t = 0; t < triangles.rows(); ++t) {
        const int below = static_cast<int>((triangles.row(t).array() < 225).count());
        CHECK((below == 0 || below == 3));
    }
}

TEST_CASE("neither size nor place nor direction matters") {
    const Points points = torus(800, 3);
    const Triangles triangles = surface_through(points);
    const Eigen::Affine3d motion = Eigen::Translation3d(300, -20, 7) * Eigen::AngleAxisd(1.1, Vector3d(1, 2, 3).normalized()) * Eigen::Scaling(1000.0);
    Points moved(points.rows(), 3);
    for (int v = 0; v < points.rows(); ++v) moved.row(v) = (motion * Vector3d(points.row(v))).transpose();
    CHECK(surface_through(moved) == triangles);
    CHECK(surface_through(1e-6 * points) == triangles);
}

TEST_CASE("points that stand twice count once; a line, a pair and nothing have no surface") {
    Points twice(800, 3);
    twice << grid(20), grid(20);
    CHECK(surface_through(twice) == surface_through(grid(20)));
    Points line(30, 3);
    for (int v = 0; v < 30; ++v) line.row(v) << v, 2 * v, -v;
    CHECK(surface_through(line).rows() == 0);
    CHECK(surface_through(Points::Zero(9, 3)).rows() == 0);
    CHECK(surface_through(Points(0, 3)).rows() == 0);
    CHECK(surface_through(grid(20).topRows(2)).rows() == 0);
}

TEST_CASE("points in rows around a tapering limb, twice as far apart one way as the other, become its surface") {
    constexpr int rows = 48, around = 24;
    Points points(rows * around + 1, 3);
    for (int i = 0; i < rows; ++i)
        for (int j = 0; j < around; ++j) {
            const double s = static_cast<double>(i) / rows, t = 2 * std::numbers::pi * j / around, r = 0.3 * (1 - s * s * s);
            points.row(i * around + j) << r * std::cos(t), 2 * s, r * std::sin(t);
        }
    points.row(rows * around) << 0, 2, 0;
    const Triangles triangles = surface_through(points);
    const Quality q = quality(points, triangles, [](const Vector3d& p) -> Vector3d {
        const double s = p.y() / 2;
        return Vector3d(p.x(), 0.45 * s * s * std::hypot(p.x(), p.z()), p.z()).normalized();
    });
    MESSAGE("limb in rows: " << triangles.rows() << " triangles for " << 2 * around * (rows - 1) + around << ", " << 100 * q.closed << " % of the edges closed");
    CHECK(q.used == points.rows());
    CHECK(q.closed > 0.98); // 24 edges are its open end
}
