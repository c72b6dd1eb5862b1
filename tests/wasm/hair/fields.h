#pragma once

// What tests of the field solvers share: demands without any order, and the operator as a sparse matrix.

#include "lissom/hair/field_solver.h"
#include "lissom/mesh/chance.h"

#include <vector>

namespace fields {

/// As many constraints, each at a node of its own, their vectors in [−½, ½]³. The first of more are the same.
[[nodiscard]] inline std::vector<lissom::FieldConstraint> some_constraints(int nodes, int count, std::uint64_t seed) {
    std::vector<lissom::FieldConstraint> out;
    std::vector<char> taken(static_cast<std::size_t>(nodes), 0);
    for (std::uint64_t i = 0; static_cast<int>(out.size()) < count; ++i) {
        const int node = static_cast<int>(lissom::chance(seed, i, 0) * nodes);
        if (taken[static_cast<std::size_t>(node)]++) continue;
        out.push_back({node, {lissom::chance(seed, i, 1) - 0.5, lissom::chance(seed, i, 2) - 0.5, lissom::chance(seed, i, 3) - 0.5}});
    }
    return out;
}

/// Δ of a grid, entry by entry.
[[nodiscard]] inline lissom::SparseMatrix grid_laplacian(const lissom::Grid& grid) {
    std::vector<Eigen::Triplet<double>> entries;
    for (int node = 0; node < grid.count(); ++node) {
        const Eigen::Vector3i at = grid.cell(node);
        for (int d = 0; d < 3; ++d) {
            if (at[d] + 1 == grid.size[d]) continue;
            Eigen::Vector3i next = at;
            ++next[d];
            const int other = grid.node(next[0], next[1], next[2]);
            entries.insert(entries.end(), {{node, node, -1 / 6.0}, {other, other, -1 / 6.0}, {node, other, 1 / 6.0}, {other, node, 1 / 6.0}});
        }
    }
    lissom::SparseMatrix L(grid.count(), grid.count());
    L.setFromTriplets(entries.begin(), entries.end());
    return L;
}

/// How far apart two fields are, relative to the second.
[[nodiscard]] inline double gap(const lissom::Points& a, const lissom::Points& b) { return (a - b).norm() / b.norm(); }

} // namespace fields
