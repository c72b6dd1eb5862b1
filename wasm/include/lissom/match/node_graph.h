#pragma once

#include "lissom/mesh/surface_paths.h"

#include <cstdint>
#include <span>
#include <vector>

namespace lissom {

/// A few vertices of a surface, its nodes, and by which of them each vertex is carried.
///
/// Distances run along the edges, so that fingers which touch are not mixed up.
/// Cost: nodes and bindings about n log n each.
class NodeGraph {
public:
    struct Binding {
        int node;
        double weight;
    };

    /// Nodes by dart throwing: vertices in an order that the seed decides, each becomes one where none is nearer than `radius`. Every vertex is bound to its four
    /// nearest by w = (1 − d / d₅)², d₅ the distance of the fifth, summing to 1; on a piece of fewer nodes to those it has.
    /// @param graph   of the surface's edges
    /// @param radius  > 0, in its unit
    NodeGraph(const WeightedGraph& graph, double radius, std::uint64_t seed = 0);

    [[nodiscard]] const std::vector<int>& nodes() const { return nodes_; } ///< the vertex that each is
    [[nodiscard]] int count() const { return static_cast<int>(nodes_.size()); }
    [[nodiscard]] double radius() const { return radius_; }
    /// Nodes ascending.
    [[nodiscard]] std::span<const Binding> bindings(int vertex) const {
        return {bindings_.data() + offsets_[vertex], bindings_.data() + offsets_[vertex + 1]};
    }

private:
    void throw_darts(const WeightedGraph& graph, std::uint64_t seed);
    void bind(const WeightedGraph& graph);

    double radius_;
    std::vector<int> nodes_;
    std::vector<int> offsets_{0};
    std::vector<Binding> bindings_;
};

} // namespace lissom
