#pragma once

#include "lissom/mesh/types.h"

#include <vector>

namespace lissom {

/// Two skins of one connectivity: vertex i of one belongs to vertex i of the other.
struct SkinPair {
    Triangles triangles;
    Points source, target;
    std::vector<int> marker; ///< per vertex the marker that it is, or −1: never moved, never taken away

    [[nodiscard]] int vertex_count() const { return static_cast<int>(source.rows()); }
    [[nodiscard]] TriangleMesh source_mesh() const { return {source, triangles}; }
    [[nodiscard]] TriangleMesh target_mesh() const { return {target, triangles}; }
};

struct ConnectivityOptions {
    double edge_length = 0.02;  ///< L, in the unit of both
    double share = 0.3;         ///< of the edges that are too long or too short, the worst ones, in one pass
    int most_vertices = 100000; ///< no splits beyond
};

struct ConnectivityChange {
    int splits = 0, collapses = 0, swaps = 0;
    [[nodiscard]] bool any() const { return splits + collapses + swaps > 0; }
};

/// One pass over the edges of both skins at once (Skins 3.3): splits where an edge is longer than 1.5 L on either (Criterion 1), collapses where it is shorter than
/// 0.5 L on both (Criterion 2), swaps where that makes the largest of the four angles that face the edge smaller (Criterion 3).
///
/// What the paper leaves out: a collapse must keep the surface what it is (the ends have no neighbours in common but those of the edge's triangles); neither
/// a collapse nor a swap may turn a triangle over on either skin, or a collapse make an edge that would be split again; borders stay where they are, edges between two of their
/// vertices that do not lie along them are not collapsed; markers stay, and where one end of a collapsed edge is one the other goes. Edges that are not of
/// exactly one or two triangles which agree are left alone.
/// New vertices come last, those taken away close up. Deterministic: ties fall to the smaller vertex.
/// Cost: sorting the edges.
ConnectivityChange improve_connectivity(SkinPair& skins, const ConnectivityOptions& options);

/// Moves every vertex a `share` of the way to the mean of its ring within its tangent plane, on a border along it: on both skins by the *same* weights, so
/// that what belongs together stays together to first order. Markers stay.
void relax_tangentially(SkinPair& skins, double share = 0.3);

} // namespace lissom
