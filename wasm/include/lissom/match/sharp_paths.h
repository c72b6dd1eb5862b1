#pragma once

#include "lissom/mesh/edge_curves.h"
#include "lissom/mesh/types.h"

#include <span>
#include <vector>

namespace lissom {

/// A curve that edges of a skin are to lie on, in the skin's space.
struct SharpLine {
    Points points;       ///< at least two; ends of several lines at exactly the same place are one corner
    bool closed = false;
};
/// The curves of a model as lines.
[[nodiscard]] std::vector<SharpLine> sharp_lines(const Points& points, const std::vector<EdgeCurve>& curves);

/// A vertex that is held, and where.
struct Anchor {
    int vertex;
    Eigen::Vector3d place;
};

struct SharpPathOptions {
    double edge_length = 0.02; ///< L, in the unit of the skin
    double reach = 4;          ///< of L: a path leaves its line no farther
    double stray = 50;         ///< an edge as far off as L costs so much more
    double snap = 0.5;         ///< of L: markers nearer to a line than this are meant to be on it
    int layer = 0;             ///< the number of the model
};

/// Edges of a skin that lie along a line, or along a piece of it: long and closed lines are found piece by piece.
struct SharpPath {
    int line = 0;
    double from = 0, to = 0; ///< lengths along the line at the ends; in a closed one `to` may lie beyond its length
    EdgeCurve curve;         ///< at least two vertices, open
    Points places;           ///< where its vertices belong, on the line
};

struct SharpPaths {
    std::vector<SharpPath> paths;      ///< by line, then along it
    std::vector<int> failed;           ///< lines of which at least a piece found no path, ascending
    std::vector<Anchor> moved_markers; ///< snapped: vertex and its new place

    /// The paths of several models as curves of one mesh, for the editor of its edges. @param fixed  vertices that stay, such as markers
    [[nodiscard]] static EdgeCurves locks(int vertices, std::span<const SharpPaths> of_models, const std::vector<int>& fixed, EdgeCurves::Along along = EdgeCurves::Along::kept);
};

/// Finds for each line the edges of a skin that are to lie on it. The skin lies on the model already, within about an edge's length, its edges anyhow.
///
/// Each corner takes the nearest free vertex. Lines that bend back on themselves are cut, closed ones into four pieces first. Then, short pieces before long ones, the shortest
/// way along edges between the ends, at a cost of |e| (1 + stray (d/L)²) with d the distance from the piece, through no vertex that another path or a marker has. Markers
/// near a line are moved onto it and paths go through them. Places on the line are half those nearest to the vertices, made to go one way, and
/// half spread as the path's edges are long; where a line has a kink of more than 10 degrees, the nearest vertex goes there.
///
/// For n skins of one connectivity each model has paths of its own on the skin over it, and vertices that are held there alone; a path is the same edges in all
/// (`locks`). Paths of different models may share vertices and edges.
///
/// Source: Wang et al. (004), 3.4. Changed: the paper looks for a list of edges for each sharp edge, two particles to an edge; where a model is
/// finer than the skin there are not enough. So whole curves are looked for.
/// Limits: a line that is shorter than L, or that runs nearer than L to another, may find none: it is told.
/// Cost: a search in the strip around each piece, and a tree of places for the corners.
/// @param markers  vertices that are held, with their places
[[nodiscard]] SharpPaths find_sharp_paths(const TriangleMesh& skin, const std::vector<SharpLine>& lines, const std::vector<Anchor>& markers, const SharpPathOptions& options);

/// The places of a path's vertices between two lengths along a line, anew: after edges have been split or collapsed along it, or the skin has moved.
[[nodiscard]] Points places_along(const Points& skin, const std::vector<int>& path, const SharpLine& line, double from, double to);

/// Every vertex of the paths once, with its place.
[[nodiscard]] std::vector<Anchor> anchors_of(const std::vector<SharpPath>& paths);

} // namespace lissom
