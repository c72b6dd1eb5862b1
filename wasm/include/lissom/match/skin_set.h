#pragma once

#include "lissom/mesh/edge_curves.h"
#include "lissom/mesh/types.h"

#include <optional>
#include <vector>

namespace lissom {

/// Skins of one connectivity, one over each of some models: vertex i of one belongs to vertex i of every other.
struct SkinSet {
    Triangles triangles;
    std::vector<Points> points; ///< of each skin; the source's first
    std::vector<int> marker;    ///< per vertex the marker that it is, or −1: never moved, never taken away
    std::optional<EdgeCurves> curves = {}; ///< of the source's sharp edges, its vertices those of the skins: edits keep them (Criteria 4 to 8), and on the source's skin they do not move

    [[nodiscard]] int vertex_count() const { return static_cast<int>(marker.size()); }
    [[nodiscard]] int count() const { return static_cast<int>(points.size()); }
    [[nodiscard]] TriangleMesh mesh(int skin) const { return {points[static_cast<std::size_t>(skin)], triangles}; }
};

struct ConnectivityOptions {
    double edge_length = 0.02;  ///< L, in the unit of all
    double share = 0.3;         ///< of the edges that are too long or too short, the worst ones, in one pass
    int most_vertices = 100000; ///< no splits beyond
    double adapt = 0;           ///< 0: L is the same everywhere; 1: by `length_factors`; between: that power of them
};

struct ConnectivityChange {
    int splits = 0, collapses = 0, swaps = 0;
    [[nodiscard]] int sum() const { return splits + collapses + swaps; }
    [[nodiscard]] bool any() const { return sum() > 0; }
    ConnectivityChange& operator+=(const ConnectivityChange& more);
};

/// How long edges at each vertex should be for the skins to be equally near to their models everywhere: √(κ̄/κ), between 1/3 and 2, κ the largest curvature on any skin
/// (normals turn by so much a length, evened out over two rings) and κ̄ its mean over the area, so that about as many vertices do.
[[nodiscard]] std::vector<double> length_factors(const SkinSet& skins);

/// One pass over the edges of all skins at once (Skins 3.3): splits where an edge is longer than 1.5 L on any (Criterion 1), collapses where it is shorter than
/// 0.5 L on all (Criterion 2), swaps where that makes the largest of all angles that face the edge smaller (Criterion 3).
///
/// What the paper leaves out: a collapse must keep the surface what it is (the ends have no neighbours in common but those of the edge's triangles); neither
/// a collapse nor a swap may turn a triangle over on any skin, or a collapse make an edge that would be split again; borders stay where they are, edges between two of their
/// vertices that do not lie along them are not collapsed; markers stay, and where one end of a collapsed edge is one the other goes. Edges that are not of
/// exactly one or two triangles which agree are left alone.
/// New vertices come last, those taken away close up. Deterministic: ties fall to the smaller vertex.
/// Cost: sorting the edges.
ConnectivityChange improve_connectivity(SkinSet& skins, const ConnectivityOptions& options);

/// Where the vertices of one skin go that each move a `share` of the way to the mean of their ring within their tangent plane, on a border along it; markers stay, and on the source's skin its sharp curves.
/// The weights are the *same* on every skin, so that what belongs together stays together to first order.
[[nodiscard]] Points relaxed_tangentially(const SkinSet& skins, int skin, double share = 0.3);

} // namespace lissom
