#include "lissom/curve/territory.h"

#include "lissom/mesh/smooth.h"
#include "lissom/mesh/surface_paths.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lissom {

namespace {

constexpr float k_last = EncodedCurve::k_rows - 1;

bool is_start(float row) { return row < k_last / 2; }

} // namespace

void sort_remainder(const VertexRings& rings, CurveField& field) {
    const int n = rings.vertex_count();
    std::vector<bool> seen(n);
    for (int seed = 0; seed < n; ++seed) {
        if (seen[seed] || field.side[seed] == CurveSide::inside) continue;
        std::vector<int> piece{seed};
        seen[seed] = true;
        int at_start = 0, at_end = 0;
        for (std::size_t k = 0; k < piece.size(); ++k)
            for (const int u : rings[piece[k]]) {
                if (field.side[u] == CurveSide::inside) ++(is_start(field.row[u]) ? at_start : at_end);
                else if (!seen[u]) {
                    seen[u] = true;
                    piece.push_back(u);
                }
            }
        // A contact of less than a tenth is a hole in the side of the region, not an end of it.
        CurveSide side = CurveSide::none;
        if (at_start + at_end > 0) {
            const double share = static_cast<double>(at_end) / (at_start + at_end);
            side = share < 0.1 ? CurveSide::start : share > 0.9 ? CurveSide::end : CurveSide::between;
        }
        for (const int v : piece) field.side[v] = side;
    }
}

std::vector<double> between_shares(const TriangleMesh& mesh, const CurveField& field) {
    const int n = mesh.vertex_count();
    std::vector<double> result(n, 0.0);
    if (std::find(field.side.begin(), field.side.end(), CurveSide::between) == field.side.end()) return result;
    WeightedGraph graph = edge_graph(mesh);
    std::vector<int> starts, ends;
    for (int v = 0; v < n; ++v) {
        bool touches = false;
        for (int e = graph.offsets[v]; e < graph.offsets[v + 1]; ++e) {
            const bool through = field.side[v] == CurveSide::between || field.side[graph.ends[e]] == CurveSide::between;
            if (!through) graph.lengths[e] = std::numeric_limits<double>::infinity();
            touches = touches || field.side[graph.ends[e]] == CurveSide::between;
        }
        if (touches && field.side[v] == CurveSide::inside) (is_start(field.row[v]) ? starts : ends).push_back(v);
    }
    const std::vector<double> from_start = shortest_paths(graph, starts).distance, from_end = shortest_paths(graph, ends).distance;
    for (int v = 0; v < n; ++v) {
        if (field.side[v] != CurveSide::between) continue;
        const double x = std::isinf(from_end[v]) ? 0 : std::isinf(from_start[v]) ? 1 : from_start[v] / std::max(from_start[v] + from_end[v], 1e-300);
        result[v] = smooth(x);
    }
    return result;
}

void smooth_rows(const TriangleMesh& mesh, const VertexRings& rings, CurveField& field, double step, double radius) {
    const int n = mesh.vertex_count();
    std::vector<int> zone;
    std::vector<int> depth(n, -1);
    double edges = 0;
    std::size_t count = 0;
    const auto free = [&](int v) { return field.side[v] == CurveSide::inside && field.row[v] > 0 && field.row[v] < k_last; };
    for (int v = 0; v < n; ++v) {
        if (!free(v)) continue;
        for (const int u : rings[v]) {
            if (field.side[u] != CurveSide::inside) continue;
            const double length = (mesh.points.row(u) - mesh.points.row(v)).norm();
            edges += length;
            ++count;
            if (depth[v] < 0 && std::abs(field.row[u] - field.row[v]) * step > 2.5 * length) {
                depth[v] = 0;
                zone.push_back(v);
            }
        }
    }
    if (zone.empty() || !(edges > 0)) return;
    const double ratio = radius * static_cast<double>(count) / edges;
    const int sweeps = static_cast<int>(std::clamp(0.25 * ratio * ratio, 1.0, 40.0));
    const int rings_wide = static_cast<int>(std::ceil(2 * std::sqrt(sweeps))); // as far as sweeps reach to speak of
    for (std::size_t k = 0; k < zone.size(); ++k)
        for (const int u : rings[zone[k]])
            if (free(u) && depth[u] < 0 && depth[zone[k]] < rings_wide) {
                depth[u] = depth[zone[k]] + 1;
                zone.push_back(u);
            }
    std::vector<float> next(zone.size());
    for (int sweep = 0; sweep < sweeps; ++sweep) {
        for (std::size_t k = 0; k < zone.size(); ++k) {
            double sum = 0;
            int around = 0;
            for (const int u : rings[zone[k]])
                if (field.side[u] == CurveSide::inside) {
                    sum += field.row[u];
                    ++around;
                }
            next[k] = around > 0 ? static_cast<float>(0.5 * field.row[zone[k]] + 0.5 * sum / around) : field.row[zone[k]];
        }
        for (std::size_t k = 0; k < zone.size(); ++k) field.row[zone[k]] = next[k];
    }
}

} // namespace lissom
