#pragma once

// Figures that are alike: their vertices correspond, which a match is not told.

#include "../shapes.h"

#include <cmath>

namespace armed {

/// A ball with five arms: nothing symmetric about it.
[[nodiscard]] inline lissom::TriangleMesh figure(double bend = 0, int levels = 4) {
    lissom::TriangleMesh mesh = shapes::icosphere(levels);
    lissom::Points arms(5, 3);
    arms << 1, 0.2, 0.1, -0.8, 0.5, 0.3, 0.1, -1, 0.3, 0.2, 0.4, 1, -0.3, 0.1, -1;
    const double lengths[] = {0.8, 0.5, 0.7, 0.4, 0.6};
    for (int v = 0; v < mesh.vertex_count(); ++v) {
        const Eigen::Vector3d d = mesh.points.row(v).normalized();
        double r = 0.5;
        for (int k = 0; k < 5; ++k) r += lengths[k] * (1 + bend * std::sin(2.0 * k)) * std::exp(12 * (d.dot(Eigen::Vector3d(arms.row(k).normalized())) - 1));
        const Eigen::Vector3d p = r * d;
        mesh.points.row(v) = Eigen::RowVector3d(p.x() + bend * 0.3 * p.y() * p.y(), p.y() + bend * 0.2 * p.z() * p.z(), p.z() - bend * 0.3 * p.x() * p.y());
    }
    return mesh;
}
/// Vertices of the icosphere as markers: the same places on every figure.
[[nodiscard]] inline lissom::Points some(const lissom::TriangleMesh& mesh, int count = 12) {
    lissom::Points places(count, 3);
    for (int k = 0; k < count; ++k) places.row(k) = mesh.points.row(k); // the icosahedron's own
    return places;
}

} // namespace armed
