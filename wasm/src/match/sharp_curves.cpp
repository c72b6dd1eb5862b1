#include "lissom/match/sharp_curves.h"

#include "lissom/match/distances.h"
#include "lissom/match/fit_surface.h"
#include "lissom/mesh/disjoint_sets.h"
#include "lissom/mesh/errors.h"
#include "lissom/mesh/half_edges.h"
#include "lissom/mesh/surface_paths.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <set>
#include <string>
#include <utility>

namespace lissom {

namespace {

using Pair = std::pair<int, int>;

double radians(double degrees) { return degrees * std::numbers::pi / 180; }

std::vector<Pair> edges_by_angle(const TriangleMesh& mesh, double angle) {
    std::vector<Pair> found;
    const Points normals = triangle_normals(mesh);
    const double most = std::cos(radians(angle));
    for_each_edge(half_edges(mesh), [&](auto first, auto last) {
        if (last - first > 2) found.emplace_back(first->a, first->b);
        if (last - first != 2 || first->forward == (first + 1)->forward) return;
        const auto m = normals.row(first->triangle), n = normals.row((first + 1)->triangle);
        if (m.squaredNorm() > 0 && n.squaredNorm() > 0 && m.dot(n) < most) found.emplace_back(first->a, first->b);
    });
    return found;
}

std::vector<Pair> edges_picked(const TriangleMesh& mesh, const std::vector<std::vector<int>>& picked) {
    std::set<Pair> found;
    std::optional<WeightedGraph> graph;
    for (const std::vector<int>& chain : picked) {
        if (chain.size() < 2) throw InvalidInput("picked-edges", "A picked edge needs two vertices. Pick where it ends.");
        for (const int v : chain)
            if (v < 0 || v >= mesh.vertex_count()) throw InvalidInput("picked-edges", "Vertex " + std::to_string(v) + " was picked, but there are only " + std::to_string(mesh.vertex_count()) + ".");
        for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
            const int a = chain[i], b = chain[i + 1];
            if (a == b) continue;
            if (!graph) graph = edge_graph(mesh);
            const auto begin = graph->ends.begin() + graph->offsets[a], end = graph->ends.begin() + graph->offsets[a + 1];
            if (std::find(begin, end, b) != end) {
                found.insert(std::minmax(a, b));
                continue;
            }
            const int start[] = {a};
            const std::vector<int> way = shortest_paths(*graph, start).path_to(b);
            if (way.empty() || way.front() != a) throw InvalidInput("picked-edges", "No edges lead from vertex " + std::to_string(a) + " to " + std::to_string(b) + ". Pick both on one piece.");
            for (std::size_t k = 0; k + 1 < way.size(); ++k) found.insert(std::minmax(way[k], way[k + 1]));
        }
    }
    return {found.begin(), found.end()};
}

/// Edges of a curve in order.
template <class Visit>
void along(const EdgeCurve& curve, Visit visit) {
    for (std::size_t i = 0; i + 1 < curve.vertices.size(); ++i) visit(curve.vertices[i], curve.vertices[i + 1]);
    if (curve.closed) visit(curve.vertices.back(), curve.vertices.front());
}

double length(const EdgeCurve& curve, const Points& points) {
    double sum = 0;
    along(curve, [&](int a, int b) { sum += (points.row(a) - points.row(b)).norm(); });
    return sum;
}

/// Takes away what is short and loose, shortest first: of several at one place only one a round, for what is left there may become one longer curve.
void drop_loose(const Points& points, std::set<Pair>& edges, const std::set<Pair>& kept, double shortest) {
    for (bool dropped = true; dropped;) {
        dropped = false;
        const int n = static_cast<int>(points.rows());
        const std::vector<EdgeCurve> curves = chained(n, {edges.begin(), edges.end()});
        std::vector<int> degree(static_cast<std::size_t>(n), 0);
        for (const auto& [a, b] : edges) {
            ++degree[a];
            ++degree[b];
        }
        std::vector<std::pair<double, std::size_t>> loose;
        for (std::size_t k = 0; k < curves.size(); ++k) {
            const EdgeCurve& curve = curves[k];
            bool picked = false;
            along(curve, [&](int a, int b) { picked = picked || kept.contains(std::minmax(a, b)); });
            if (picked || (!curve.closed && degree[curve.vertices.front()] != 1 && degree[curve.vertices.back()] != 1)) continue;
            if (const double l = length(curve, points); l < shortest) loose.emplace_back(l, k);
        }
        std::sort(loose.begin(), loose.end());
        std::set<int> touched;
        for (const auto& [l, k] : loose) {
            const EdgeCurve& curve = curves[k];
            if (touched.contains(curve.vertices.front()) || touched.contains(curve.vertices.back())) continue;
            touched.insert({curve.vertices.front(), curve.vertices.back()});
            along(curve, [&](int a, int b) { edges.erase(std::minmax(a, b)); });
            dropped = true;
        }
    }
}

void drop_short_nets(const Points& points, std::set<Pair>& edges, const std::set<Pair>& kept, double shortest) {
    DisjointSets nets(static_cast<int>(points.rows()));
    for (const auto& [a, b] : edges) nets.join(a, b);
    std::vector<double> sum(static_cast<std::size_t>(points.rows()), 0);
    for (const Pair& edge : edges) sum[nets.find(edge.first)] += kept.contains(edge) ? shortest : (points.row(edge.first) - points.row(edge.second)).norm();
    std::erase_if(edges, [&](const Pair& edge) { return sum[nets.find(edge.first)] < shortest; });
}

std::vector<char> turning(const Points& points, const std::vector<EdgeCurve>& curves, double turn) {
    std::vector<char> flags(static_cast<std::size_t>(points.rows()), 0);
    const double least = std::cos(radians(turn));
    for (const EdgeCurve& curve : curves) {
        const auto n = curve.vertices.size();
        for (std::size_t i = curve.closed ? 0 : 1; i < n - (curve.closed ? 0 : 1); ++i) {
            const auto p = points.row(curve.vertices[i]);
            const Eigen::RowVector3d in = p - points.row(curve.vertices[(i + n - 1) % n]), out = points.row(curve.vertices[(i + 1) % n]) - p;
            if (in.dot(out) < least * in.norm() * out.norm()) flags[curve.vertices[i]] = 1;
        }
    }
    return flags;
}

} // namespace

std::vector<EdgeCurve> sharp_curves(const TriangleMesh& mesh, const SharpOptions& options, const std::vector<std::vector<int>>& picked) {
    const auto refuse = [](const std::string& sentence) { throw InvalidInput("bad-option", sentence); };
    if (!(options.angle >= 0 && options.angle < 180)) refuse("The sharp angle is " + std::to_string(options.angle) + " degrees; it must be between 0 and 180.");
    if (!(options.shortest >= 0 && options.shortest < 1)) refuse("The shortest sharp curve is " + std::to_string(options.shortest) + " of the size; it must be between 0 and 1.");
    if (!(options.turn > 0 && options.turn <= 180)) refuse("A corner's turn is " + std::to_string(options.turn) + " degrees; it must be above 0 and at most 180.");
    const std::vector<Pair> chosen = edges_picked(mesh, picked);
    const std::set<Pair> kept(chosen.begin(), chosen.end());
    std::set<Pair> sharp = kept;
    if (options.angle > 0) {
        const std::vector<Pair> bent = edges_by_angle(mesh, options.angle);
        sharp.insert(bent.begin(), bent.end());
    }
    const double shortest = options.shortest * surface_size(mesh).size;
    drop_loose(mesh.points, sharp, kept, shortest);
    drop_short_nets(mesh.points, sharp, kept, shortest);
    const std::vector<Pair> all(sharp.begin(), sharp.end());
    std::vector<char> corners = turning(mesh.points, chained(mesh.vertex_count(), all), options.turn);
    for (const std::vector<int>& chain : picked)
        if (chain.front() != chain.back()) corners[chain.front()] = corners[chain.back()] = 1;
    return chained(mesh.vertex_count(), all, corners);
}

} // namespace lissom
