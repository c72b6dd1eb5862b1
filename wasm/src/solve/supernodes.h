#pragma once

#include "elimination_tree.h"

#include <cstddef>
#include <vector>

namespace lissom::solve {

/// Columns of L with (nearly) equal rows, gathered into dense panels, in the order they are factored.
///
/// Supernode s has columns [first[s], first[s+1]) and, below them, rows(s). Explicit zeros are allowed where
/// merging a child into its parent costs less than handling both ("relaxed amalgamation": Ashcraft & Grimes,
/// "The influence of relaxed supernode partitions on the multifrontal method", ACM TOMS 15(4), 1989).
struct Supernodes {
    std::vector<int> order;   ///< order[k] is the node of column k
    std::vector<int> inverse; ///< inverse[order[k]] = k
    std::vector<int> first;   ///< count+1
    std::vector<int> parent;  ///< supernode, > s; −1 at a root
    std::vector<int> depth;   ///< 0 at a root
    std::vector<int> first_descendant; ///< the subtree of s is [first_descendant[s], s]: a postorder
    std::vector<int> rows;    ///< columns of L below the supernode's own, ascending
    std::vector<int> place;   ///< beside `rows`: where that row lies in the parent's front
    std::vector<std::size_t> row_offsets; ///< count+1

    [[nodiscard]] int count() const { return static_cast<int>(parent.size()); }
    [[nodiscard]] int width(int s) const { return first[s + 1] - first[s]; }
    [[nodiscard]] int height(int s) const { return static_cast<int>(row_offsets[s + 1] - row_offsets[s]); }
    [[nodiscard]] const int* rows_of(int s) const { return rows.data() + row_offsets[s]; }
    [[nodiscard]] const int* places_of(int s) const { return place.data() + row_offsets[s]; }
};

[[nodiscard]] Supernodes supernodes(const Graph& graph, const EliminationTree& tree);

} // namespace lissom::solve
