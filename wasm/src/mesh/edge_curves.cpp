#include "lissom/mesh/edge_curves.h"

#include "lissom/mesh/errors.h"

#include <algorithm>
#include <string>

namespace lissom {

std::vector<EdgeCurve> chained(int vertices, std::vector<std::pair<int, int>> edges, const std::vector<char>& corners) {
    std::vector<std::vector<std::pair<int, int>>> next(static_cast<std::size_t>(vertices)); // neighbour, edge
    for (auto& [a, b] : edges)
        if (a > b) std::swap(a, b);
    std::sort(edges.begin(), edges.end());
    for (std::size_t e = 0; e < edges.size(); ++e) {
        next[edges[e].first].emplace_back(edges[e].second, static_cast<int>(e));
        next[edges[e].second].emplace_back(edges[e].first, static_cast<int>(e));
    }
    std::vector<char> walked(edges.size(), 0);
    const auto is_corner = [&](int v) { return next[v].size() != 2 || (!corners.empty() && corners[v]); };
    std::vector<EdgeCurve> curves;
    const auto walk = [&](int from, int to, int edge) {
        EdgeCurve curve{{from}};
        for (;;) {
            walked[edge] = 1;
            if (to == from) {
                curve.closed = true;
                break;
            }
            curve.vertices.push_back(to);
            if (is_corner(to)) break;
            const auto& [other, on] = next[to][next[to][0].second == edge ? 1 : 0];
            to = other;
            edge = on;
        }
        curves.push_back(std::move(curve));
    };
    for (const bool loops : {false, true})
        for (int v = 0; v < vertices; ++v)
            if (loops || is_corner(v))
                for (const auto& [to, edge] : next[v])
                    if (!walked[edge]) walk(v, to, edge);
    return curves;
}

std::uint64_t EdgeCurves::key(int a, int b) {
    return static_cast<std::uint64_t>(static_cast<std::uint32_t>(std::min(a, b))) << 32 | static_cast<std::uint32_t>(std::max(a, b));
}

void EdgeCurves::count_edge(int a, int b, int by) {
    int& count = edges_[key(a, b)];
    count += by;
    if (count == 0) edges_.erase(key(a, b));
}

EdgeCurves::EdgeCurves(int vertices, std::vector<EdgeCurve> curves, const std::vector<int>& fixed, Along along)
    : curves_(std::move(curves)), through_(static_cast<std::size_t>(vertices)), corner_(static_cast<std::size_t>(vertices), 0), fixed_(static_cast<std::size_t>(vertices), 0), along_(along) {
    const auto refuse = [](std::size_t k, const std::string& why) { throw InvalidInput("bad-curve", "Curve " + std::to_string(k) + " " + why + "."); };
    for (std::size_t k = 0; k < curves_.size(); ++k) {
        const EdgeCurve& curve = curves_[k];
        if (curve.vertices.size() < (curve.closed ? 3u : 2u)) refuse(k, "has too few vertices");
        for (const int v : curve.vertices) {
            if (v < 0 || v >= vertices) refuse(k, "has vertex " + std::to_string(v) + ", which the mesh has not");
            if (!through_[v].empty() && through_[v].back() == static_cast<int>(k)) refuse(k, "goes through vertex " + std::to_string(v) + " twice");
            for (const int other : through_[v])
                if (curves_[other].layer == curve.layer) corner_[v] = 1;
            through_[v].push_back(static_cast<int>(k));
        }
        if (!curve.closed) corner_[curve.vertices.front()] = corner_[curve.vertices.back()] = 1;
        for (std::size_t i = 0; i + 1 < curve.vertices.size(); ++i) count_edge(curve.vertices[i], curve.vertices[i + 1], 1);
        if (curve.closed) count_edge(curve.vertices.back(), curve.vertices.front(), 1);
    }
    for (const int v : fixed) {
        if (v < 0 || v >= vertices) throw InvalidInput("bad-curve", "Vertex " + std::to_string(v) + " is to be kept, which the mesh has not.");
        fixed_[v] = 1;
    }
}

/// Whether a vertex of a curve may give way to a neighbour on it: every curve through it runs on to that neighbour and stays one.
bool EdgeCurves::may_go(int taken, int kept) const {
    if (is_corner(taken)) return false;
    for (const int k : through_[taken]) {
        const EdgeCurve& curve = curves_[k];
        if (curve.vertices.size() <= (curve.closed ? 3u : 2u)) return false;
        if (!std::binary_search(through_[kept].begin(), through_[kept].end(), k)) return false;
        const auto at = std::find(curve.vertices.begin(), curve.vertices.end(), taken) - curve.vertices.begin();
        const auto n = std::ssize(curve.vertices);
        const bool beside = curve.vertices[static_cast<std::size_t>((at + 1) % n)] == kept || curve.vertices[static_cast<std::size_t>((at + n - 1) % n)] == kept;
        if (!beside) return false;
    }
    return true;
}

EdgeCurves::Collapse EdgeCurves::may_collapse(int a, int b) const {
    const bool tied_a = tied(a), tied_b = tied(b);
    if (!tied_a && !tied_b) return {};
    if (tied_a != tied_b) return {true, tied_a ? a : b}; // Criterion 7
    if (along_ == Along::edited && has_edge(a, b)) {
        if (may_go(b, a)) return {true, a};
        if (may_go(a, b)) return {true, b};
    }
    return {false, -1}; // Criterion 6
}

void EdgeCurves::split(int a, int b, int middle) {
    if (const auto most = static_cast<std::size_t>(middle) + 1; through_.size() < most) {
        through_.resize(most);
        corner_.resize(most, 0);
        fixed_.resize(most, 0);
    }
    if (!has_edge(a, b)) return;
    for (const int k : std::vector<int>(through_[a])) {
        EdgeCurve& curve = curves_[k];
        const auto n = static_cast<std::ptrdiff_t>(curve.vertices.size());
        const auto at = std::find(curve.vertices.begin(), curve.vertices.end(), a) - curve.vertices.begin();
        std::ptrdiff_t before = -1; // the new vertex goes in front of this one
        if ((at + 1 < n || curve.closed) && curve.vertices[static_cast<std::size_t>((at + 1) % n)] == b) before = at + 1;
        else if ((at > 0 || curve.closed) && curve.vertices[static_cast<std::size_t>((at + n - 1) % n)] == b) before = at > 0 ? at : n;
        if (before < 0) continue;
        curve.vertices.insert(curve.vertices.begin() + before, middle);
        through_[middle].push_back(k);
        count_edge(a, b, -1);
        count_edge(a, middle, 1);
        count_edge(middle, b, 1);
    }
}

void EdgeCurves::collapse([[maybe_unused]] int kept, int taken) {
    for (const int k : through_[taken]) { // along a curve: nothing else lets go of a tied vertex
        EdgeCurve& curve = curves_[k];
        const auto n = static_cast<std::ptrdiff_t>(curve.vertices.size());
        const auto at = std::find(curve.vertices.begin(), curve.vertices.end(), taken) - curve.vertices.begin();
        const int next = curve.vertices[static_cast<std::size_t>((at + 1) % n)], last = curve.vertices[static_cast<std::size_t>((at + n - 1) % n)];
        count_edge(taken, next, -1);
        count_edge(taken, last, -1);
        count_edge(next, last, 1);
        curve.vertices.erase(curve.vertices.begin() + at);
    }
    through_[taken].clear();
}

void EdgeCurves::renumber(const std::vector<int>& place, int count) {
    std::vector<EdgeCurve> curves = std::move(curves_);
    for (EdgeCurve& curve : curves)
        for (int& v : curve.vertices) v = place[v];
    std::vector<int> fixed;
    for (std::size_t v = 0; v < fixed_.size(); ++v)
        if (fixed_[v]) fixed.push_back(place[v]);
    *this = EdgeCurves(count, std::move(curves), fixed, along_);
}

} // namespace lissom
