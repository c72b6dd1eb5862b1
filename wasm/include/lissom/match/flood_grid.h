#pragma once

#include "lissom/mesh/grid.h"
#include "lissom/mesh/triangle_tree.h"
#include "lissom/mesh/types.h"

#include <vector>

namespace lissom {

/// Refuses numbers of cells but 20 to 400. @throws InvalidInput `bad-option`
void check_cells(int cells);

/// How far the nodes of a grid are from a model, and which of them are outside of it: reached from the border of the grid through places farther than r from the model.
///
/// Neither the model's connectivity nor which way its triangles face matters. Radii begin at 0.8 of the 95 % quantile of the distances between samples and their sixth
/// neighbours, at least 1.5 cells, and go up by fifths to three times that. At a radius that is too small for the model's holes the flood runs inside, which
/// is told by a fill that jumps as the radius goes on: such a radius is not *sound*.
/// Distances are asked only near the model, all others count as out of reach.
/// Source: ours. Cost: some 10⁵ nearest places, then each radius linear in the grid; slices of 0.1 to 0.3 s.
class FloodGrid {
public:
    /// @param model  kept by reference; triangles may be single points. @param cells  along the longest side of the box; fewer where the surface is large for its box
    /// @throws InvalidInput `flat-model` (fewer than two places)
    FloodGrid(const TriangleMesh& model, int cells);
    FloodGrid(const FloodGrid&) = delete;
    FloodGrid& operator=(const FloodGrid&) = delete;

    /// One slice: distances, then how much each radius fills. @returns true while there is more
    bool step();
    [[nodiscard]] double fraction() const;

    [[nodiscard]] const std::vector<double>& radii() const { return radii_; } ///< ascending
    [[nodiscard]] int first_sound() const { return sound_; }                  ///< number of the smallest radius above all that leak; after the last step
    [[nodiscard]] const Grid& grid() const { return grid_; }
    [[nodiscard]] const std::vector<float>& distances() const { return distances_; } ///< of nodes, no more than the largest radius and 1.8 cells
    [[nodiscard]] const TriangleTree& tree() const { return tree_; }

    /// Flags of the nodes that are outside at a radius, found over the edges of the tetrahedra of `iso_surface`.
    [[nodiscard]] std::vector<char> reached(double r) const;

private:
    struct Fill {
        double nodes, faces; ///< not reached; between a node that is and one that is not
    };

    [[nodiscard]] double reach() const { return radii_.back() + 1.8 * grid_.step; }
    void measure(const Points& samples);
    void ask(const Eigen::Vector3i& from, const Eigen::Vector3i& to, int hint);
    void ask_blocks();
    [[nodiscard]] Fill fill_of(const std::vector<char>& reached) const;
    void find_sound();

    TriangleTree tree_;
    double spacing_ = 0; ///< of samples
    Grid grid_;
    std::vector<double> radii_;
    std::vector<float> distances_;
    Eigen::Vector3i blocks_ = Eigen::Vector3i::Zero();
    int block_ = 0;
    std::vector<Fill> fills_;
    int sound_ = 0;
};

} // namespace lissom
