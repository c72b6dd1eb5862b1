#pragma once

// Forty-eight markers on a ring and on a nut: twelve each on top, below, inside and outside.

#include "lissom/mesh/types.h"

#include <cmath>
#include <numbers>

namespace rings {

/// Around an axis along y. @param outer  distance of the outside by angle
[[nodiscard]] inline lissom::Points around(const lissom::TriangleMesh& mesh, double ring, double height, double inner, double (*outer)(double)) {
    const Eigen::RowVector3d middle = (mesh.points.colwise().minCoeff() + mesh.points.colwise().maxCoeff()) / 2;
    lissom::Points all(48, 3);
    for (int k = 0; k < 12; ++k) {
        const double t = k * std::numbers::pi / 6;
        const Eigen::RowVector3d d(std::cos(t), 0, std::sin(t));
        all.row(4 * k) = middle + ring * d + Eigen::RowVector3d(0, height, 0);
        all.row(4 * k + 1) = middle + ring * d - Eigen::RowVector3d(0, height, 0);
        all.row(4 * k + 2) = middle + inner * d;
        all.row(4 * k + 3) = middle + outer(t) * d;
    }
    return all;
}

[[nodiscard]] inline lissom::Points on_torus(const lissom::TriangleMesh& torus) {
    return around(torus, 1, 0.38, 0.62, [](double) { return 1.38; });
}

[[nodiscard]] inline lissom::Points on_nut(const lissom::TriangleMesh& nut) {
    constexpr double sixth = std::numbers::pi / 6;
    return around(nut, 0.7, 0.35, 0.5, [](double t) { return std::cos(sixth) / std::cos(std::fmod(t + sixth, 2 * sixth) - sixth); });
}

} // namespace rings
