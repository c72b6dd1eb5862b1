#pragma once

#include "graph.h"

#include <vector>

namespace lissom::solve {

/// What eliminating the nodes of a graph one by one does, known without any value.
///
/// Source: Liu, "The role of elimination trees in sparse factorization", SIAM J. Matrix Anal. Appl. 11(1), 1990;
///         column counts: Gilbert, Ng & Peyton, "An efficient algorithm to compute row and column counts for
///         sparse Cholesky factorization", SIAM J. Matrix Anal. Appl. 15(4), 1994.
struct EliminationTree {
    std::vector<int> order;   ///< order[k] is the node eliminated k-th; a postorder of the tree
    std::vector<int> inverse; ///< inverse[order[k]] = k
    std::vector<int> parent;  ///< of column k, > k; −1 at a root
    std::vector<int> counts;  ///< non-zeros of column k of L, diagonal included
    double work = 0;          ///< multiply-adds of a factorization without explicit zeros
};

/// Analyzes an elimination order. The order is changed to an equivalent one (same fill) that visits every
/// subtree without a break.
[[nodiscard]] EliminationTree elimination_tree(const Graph& graph, std::vector<int> order);

/// Visits the trees of a forest children first, the children of a node in ascending order.
/// @param parent  parent of each node, −1 at roots
[[nodiscard]] std::vector<int> postorder(const std::vector<int>& parent);

} // namespace lissom::solve
