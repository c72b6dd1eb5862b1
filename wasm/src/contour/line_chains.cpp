#include "line_chains.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace lissom {

using Eigen::Vector3d;

double LineChain::length() const {
    double sum = 0;
    for (std::size_t i = 1; i < points.size(); ++i) sum += (points[i] - points[i - 1]).norm();
    return closed && !points.empty() ? sum + (points.front() - points.back()).norm() : sum;
}

std::vector<LineChain> chained(const std::vector<LinePiece>& pieces) {
    // Which piece's end lies beside which: those on one edge, two by two.
    std::vector<std::pair<int, int>> on_edge; // (edge, 2 piece + end)
    for (int p = 0; p < static_cast<int>(pieces.size()); ++p)
        for (int end = 0; end < 2; ++end)
            if (pieces[p].edges[end] >= 0) on_edge.emplace_back(pieces[p].edges[end], 2 * p + end);
    std::sort(on_edge.begin(), on_edge.end());
    std::vector<int> beside(2 * pieces.size(), -1);
    for (std::size_t i = 0; i + 1 < on_edge.size(); ++i)
        if (on_edge[i].first == on_edge[i + 1].first) {
            beside[on_edge[i].second] = on_edge[i + 1].second;
            beside[on_edge[i + 1].second] = on_edge[i].second;
            ++i;
        }
    std::vector<char> used(pieces.size(), 0);
    std::vector<LineChain> chains;
    const auto walk = [&](int from_end) { // comes into a piece by that end
        LineChain chain;
        int end = from_end;
        const auto put = [&](int e) {
            const LinePiece& piece = pieces[e / 2];
            chain.points.push_back(piece.ends[e % 2]);
            chain.triangles.push_back(piece.triangle);
            chain.weights.push_back(piece.weights[e % 2]);
            chain.values.push_back(piece.values[e % 2]);
        };
        put(end);
        while (end >= 0 && !used[end / 2]) {
            used[end / 2] = 1;
            put(end ^ 1);
            end = beside[end ^ 1];
        }
        if (end >= 0) { // back at the start
            chain.closed = true;
            chain.points.pop_back();
            chain.triangles.pop_back();
            chain.weights.pop_back();
            chain.values.pop_back();
        }
        chains.push_back(std::move(chain));
    };
    for (int p = 0; p < static_cast<int>(pieces.size()); ++p) {
        if (used[p]) continue;
        int end = 2 * p; // back to the line's start, or once around
        while (beside[end] >= 0) {
            end = beside[end] ^ 1;
            if (end == 2 * p) break;
        }
        walk(end);
    }
    return chains;
}

namespace {

/// Place on the chain that lies `distance` before or after point i.
Vector3d reached(const LineChain& chain, std::size_t i, int step, double distance) {
    const std::size_t n = chain.points.size();
    std::size_t at = i;
    for (std::size_t k = 0; k < n; ++k) {
        if (!chain.closed && (step < 0 ? at == 0 : at + 1 == n)) return chain.points[at];
        const std::size_t next = (at + n + static_cast<std::size_t>(step + static_cast<int>(n))) % n;
        const double length = (chain.points[next] - chain.points[at]).norm();
        if (length >= distance && length > 0) return chain.points[at] + distance / length * (chain.points[next] - chain.points[at]);
        distance -= length;
        at = next;
    }
    return chain.points[at];
}

} // namespace

std::vector<LineChain> split_at_corners(const LineChain& chain, double degrees, double bend, double least) {
    const std::size_t n = chain.points.size();
    std::vector<double> turn(n, 0);
    for (std::size_t i = chain.closed ? 0 : 1; i + (chain.closed ? 0 : 1) < n; ++i) {
        const Vector3d back = chain.points[i] - reached(chain, i, -1, bend), ahead = reached(chain, i, 1, bend) - chain.points[i];
        // An end within a tenth of the bend says nothing about a direction.
        if (back.norm() > 0.1 * bend && ahead.norm() > 0.1 * bend) turn[i] = std::acos(std::clamp(back.normalized().dot(ahead.normalized()), -1.0, 1.0));
    }
    // The sharpest of those within a bend of one another.
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < n; ++i)
        if (turn[i] > degrees * std::numbers::pi / 180) order.push_back(i);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return turn[a] > turn[b]; });
    std::vector<double> up_to(n, 0); // length of the chain before each point
    for (std::size_t i = 1; i < n; ++i) up_to[i] = up_to[i - 1] + (chain.points[i] - chain.points[i - 1]).norm();
    const double whole = chain.length();
    const auto apart = [&](std::size_t a, std::size_t b) {
        const double along = std::abs(up_to[a] - up_to[b]);
        return chain.closed ? std::min(along, whole - along) : along;
    };
    std::vector<std::size_t> corners;
    for (const std::size_t i : order) {
        if (!chain.closed && std::min(up_to[i], whole - up_to[i]) < least) continue;
        if (std::none_of(corners.begin(), corners.end(), [&](std::size_t c) { return (chain.points[c] - chain.points[i]).norm() < bend || apart(c, i) < least; })) corners.push_back(i);
    }
    if (corners.empty()) return {chain};
    std::sort(corners.begin(), corners.end());
    std::vector<LineChain> parts;
    const auto cut = [&](std::size_t from, std::size_t to) { // both included; past the end of a closed chain it goes on at its start
        LineChain part;
        for (std::size_t i = from; i <= to; ++i) {
            part.points.push_back(chain.points[i % n]);
            part.triangles.push_back(chain.triangles[i % n]);
            part.weights.push_back(chain.weights[i % n]);
            part.values.push_back(chain.values[i % n]);
        }
        if (part.points.size() > 1) parts.push_back(std::move(part));
    };
    if (!chain.closed) cut(0, corners.front());
    for (std::size_t c = 0; c + 1 < corners.size(); ++c) cut(corners[c], corners[c + 1]);
    if (chain.closed) cut(corners.back(), corners.front() + n);
    else cut(corners.back(), n - 1);
    return parts;
}

} // namespace lissom
