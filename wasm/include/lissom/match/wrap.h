#pragma once

#include "lissom/mesh/types.h"

#include <memory>
#include <vector>

namespace lissom {

struct WrapOptions {
    int genus = 0;          ///< tunnels that the wrap should have
    double edge_length = 0; ///< of the wrap, in the unit of the model; 0: so that it has about 10,000 vertices
    int cells = 180;        ///< of the grid along the longest side of the box, 20 to 400; fewer where the surface is large for its box
};

/// A closed surface around a model, and how it came about.
struct Wrapped {
    TriangleMesh mesh;          ///< one piece, facing outward
    double radius = 0;          ///< r: its distance from the model
    int genus = 0;              ///< of the mesh
    bool genus_missed = false;  ///< no radius had the genus asked for; the nearest was taken
    int left_out = 0;           ///< smaller pieces that are not in it
    int webs = 0;               ///< vertices between parts of the model that lie on different sides of them: gaps little narrower than 2 r, armpits; much narrower ones look like gaps between samples
    std::vector<int> web_examples; ///< at most 8 of them
};

/// Scattered points as triangles (i, i, i), which is how they are wrapped.
[[nodiscard]] TriangleMesh as_triangles(const Points& points);

/// A closed surface around polygon soups, meshes with holes and scattered points: all places at distance r that are reached from outside.
///
/// The unsigned distance is asked on a grid, all nodes farther than r are flooded from the box's border, and the border of what is reached is cut out of tetrahedra. Neither
/// the model's connectivity nor which way its faces face matters, only how near to one another places of it lie. r begins at 0.8 of the 95 % quantile of
/// the distances between samples and their sixth neighbours, at least 1.5 cells, and is raised by fifths up to three times that: radii at which the flood runs inside,
/// told by a fill that jumps as the radius goes on, are no candidates; of the others the smallest that gives the genus is taken.
/// Then it is meshed anew (`remesh`). It lies r outside: `SkinSettling` brings it onto the model.
///
/// Where it fails: gaps narrower than 2 r close over, and a tunnel narrower than that is none; holes wider than 2 r let the flood in, and what comes back is a
/// shell with two sides; noise more than about r apart gives bubbles: `denoised` first.
///
/// Source: ours; the use of first skins around any model is Wang et al. (004), 3.1, who take a box. Tetrahedra: Doi and Koide, "An efficient method of triangulating
/// equi-valued surfaces by using tetrahedral cells", IEICE Trans. E74(1), 1991, their cases derived here.
/// Cost: some 10⁵ nearest places, then each radius linear in the grid; slices of 0.1 to 0.3 s, some 3 s in all.
class Wrapper {
public:
    /// @param model  kept by reference; triangles may be single points
    /// @throws InvalidInput `bad-option`, `flat-model` (fewer than two places)
    Wrapper(const TriangleMesh& model, const WrapOptions& options);
    ~Wrapper();
    Wrapper(Wrapper&&) noexcept;

    /// One slice. @returns true while there is more
    bool step();
    [[nodiscard]] double fraction() const;
    [[nodiscard]] const Wrapped& result() const; ///< after the last step

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// All slices at once.
[[nodiscard]] Wrapped wrap(const TriangleMesh& model, const WrapOptions& options = {});

} // namespace lissom
