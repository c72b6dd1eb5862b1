#include "lissom/mesh/edge_lengths.h"

#include "lissom/mesh/operators.h"
#include "lissom/mesh/topology.h"

#include <algorithm>
#include <cmath>
#include <queue>

namespace lissom {

namespace {

constexpr double k_least = 0.4, k_most = 2.5;
constexpr int k_evenings = 2;

std::vector<double> curvatures(const TriangleMesh& mesh, const VertexRings& rings, const std::vector<char>& creases) {
    const Points normals = vertex_normals(mesh);
    const auto crease = [&](int v) { return !creases.empty() && creases[v]; };
    std::vector<double> bend(static_cast<std::size_t>(mesh.vertex_count()), -1); // −1: not known
    for (int v = 0; v < mesh.vertex_count(); ++v) {
        if (crease(v)) continue;
        for (const int w : rings[v])
            if (const double l = (mesh.points.row(v) - mesh.points.row(w)).norm(); !crease(w) && l > 0) bend[v] = std::max(bend[v], (normals.row(v) - normals.row(w)).norm() / l);
    }
    for (int k = 0; k < k_evenings; ++k) {
        const std::vector<double> before = bend;
        for (int v = 0; v < mesh.vertex_count(); ++v) {
            double sum = 0;
            int count = 0;
            const auto add = [&](int w) {
                if (before[w] < 0) return;
                sum += before[w];
                ++count;
            };
            add(v);
            for (const int w : rings[v]) add(w);
            if (count > 0) bend[v] = sum / count;
        }
    }
    for (double& value : bend) value = std::max(value, 0.0);
    return bend;
}

/// No length exceeds another by more than its share of the way between (Dijkstra from all).
void grade(std::vector<double>& lengths, const TriangleMesh& mesh, const VertexRings& rings) {
    using Entry = std::pair<double, int>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    for (int v = 0; v < mesh.vertex_count(); ++v) open.emplace(lengths[v], v);
    while (!open.empty()) {
        const auto [h, v] = open.top();
        open.pop();
        if (h > lengths[v]) continue;
        for (const int w : rings[v])
            if (const double most = h + k_grading * (mesh.points.row(v) - mesh.points.row(w)).norm(); most < lengths[w]) {
                lengths[w] = most;
                open.emplace(most, w);
            }
    }
}

} // namespace

std::vector<double> edge_lengths(const TriangleMesh& mesh, double length, double adapt, const std::vector<char>& creases) {
    std::vector<double> lengths(static_cast<std::size_t>(mesh.vertex_count()), length);
    if (!(adapt > 0)) return lengths;
    const VertexRings rings = vertex_rings(mesh);
    const Eigen::VectorXd areas = vertex_areas(mesh);
    const std::vector<double> bend = curvatures(mesh, rings, creases);
    const double whole = areas.sum();
    double mean = 0;
    for (int v = 0; v < mesh.vertex_count(); ++v) mean += areas[v] * bend[v] / whole;
    if (!(mean > 0)) return lengths;
    for (int v = 0; v < mesh.vertex_count(); ++v)
        lengths[v] = length * (bend[v] > 0 ? std::clamp(std::pow(mean / bend[v], adapt / 2), k_least, k_most) : k_most);
    grade(lengths, mesh, rings);
    double density = 0; // of triangles, against that of equal lengths
    for (int v = 0; v < mesh.vertex_count(); ++v) density += areas[v] / whole * length * length / (lengths[v] * lengths[v]);
    for (double& h : lengths) h = std::clamp(h * std::sqrt(density), k_least * length, k_most * length);
    return lengths;
}

} // namespace lissom
