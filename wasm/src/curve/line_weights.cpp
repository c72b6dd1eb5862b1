#include "lissom/curve/line_weights.h"

#include "lissom/mesh/errors.h"
#include "lissom/mesh/smooth.h"
#include "lissom/mesh/surface_paths.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>

namespace lissom {

using Eigen::Vector3d;

namespace {

constexpr double k_step = 0.002;  // between places of a line that are looked up, in diagonals
constexpr double k_reach = 0.13;  // of the largest extent
constexpr double k_near = 2;      // diagonals from the middle of the model beyond which a line is looked up at its corners alone
constexpr double k_largest = 1e100; // of coordinates whose squares can be computed with, in diagonals

std::vector<double> lengths_up_to(const Polyline& line) {
    std::vector<double> along{0};
    for (std::size_t i = 1; i < line.size(); ++i) along.push_back(along.back() + (line[i] - line[i - 1]).norm());
    return along;
}

/// Vertices beside a line, how far they are from it, and where along it.
struct Beside {
    std::vector<int> vertices;
    std::vector<double> distance, along;
};

/// The part of a segment near the model, from 0 to 1; empty where it passes by.
std::pair<double, double> near_part(const Vector3d& a, const Vector3d& b) {
    if (a.norm() <= k_near && b.norm() <= k_near) return {0, 1};
    const Vector3d along = b - a;
    const double aa = along.squaredNorm();
    if (!(aa > 0)) return {0, 0};
    const double middle = -a.dot(along) / aa, away2 = (a + middle * along).squaredNorm();
    if (away2 >= k_near * k_near) return {0, 0};
    const double half = std::sqrt((k_near * k_near - away2) / aa);
    return {std::clamp(middle - half, 0.0, 1.0), std::clamp(middle + half, 0.0, 1.0)};
}

Beside beside(const CurveSurface& surface, const Polyline& source) {
    Polyline line;
    for (const Vector3d& p : source) {
        line.push_back(surface.working().to_working(p));
        if (!(line.back().cwiseAbs().maxCoeff() < k_largest)) throw InvalidInput("non-finite-curve", "A line has places too far away to be computed with. Take another line.");
    }
    const std::vector<double> up_to = lengths_up_to(line);
    Beside found;
    std::vector<int> place(static_cast<std::size_t>(surface.mesh().vertex_count()), -1);
    const auto add = [&](const Vector3d& p, double share) {
        const int t = surface.tree().nearest(p).triangle;
        if (t < 0) return;
        for (const int v : surface.mesh().triangles.row(t)) {
            const double distance = (surface.mesh().points.row(v).transpose() - p).norm();
            if (place[v] < 0) {
                place[v] = static_cast<int>(found.vertices.size());
                found.vertices.push_back(v);
                found.distance.push_back(distance);
                found.along.push_back(share);
            } else if (distance < found.distance[place[v]]) {
                found.distance[place[v]] = distance;
                found.along[place[v]] = share;
            }
        }
    };
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const auto [from, to] = near_part(line[i], line[i + 1]);
        const int pieces = std::max(1, static_cast<int>(std::ceil((to - from) * (line[i + 1] - line[i]).norm() / k_step)));
        if (from > 0) add(line[i], up_to[i] / up_to.back());
        for (int k = 0; k < pieces; ++k) {
            const double u = from + (to - from) * k / pieces;
            add((1 - u) * line[i] + u * line[i + 1], ((1 - u) * up_to[i] + u * up_to[i + 1]) / up_to.back());
        }
    }
    add(line.back(), 1);
    return found;
}

/// The way along the edges from a set of vertices, each with a way of its own before it; `edges` ends with a row for the place they all come from.
ShortestPaths paths_from(WeightedGraph graph, const Beside& from, double limit) {
    for (std::size_t i = 0; i < from.vertices.size(); ++i) {
        graph.ends.push_back(from.vertices[i]);
        graph.lengths.push_back(from.distance[i]);
    }
    graph.offsets.push_back(static_cast<int>(graph.ends.size()));
    const int origin = graph.size() - 1;
    return shortest_paths(graph, std::vector<int>{origin}, limit);
}

void check(const Polyline& line) {
    for (const Vector3d& p : line)
        if (!p.allFinite()) throw InvalidInput("non-finite-curve", "A line has places that are not finite. Take another line.");
}

} // namespace

LineWeights line_weights(const CurveSurface& surface, const Polyline& line, const std::vector<Polyline>& others, const LineWeightsOptions& options) {
    check(line);
    if (line.size() < 2 || !(lengths_up_to(line).back() > 0)) throw InvalidInput("line-too-short", "The line has no length. Take a longer one.");
    if (!(options.radius >= 0) || !std::isfinite(options.radius))
        throw InvalidInput("line-radius", "A line's reach must be 0 or more; it is " + std::to_string(options.radius) + ".");
    const TriangleMesh& mesh = surface.mesh();
    const double extent = (mesh.points.colwise().maxCoeff() - mesh.points.colwise().minCoeff()).maxCoeff();
    const double radius = options.radius > 0 ? options.radius / surface.working().scale : k_reach * extent;
    const WeightedGraph graph = edge_graph(mesh);
    const Beside on = beside(surface, line);
    const ShortestPaths to_line = paths_from(graph, on, radius);
    Beside blocking;
    for (const Polyline& other : others) {
        check(other);
        if (other.size() < 2 || !(lengths_up_to(other).back() > 0)) continue;
        const Beside more = beside(surface, other);
        blocking.vertices.insert(blocking.vertices.end(), more.vertices.begin(), more.vertices.end());
        blocking.distance.insert(blocking.distance.end(), more.distance.begin(), more.distance.end());
    }
    const ShortestPaths to_others = paths_from(graph, blocking, radius);

    // Vertices in order of their distance, so that what each follows is known before it.
    std::vector<int> reached;
    for (int v = 0; v < mesh.vertex_count(); ++v)
        if (to_line.distance[v] < radius) reached.push_back(v);
    std::stable_sort(reached.begin(), reached.end(), [&](int a, int b) { return to_line.distance[a] < to_line.distance[b]; });
    const auto n = static_cast<std::size_t>(mesh.vertex_count());
    std::vector<double> w(n, 0), along(n, 0);
    std::vector<char> held(n, 1);
    for (std::size_t i = 0; i < on.vertices.size(); ++i) along[on.vertices[i]] = on.along[i];
    std::vector<char> beside_line(n, 0);
    for (const int v : on.vertices) beside_line[v] = 1;
    for (const int v : reached) {
        if (!beside_line[v] && to_line.before[v] < mesh.vertex_count()) along[v] = along[to_line.before[v]];
        const double d1 = to_line.distance[v], d0 = std::min(to_others.distance[v], radius - d1);
        w[v] = d0 + d1 > 0 ? smooth(d0 / (d0 + d1)) : 1;
        held[v] = 0;
    }
    for (const int v : blocking.vertices) held[v] = 1;
    for (const int v : on.vertices) held[v] = 1;
    for (int sweep = 0; sweep < options.sweeps; ++sweep) {
        const std::vector<double> before_w = w, before_along = along;
        for (const int v : reached) {
            double sum = 0, sum_along = 0;
            int following = 0;
            for (const int u : surface.rings()[v]) {
                sum += before_w[u];
                if (to_line.distance[u] < radius) {
                    sum_along += before_along[u];
                    ++following;
                }
            }
            const auto count = static_cast<double>(surface.rings()[v].size());
            if (!held[v] && count > 0) w[v] = (before_w[v] + sum / count) / 2;
            // The place to follow jumps where the line bends away; it is smoothed everywhere but on the line.
            if (!beside_line[v] && following > 0) along[v] = (before_along[v] + sum_along / following) / 2;
        }
    }
    std::vector<int> moving;
    for (const int v : reached)
        if (w[v] > 1e-6) moving.push_back(v);
    LineWeights result;
    result.vertices = surface.source_vertices(moving);
    for (const int s : result.vertices) {
        const int v = surface.working().working_of_source[s];
        result.weights.push_back(w[v]);
        result.along.push_back(along[v]);
    }
    return result;
}

Points pulled(const CurveSurface& surface, const LineWeights& weights, const Polyline& line, const Polyline& moved) {
    if (line.size() != moved.size())
        throw InvalidInput("line-places", "The line has " + std::to_string(line.size()) + " places at rest but " + std::to_string(moved.size()) + " after the pull. Give as many.");
    const std::vector<double> up_to = lengths_up_to(line);
    Points out(std::ssize(weights.vertices), 3);
    for (std::size_t i = 0; i < weights.vertices.size(); ++i) {
        const double s = weights.along[i] * up_to.back();
        const auto next = std::clamp<std::ptrdiff_t>(std::upper_bound(up_to.begin(), up_to.end(), s) - up_to.begin(), 1, std::ssize(up_to) - 1);
        const double piece = up_to[next] - up_to[next - 1], u = piece > 0 ? std::clamp((s - up_to[next - 1]) / piece, 0.0, 1.0) : 0;
        const Vector3d by = (1 - u) * (moved[next - 1] - line[next - 1]) + u * (moved[next] - line[next]);
        out.row(static_cast<Eigen::Index>(i)) = surface.working().source.row(weights.vertices[i]) + weights.weights[i] * by.transpose();
    }
    return out;
}

} // namespace lissom
