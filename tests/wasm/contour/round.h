#pragma once

// Surfaces by formula whose contours and suggestive contours can be computed exactly.

#include "lissom/mesh/types.h"

#include <Eigen/Geometry>

#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <random>
#include <utility>

namespace rounds {

using Eigen::Vector3d;

/// A closed surface as the zero set of a function, with its exact contours by root finding.
struct Implicit {
    std::function<double(const Vector3d&)> value;

    [[nodiscard]] Vector3d gradient(const Vector3d& p) const {
        constexpr double h = 1e-5;
        Vector3d g;
        for (int k = 0; k < 3; ++k) g[k] = (value(p + h * Vector3d::Unit(k)) - value(p - h * Vector3d::Unit(k))) / (2 * h);
        return g;
    }
    [[nodiscard]] Vector3d normal(const Vector3d& p) const { return gradient(p).normalized(); }
    /// Nearest place on the surface, along the gradient.
    [[nodiscard]] Vector3d projected(Vector3d p) const {
        for (int k = 0; k < 20; ++k) {
            const Vector3d g = gradient(p);
            p -= value(p) / g.squaredNorm() * g;
        }
        return p;
    }
    /// S w·w with w the part of `towards` along the surface: the curvature of the normal section, times |w|².
    [[nodiscard]] double radial(const Vector3d& p, const Vector3d& towards) const {
        const Vector3d n = normal(p), w = towards - towards.dot(n) * n;
        constexpr double h = 1e-4;
        return (normal(projected(p + h * w)) - normal(projected(p - h * w))).dot(w) / (2 * h);
    }
    /// D_w κ_r, unit w; 1/length².
    [[nodiscard]] double growth(const Vector3d& p, const Vector3d& towards) const {
        const Vector3d n = normal(p), w = towards - towards.dot(n) * n;
        constexpr double h = 1e-3;
        const double length = w.norm();
        const Vector3d step = h * w / length;
        return (radial(projected(p + step), towards) - radial(projected(p - step), towards)) / (2 * h) / (length * length);
    }
};

struct Torus {
    double R = 1, r = 0.4; ///< around z

    [[nodiscard]] lissom::TriangleMesh mesh(int around, int across) const {
        lissom::TriangleMesh made;
        made.points.resize(around * across, 3);
        made.triangles.resize(2 * around * across, 3);
        for (int i = 0; i < around; ++i)
            for (int j = 0; j < across; ++j) {
                const double a = 2 * std::numbers::pi * i / around, b = 2 * std::numbers::pi * j / across;
                made.points.row(i * across + j) << (R + r * std::cos(b)) * std::cos(a), (R + r * std::cos(b)) * std::sin(a), r * std::sin(b);
                const int p = i * across + j, q = (i + 1) % around * across + j, s = (i + 1) % around * across + (j + 1) % across, t = i * across + (j + 1) % across;
                made.triangles.row(2 * p) << p, q, s;
                made.triangles.row(2 * p + 1) << p, s, t;
            }
        return made;
    }
    /// The curvature around the axis, and around the tube.
    [[nodiscard]] std::pair<double, double> curvatures(const Vector3d& p) const {
        const double cos_b = (std::hypot(p.x(), p.y()) - R) / r;
        return {cos_b / (R + r * cos_b), 1 / r};
    }
    [[nodiscard]] Implicit implicit() const {
        return {[R = R, r = r](const Vector3d& p) { return std::hypot(std::hypot(p.x(), p.y()) - R, p.z()) - r; }};
    }
};

/// A unit sphere whose radius is waved.
struct Bumpy {
    [[nodiscard]] double radius(const Vector3d& d) const { return 1 + 0.12 * std::sin(5 * d.x()) * std::sin(6 * d.y() + 1) + 0.08 * std::sin(7 * d.z() + 2 * d.x()); }
    /// The mesh of a sphere, moved out.
    [[nodiscard]] lissom::TriangleMesh mesh(lissom::TriangleMesh sphere) const {
        for (Eigen::Index v = 0; v < sphere.points.rows(); ++v) {
            const Vector3d d = sphere.points.row(v).transpose().normalized();
            sphere.points.row(v) = (radius(d) * d).transpose();
        }
        return sphere;
    }
    [[nodiscard]] Implicit implicit() const {
        return {[*this](const Vector3d& p) { return p.norm() - radius(p.normalized()); }};
    }
};

/// Vertices off along their normals (outward from `mesh` by direction given), uniform within ± amount.
inline lissom::TriangleMesh noisy(lissom::TriangleMesh mesh, const lissom::Points& normals, double amount, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> off(0, amount);
    for (Eigen::Index v = 0; v < mesh.points.rows(); ++v) mesh.points.row(v) += off(random) * normals.row(v);
    return mesh;
}

} // namespace rounds
