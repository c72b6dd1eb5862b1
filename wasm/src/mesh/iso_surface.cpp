#include "lissom/mesh/iso_surface.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <unordered_map>

namespace lissom {

using Eigen::Vector3d;
using Tetrahedron = std::array<int, 4>;

namespace {

constexpr double k_margin = 0.02; // of an edge

bool even(const std::array<int, 4>& order) {
    int inversions = 0;
    for (int i = 0; i < 4; ++i)
        for (int j = i + 1; j < 4; ++j) inversions += order[i] > order[j];
    return inversions % 2 == 0;
}

/// Corners of a cell as bits x, y, z: from 0 to 7 along the axes in each order, turned so that all are positive.
std::array<Tetrahedron, 6> tetrahedra_of_cell() {
    std::array<Tetrahedron, 6> all{};
    std::array<int, 3> axes{0, 1, 2};
    for (Tetrahedron& t : all) {
        t = {0, 1 << axes[0], (1 << axes[0]) | (1 << axes[1]), 7};
        if (!even({axes[0], axes[1], axes[2], 3})) std::swap(t[1], t[2]);
        std::next_permutation(axes.begin(), axes.end());
    }
    return all;
}

} // namespace

TriangleMesh iso_surface(const Grid& grid, const std::vector<float>& values) {
    const auto tetrahedra = tetrahedra_of_cell();
    std::vector<Vector3d> points;
    std::vector<std::array<int, 3>> triangles;
    std::unordered_map<std::uint64_t, int> known; // edge -> vertex; asked, never walked
    const auto on_edge = [&](int a, int b) {
        const auto [low, high] = std::minmax(a, b);
        const auto [at, fresh] = known.try_emplace(static_cast<std::uint64_t>(low) << 32 | static_cast<std::uint32_t>(high), static_cast<int>(points.size()));
        if (fresh) {
            const double u = values[low], v = values[high], part = std::clamp(u / (u - v), k_margin, 1 - k_margin);
            points.push_back((1 - part) * grid.position(low) + part * grid.position(high));
        }
        return at->second;
    };
    for (int z = 0; z + 1 < grid.size.z(); ++z)
        for (int y = 0; y + 1 < grid.size.y(); ++y)
            for (int x = 0; x + 1 < grid.size.x(); ++x) {
                std::array<int, 8> node{};
                int negative = 0;
                for (int c = 0; c < 8; ++c) {
                    node[c] = grid.node(x + (c & 1), y + (c >> 1 & 1), z + (c >> 2));
                    negative += values[node[c]] <= 0;
                }
                if (negative == 0 || negative == 8) continue;
                for (const Tetrahedron& t : tetrahedra) {
                    std::array<int, 4> order{}; // negative corners first
                    int inside = 0;
                    for (int k = 0; k < 4; ++k)
                        if (values[node[t[k]]] <= 0) order[inside++] = k;
                    for (int k = 0, next = inside; k < 4; ++k)
                        if (!(values[node[t[k]]] <= 0)) order[next++] = k;
                    if (inside == 0 || inside == 4) continue;
                    if (!even(order)) inside == 3 ? std::swap(order[0], order[1]) : std::swap(order[2], order[3]);
                    const auto cut = [&](int i, int j) { return on_edge(node[t[order[i]]], node[t[order[j]]]); };
                    if (inside == 1) triangles.push_back({cut(0, 1), cut(0, 2), cut(0, 3)});
                    else if (inside == 3) triangles.push_back({cut(0, 3), cut(1, 3), cut(2, 3)});
                    else {
                        triangles.push_back({cut(0, 2), cut(0, 3), cut(1, 3)});
                        triangles.push_back({cut(0, 2), cut(1, 3), cut(1, 2)});
                    }
                }
            }
    TriangleMesh mesh{Points(std::ssize(points), 3), Triangles(std::ssize(triangles), 3)};
    for (std::size_t i = 0; i < points.size(); ++i) mesh.points.row(static_cast<Eigen::Index>(i)) = points[i].transpose();
    for (std::size_t i = 0; i < triangles.size(); ++i) mesh.triangles.row(static_cast<Eigen::Index>(i)) << triangles[i][0], triangles[i][1], triangles[i][2];
    return mesh;
}

} // namespace lissom
