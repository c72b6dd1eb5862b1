#pragma once

#include "lissom/mesh/edge_curves.h"
#include "lissom/mesh/types.h"

#include <memory>
#include <vector>

namespace lissom {

struct RemeshOptions {
    double edge_length = 0; ///< in the unit of the mesh; 0: its own mean
    double adapt = 0;       ///< 0: equal everywhere, to 1: by curvature, see `edge_lengths`
    int rounds = 8;         ///< 1 to 40
    int most_vertices = 0;  ///< no splits beyond; 0: eight times what the area asks for
};

struct Remeshed {
    TriangleMesh mesh;
    std::vector<EdgeCurve> curves; ///< the given curves, in their order, as vertices of the mesh
    std::vector<int> fixed;        ///< where each fixed vertex is; −1 for one that no triangle used
    bool full = false;             ///< no more vertices were allowed
};

/// A surface anew in even triangles: edges longer than 4/3 of what they should be are split, those shorter than 4/5 collapsed, others swapped towards six neighbours a
/// vertex and in the last rounds towards the smaller largest angle; vertices are evened out within their tangent planes and brought back to the nearest place of the
/// given surface that faces as they do.
///
/// Curves stay: their corners and the fixed vertices do not move, their other vertices slide along them, one to each kink of
/// more than 10 degrees, no edge is swapped across them. So do borders, with
/// corners where they turn by more than 60 degrees or meet a curve. Vertices at edges of three and more triangles, of two that disagree, and those that hold
/// fans together stay, too.
/// Guarded: no collapse, swap or move turns a triangle by more than some 70 degrees, or folds it onto its neighbour; nothing else is looked at, so that
/// parts thinner than an edge may come to cross: `self_intersections` tells.
///
/// Source: Botsch and Kobbelt, "A remeshing approach to multiresolution modeling", SGP 2004. Changed: curves, lengths by curvature, guards.
/// Independent of scale; deterministic: ties fall to the smaller vertex.
/// Cost: a round sorts the edges and asks for a place per vertex; 100,000 triangles take some 0.1 to 0.3 s a slice, of which a round has four.
class Remesher {
public:
    /// @param curves  along edges of the mesh, of one layer
    /// @param fixed   vertices that stay
    /// @throws InvalidInput `bad-option`, `bad-curve`, `flat-model` (no area)
    Remesher(const TriangleMesh& mesh, const std::vector<EdgeCurve>& curves, const std::vector<int>& fixed, const RemeshOptions& options);
    ~Remesher();
    Remesher(Remesher&&) noexcept;

    /// One slice. @returns true while there is more
    bool step();
    [[nodiscard]] double fraction() const;
    [[nodiscard]] Remeshed result() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// All slices at once.
[[nodiscard]] Remeshed remesh(const TriangleMesh& mesh, const RemeshOptions& options = {}, const std::vector<EdgeCurve>& curves = {}, const std::vector<int>& fixed = {});

} // namespace lissom
