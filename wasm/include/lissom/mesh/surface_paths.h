#pragma once

#include "lissom/mesh/types.h"

#include <limits>
#include <span>
#include <vector>

namespace lissom {

/// An undirected graph with lengths, by rows.
struct WeightedGraph {
    std::vector<int> offsets{0}; ///< n+1
    std::vector<int> ends;
    std::vector<double> lengths; ///< ≥ 0; infinity: no way through

    [[nodiscard]] int size() const { return static_cast<int>(offsets.size()) - 1; }
};

/// The edges of a mesh with their lengths; neighbours ascending.
[[nodiscard]] WeightedGraph edge_graph(const TriangleMesh& mesh);

/// Shortest ways from some starts to every vertex (Dijkstra 1959); ties fall to the smaller vertex.
struct ShortestPaths {
    std::vector<double> distance; ///< infinity where no way leads
    std::vector<int> before;      ///< the vertex before each on its way; −1 at starts and where no way leads

    /// The vertices of the way to `v`, its start first.
    [[nodiscard]] std::vector<int> path_to(int v) const;
};

/// @param limit  vertices farther than this are not looked at
[[nodiscard]] ShortestPaths shortest_paths(const WeightedGraph& graph, std::span<const int> starts,
                                           double limit = std::numeric_limits<double>::infinity());

/// A ring (annulus) cut open along a path from one of its borders to the other: the vertices of the path stand twice.
struct SlitRing {
    TriangleMesh mesh;             ///< first the ring's vertices, then the second copies
    std::vector<int> original;     ///< per vertex here, of the ring
    std::vector<int> left, right;  ///< the two copies of each path vertex; `left` lie to the left of the path
};

/// @param path  vertices, neighbours joined by edges; only its two ends lie on a border
[[nodiscard]] SlitRing slit_ring(const TriangleMesh& ring, const std::vector<int>& path);

/// The shortest path (by edge length) across a ring from one border to the other that touches both only with its ends,
/// from `from` where that is ≥ 0. @returns empty where there is none
[[nodiscard]] std::vector<int> path_across(const TriangleMesh& ring, const std::vector<int>& border, const std::vector<int>& other, int from = -1);

} // namespace lissom
