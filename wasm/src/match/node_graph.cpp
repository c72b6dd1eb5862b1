#include "lissom/match/node_graph.h"

#include "lissom/mesh/chance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>
#include <queue>
#include <tuple>
#include <utility>

namespace lissom {

namespace {

constexpr int k_nearest = 4; // nodes that carry a vertex; the next one tells where their weights end

template <class Entry>
using Queue = std::priority_queue<Entry, std::vector<Entry>, std::greater<>>;

} // namespace

NodeGraph::NodeGraph(const WeightedGraph& graph, double radius, std::uint64_t seed) : radius_(radius) {
    throw_darts(graph, seed);
    bind(graph);
}

void NodeGraph::throw_darts(const WeightedGraph& graph, std::uint64_t seed) {
    const int n = graph.size();
    std::vector<std::uint64_t> draw(static_cast<std::size_t>(n));
    for (int v = 0; v < n; ++v) draw[v] = hash_bits(seed, static_cast<std::uint64_t>(v), 0);
    std::vector<int> order(static_cast<std::size_t>(n));
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](int a, int b) { return std::pair(draw[a], a) < std::pair(draw[b], b); });
    // Distance to the nearest node: a new node only walks where it is nearer than all before it.
    std::vector<double> nearest(static_cast<std::size_t>(n), INFINITY);
    for (const int start : order) {
        if (nearest[start] < radius_) continue;
        nodes_.push_back(start);
        nearest[start] = 0;
        Queue<std::pair<double, int>> open;
        open.emplace(0.0, start);
        while (!open.empty()) {
            const auto [distance, v] = open.top();
            open.pop();
            if (distance > nearest[v]) continue;
            for (int e = graph.offsets[v]; e < graph.offsets[v + 1]; ++e)
                if (const double there = distance + graph.lengths[e]; there < std::min(nearest[graph.ends[e]], radius_)) {
                    nearest[graph.ends[e]] = there;
                    open.emplace(there, graph.ends[e]);
                }
        }
    }
    std::sort(nodes_.begin(), nodes_.end());
}

void NodeGraph::bind(const WeightedGraph& graph) {
    // Dijkstra from all nodes at once, every vertex being reached by the first five of them.
    struct Label {
        int node;
        double distance;
    };
    const int n = graph.size();
    std::vector<std::array<Label, k_nearest + 1>> labels(static_cast<std::size_t>(n));
    std::vector<int> reached(static_cast<std::size_t>(n), 0);
    Queue<std::tuple<double, int, int>> open; // distance, node, vertex
    for (int g = 0; g < count(); ++g) open.emplace(0.0, g, nodes_[g]);
    const auto knows = [&](int v, int node) {
        return std::any_of(labels[v].begin(), labels[v].begin() + reached[v], [&](const Label& label) { return label.node == node; });
    };
    while (!open.empty()) {
        const auto [distance, node, v] = open.top();
        open.pop();
        if (reached[v] > k_nearest || knows(v, node)) continue;
        labels[v][reached[v]++] = {node, distance};
        for (int e = graph.offsets[v]; e < graph.offsets[v + 1]; ++e)
            if (const int w = graph.ends[e]; reached[w] <= k_nearest && std::isfinite(graph.lengths[e]) && !knows(w, node)) open.emplace(distance + graph.lengths[e], node, w);
    }
    for (int v = 0; v < n; ++v) {
        const int carried = std::min(reached[v], k_nearest);
        // Without a fifth the weights end beyond the last there is.
        const double end = reached[v] > k_nearest ? labels[v][k_nearest].distance : 2 * labels[v][carried - 1].distance;
        const std::size_t first = bindings_.size();
        double sum = 0;
        for (int k = 0; k < carried; ++k) {
            const double left = end > 0 ? 1 - labels[v][k].distance / end : 1;
            if (!(left > 0) && k > 0) continue;
            bindings_.push_back({labels[v][k].node, std::max(left * left, 1e-12)});
            sum += bindings_.back().weight;
        }
        for (std::size_t b = first; b < bindings_.size(); ++b) bindings_[b].weight /= sum;
        std::sort(bindings_.begin() + static_cast<std::ptrdiff_t>(first), bindings_.end(), [](const Binding& a, const Binding& b) { return a.node < b.node; });
        offsets_.push_back(static_cast<int>(bindings_.size()));
    }
}

} // namespace lissom
