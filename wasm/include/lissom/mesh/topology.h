#pragma once

#include "lissom/mesh/types.h"

#include <span>
#include <vector>

namespace lissom {

/// For each vertex its neighbours, in one flat array: row i is [begin(i), end(i)), ascending, without i.
/// Built from triangle edges, so non-manifold input is as welcome as any other.
struct VertexRings {
    std::vector<int> offsets;    ///< n+1
    std::vector<int> neighbours; ///< vertex indices

    [[nodiscard]] std::span<const int> operator[](int i) const {
        return {neighbours.data() + offsets[i], neighbours.data() + offsets[i + 1]};
    }
    [[nodiscard]] int vertex_count() const { return static_cast<int>(offsets.size()) - 1; }
};

/// The 1-ring of every vertex. Cost: linear in triangles.
[[nodiscard]] VertexRings vertex_rings(const TriangleMesh& mesh);

/// One undirected edge and how the triangles use it.
struct Edge {
    int a, b;     ///< vertex indices, a < b
    int forward;  ///< triangles that run a → b
    int backward; ///< triangles that run b → a
};

/// Every undirected edge once, ordered by (a, b).
[[nodiscard]] std::vector<Edge> edges(const TriangleMesh& mesh);

/// Component number of each vertex in [0, count), numbered by their smallest vertex.
struct Components {
    std::vector<int> of_vertex;
    int count = 0;
};
[[nodiscard]] Components components(const VertexRings& rings);

/// Closed walks along edges that have one triangle, each in the direction of its triangles (the surface
/// to the left). A vertex where loops touch is split into separate loops. Starts at its smallest vertex;
/// loops are ordered by it. On a one-sided surface the direction is that of the first edge walked. Chains that
/// end on an edge of three triangles close nowhere and are left out.
[[nodiscard]] std::vector<std::vector<int>> boundary_loops(const TriangleMesh& mesh);

/// True for each vertex on an edge with exactly one triangle.
[[nodiscard]] std::vector<bool> boundary_vertices(const TriangleMesh& mesh);

/// V − E + F over the vertices that triangles use.
[[nodiscard]] int euler_characteristic(const TriangleMesh& mesh);

/// Vertices whose triangles form more than one fan (bow ties), ascending.
[[nodiscard]] std::vector<int> non_manifold_vertices(const TriangleMesh& mesh);

} // namespace lissom
