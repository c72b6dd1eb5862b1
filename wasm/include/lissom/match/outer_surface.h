#pragma once

#include "lissom/mesh/types.h"

#include <array>
#include <memory>
#include <vector>

namespace lissom {

/// What of a model is seen from outside, where its pieces reach into one another.
struct OuterSurface {
    TriangleMesh mesh;                            ///< the model, its triangles cut small where they cross others; the model's vertices first
    std::vector<char> hidden = {};                ///< per triangle: it lies inside of the model
    std::vector<int> leader = {};                 ///< per vertex of the model the one that stands for it; empty: all for themselves. Corners of a soup are welded
    std::vector<std::array<int, 2>> between = {}; ///< of each vertex that the model has not: the ends of the edge that it is the middle of
    double hidden_share = 0;                      ///< of the area

    [[nodiscard]] bool hides() const { return hidden_share > 0; }
    /// The triangles that are not hidden, of all vertices.
    [[nodiscard]] TriangleMesh seen() const;
    /// Flags of the model's vertices on those of the mesh; middles have what both ends have.
    [[nodiscard]] std::vector<char> carried(const std::vector<char>& flags) const;
    /// A chain of the model's edges along the mesh's, but for what is hidden: pieces of it.
    [[nodiscard]] std::vector<std::vector<int>> along(const std::vector<int>& chain) const;
};

/// Whether so many edges have one triangle only, a quarter, that how they hang together means nothing.
[[nodiscard]] bool is_soup(const TriangleMesh& mesh);

struct OuterSurfaceOptions {
    int cells = 64; ///< of the grid along the longest side of the box, 20 to 400
};

/// Tells the outer surface of a model made of pieces that overlap, closed or not, from what is inside: the inner parts are no surface that anything should be fitted to or measured from.
///
/// Triangles that cross others are bisected at their longest edges, with their neighbours, until no edge of theirs is longer than 0.15 cells. What hangs together between the crossings is
/// wholly outside or wholly inside. Outside is what sees, past all other triangles, a node of a grid that is reached from far away (`FloodGrid`, at its smallest sound radius): so neither closed pieces nor
/// consistent facing is needed, and holes do not matter as long as the flood does not run through them. Corners of a soup within a fiftieth of the mean edge are welded first.
///
/// Limits: gaps narrower than twice that radius, some 3 cells, hide what is seen only through them; what hangs together is hidden only with a quarter of it or less seen. Of a soup that welding
/// does not close nothing is told to be hidden.
/// Source: ours. Bisection: Rivara, "Algorithms for refining triangular grids suitable for adaptive and multigrid techniques", Int. J. Numer. Methods Eng. 20, 1984.
/// Cost: the grid's distances, about a second, and exact crossings of what still crosses, once for each halving.
class OuterSurfaceFinder {
public:
    /// @throws InvalidInput `flat-model`, `bad-option`
    explicit OuterSurfaceFinder(const TriangleMesh& model, const OuterSurfaceOptions& options = {});
    ~OuterSurfaceFinder();
    OuterSurfaceFinder(OuterSurfaceFinder&&) noexcept;

    /// One slice. @returns true while there is more
    bool step();
    [[nodiscard]] const OuterSurface& result() const; ///< after the last step

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// All slices at once.
[[nodiscard]] OuterSurface outer_surface(const TriangleMesh& model, const OuterSurfaceOptions& options = {});

} // namespace lissom
