#pragma once

#include "lissom/mesh/types.h"

#include <span>
#include <vector>

namespace lissom::solve {

/// The pattern of a symmetric matrix as an undirected graph without loops: node i is joined to
/// [begin(i), end(i)), each neighbour once.
struct Graph {
    std::vector<int> offsets;    ///< n+1
    std::vector<int> neighbours; ///< node indices

    [[nodiscard]] std::span<const int> operator[](int i) const {
        return {neighbours.data() + offsets[i], neighbours.data() + offsets[i + 1]};
    }
    [[nodiscard]] int size() const { return static_cast<int>(offsets.size()) - 1; }
};

/// The entries of the lower triangle in storage order: f(row, column, value).
template <class F>
void for_each_lower(const SparseMatrix& A, const F& f) {
    for (int j = 0; j < A.cols(); ++j)
        for (SparseMatrix::InnerIterator entry(A, j); entry; ++entry)
            if (entry.row() >= j)
                f(static_cast<int>(entry.row()), j, entry.value());
}

/// Both directions of every off-diagonal entry in the lower triangle of `A`, n×n.
[[nodiscard]] Graph graph_of_lower_triangle(const SparseMatrix& A);

} // namespace lissom::solve
