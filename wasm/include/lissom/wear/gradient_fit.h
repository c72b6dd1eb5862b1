#pragma once

#include "lissom/mesh/types.h"
#include "lissom/solve/sparse_cholesky.h"

#include <Eigen/Geometry>

#include <optional>
#include <vector>

namespace lissom {

/// The surface whose triangles are mapped as wanted, as far as they hang together: displacements u that minimise
///
///     Σ_t A_t |∇u − (F_t − I)|²,      K u = Σ_t A_t ∇ᵀ (F_t − I)
///
/// with K the cotangent stiffness (cotangents of needles bounded as in `cotangent_laplacian`). Each piece of the surface is found but for where it
/// stands; the caller says that by the mean of its displacements.
///
/// Source: Sumner and Popović, "Deformation transfer for triangle meshes", 2004, Eq 6 to 8; that its matrix is K: Botsch et al., "Deformation
/// transfer for detail-preserving surface editing", 2006.
/// Cost: one factor of the surface; a fit is one solve of three columns.
class GradientFit {
public:
    /// Call step() until it returns false. @param mesh  at rest, kept by reference
    explicit GradientFit(const TriangleMesh& mesh);

    /// One slice. @returns true while there is more. @throws SolverFailure
    bool step();
    [[nodiscard]] double fraction() const;

    /// @param maps   F_t, one for each triangle
    /// @param means  n×3 displacements, of which each piece has the mean, by areas of its vertices
    /// @returns      n×3 positions  @throws SolverFailure
    [[nodiscard]] Points fit(const std::vector<Eigen::Matrix3d>& maps, const Points& means) const;

private:
    const TriangleMesh& mesh_;
    Points cotangents_; ///< half of that at each corner
    Eigen::VectorXd areas_;
    std::vector<int> piece_; ///< of each vertex
    int pieces_ = 0;
    std::optional<SparseCholesky> factor_;
    bool done_ = false;
};

} // namespace lissom
