#pragma once

#include "lissom/merge/part.h"
#include "lissom/merge/plane_map.h"

#include <string>

namespace lissom {

/// The surface between a part's loop and the line at some distance from it (a transition region, Fu 3.3.3).
struct Strip {
    TriangleMesh mesh;
    std::vector<Origin> origin;    ///< per vertex, in vertices of the input
    std::vector<int> part_vertex;  ///< per vertex, of the part it was cut from; −1: it is new
    std::vector<double> distance;  ///< per vertex, from the loop
    std::vector<int> near;         ///< the loop, in the part's direction: the strip to the left
    std::vector<int> far;          ///< the line, in the same sense of turning
    std::vector<int> far_in_rest;  ///< of each, its vertex in what is left of the part
};

/// Distances are shortest paths along edges. The line crosses triangles; it passes through vertices that are near it,
/// so that it leaves no slivers.
/// @param rest  receives what is left: the part without the strip, loop `loop` moved to the line (its first vertex is any)
/// @throws InvalidInput `transition-not-a-ring`  the width is below an edge, or reaches around the part or another opening
[[nodiscard]] Strip cut_strip(const Part& part, int loop, double width, const std::string& name, Part& rest);

/// A strip over the unit square (Fu 3.3.3): cut open along the shortest path across from `start`, u along the loop from
/// there, v from 0 at the loop to 1 at the line.
struct SquareMap {
    Triangles triangles;       ///< of the strip cut open
    std::vector<int> original; ///< strip vertex of each point
    PlanePoints points;
};

/// A place of the loop that is given its u; the line has the same u where the shortest path across from there ends.
struct SquareAnchor {
    int near = -1; ///< vertex of `strip.near`
    double u = 0;  ///< in (0, 1)
};

/// @param start      vertex of `strip.near`
/// @param backwards  u runs against the loop
/// @param anchors    between them u grows by length; those that would make it fall are left out
[[nodiscard]] SquareMap square_map(const Strip& strip, int start, bool backwards, const std::vector<SquareAnchor>& anchors = {});

/// How far round the loop a vertex of it lies from another: a fraction of its length.
[[nodiscard]] double fraction_from(const Strip& strip, int start, bool backwards, int near);

/// The vertex of `far` that the shortest path across from a vertex of `near` ends at.
[[nodiscard]] int across_from(const Strip& strip, int start);

} // namespace lissom
