#pragma once

#include "lissom/match/pull.h"
#include "lissom/solve/sparse_cholesky.h"

#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace lissom {

/// Moves every vertex of a skin towards where it is pulled, its moves being smooth:
///     Σ w |x + d − c|² + μ |L d|², L the difference from the mean of the ring, on a border along it alone.
/// With both terms free of unit and of tessellation, for w has a mean of 1 and L compares neighbours.
///
/// Vertices that are held move exactly as told. What nothing pulls goes along with what is around it.
/// Cost: one factorization over the 2-rings a solve; its pattern is analysed once per connectivity.
class FineFit {
public:
    /// @param mesh  its connectivity, and where it lies for the order of elimination
    explicit FineFit(const TriangleMesh& mesh);

    struct Held {
        int vertex;
        Eigen::Vector3d target;
    };
    /// @param points     where the vertices are
    /// @param stiffness  μ > 0
    /// @returns d, n×3. @throws SolverFailure
    [[nodiscard]] Points solve(const Points& points, std::span<const Pull> pulls, std::span<const Held> held, double stiffness);

private:
    SparseMatrix bilaplacian_; ///< LᵀL, lower triangle, with the edges' places
    SparseMatrix A_;
    SparseCholesky factor_;
};

} // namespace lissom
