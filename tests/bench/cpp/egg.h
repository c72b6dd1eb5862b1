#pragma once

// A surface of any size for benchmarks.

#include "lissom/mesh/types.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace bench {

/// A closed bumpy egg of about `vertices` points: the six sides of a cube, each a grid, blown up. The sides
/// repeat the points on their rims, which welding joins.
inline lissom::PolygonMesh bumpy_egg(int vertices) {
    const int m = std::max(2, static_cast<int>(std::lround(std::sqrt(vertices / 6.0))));
    std::vector<Eigen::Vector3d> points;
    lissom::PolygonMesh mesh;
    mesh.offsets.push_back(0);
    for (int axis = 0; axis < 3; ++axis)
        for (const int side : {0, m}) {
            const int first = static_cast<int>(points.size());
            for (int u = 0; u <= m; ++u)
                for (int v = 0; v <= m; ++v) {
                    std::array<int, 3> lattice;
                    lattice[axis] = side;
                    lattice[(axis + 1) % 3] = u;
                    lattice[(axis + 2) % 3] = v;
                    Eigen::Vector3d x;
                    for (int a = 0; a < 3; ++a) x[a] = std::tan(0.25 * M_PI * (2.0 * lattice[a] / m - 1));
                    x.normalize();
                    x *= 1 + 0.1 * std::sin(5 * x[0]) * std::cos(7 * x[1] + 3 * x[2]);
                    x[1] *= 2;
                    points.push_back(x);
                }
            const auto triangle = [&](int a, int b, int c) {
                for (const int v : {a, side ? b : c, side ? c : b}) mesh.corners.push_back(first + v);
                mesh.offsets.push_back(static_cast<int>(mesh.corners.size()));
            };
            for (int u = 0; u < m; ++u)
                for (int v = 0; v < m; ++v) {
                    const int at = u * (m + 1) + v;
                    triangle(at, at + m + 1, at + m + 2);
                    triangle(at, at + m + 2, at + 1);
                }
        }
    mesh.points.resize(static_cast<int>(points.size()), 3);
    for (std::size_t i = 0; i < points.size(); ++i) mesh.points.row(static_cast<int>(i)) = points[i];
    return mesh;
}

} // namespace bench
