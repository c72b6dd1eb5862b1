#pragma once

#include "lissom/match/node_graph.h"
#include "lissom/match/pull.h"
#include "lissom/solve/sparse_cholesky.h"

#include <optional>
#include <span>
#include <vector>

namespace lissom {

/// Bends a surface at rest as affinely as places that it is pulled to allow, by an affine map at each node of a graph.
///
/// A node g carries x to f_g(x) = A_g (x − g)/r + t_g, a vertex is where its nodes carry it, by their weights. Minimised is
///     N/W Σ w |f(x) − c|² + λ N/E Σ_gh (|f_g(h) − t_h|² + |f_h(g) − t_g|² + |A_g − A_h|²) + 10⁻⁴ λ Σ |A_g − r I|²
/// over pairs g, h of the E that carry a common vertex, with N nodes and W the sum of all w: linear, 4 N unknowns, three right-hand sides.
/// Without |A_g − A_h|² nothing would decide how a node whose neighbours lie in a plane with it stretches across that plane.
/// A piece that nothing pulls stays where it was last.
///
/// Source: as-affine embedded deformation, after Sumner et al. 2007 and Allen et al. 2003; what the paper's own loop (004, Eq 1) does not do: carry limbs and ears along.
/// Cost: one factorization of 4 N a solve; its pattern is analysed once.
class AffineFit {
public:
    /// @param rest   where the surface is at rest, about unit size
    /// @param graph  of the same surface; kept by reference
    /// @param now    where it is, as rest
    AffineFit(Points rest, const Triangles& triangles, const NodeGraph& graph, const Points& now);

    /// @param stiffness  λ > 0
    /// @returns where all vertices are carried. @throws SolverFailure
    Points solve(std::span<const Pull> pulls, double stiffness);

    /// What the last solve could not avoid: the minimum divided by N, a mean square, in the unit of `rest` squared.
    [[nodiscard]] double energy() const { return energy_; }

private:
    using Basis = Eigen::Vector4d; ///< (x − g)/r and 1, times the weight
    struct Carried {
        int node;
        Basis basis;
    };

    [[nodiscard]] int block(int row, int column) const; ///< row ≥ column
    void set_pattern(const Triangles& triangles);
    void gather(const Pull& pull, std::vector<Carried>& carried) const;
    void write_values();

    Points rest_;
    const NodeGraph& graph_;
    std::vector<Carried> carried_;       ///< of vertices, as the graph's bindings
    std::vector<int> carried_offsets_;
    std::vector<int> columns_, rows_;    ///< blocks of the lower triangle by columns, rows ascending, the diagonal first
    std::vector<std::pair<int, int>> pairs_; ///< of nodes that carry a common vertex
    std::vector<Eigen::Matrix4d> blocks_;
    Columns unknowns_;                   ///< 4N×3: rows of A_gᵀ, then t_gᵀ
    double energy_ = 0;
    SparseMatrix A_;
    std::optional<SparseCholesky> factor_;
};

} // namespace lissom
