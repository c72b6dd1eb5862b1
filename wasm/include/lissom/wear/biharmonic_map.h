#pragma once

#include "lissom/mesh/types.h"

namespace lissom {

/// The map of space that carries some points to others and grows no faster than distance:
/// u(x) = M x + t + Σ λ_i |x − c_i| with Σ λ_i = 0 and Σ λ_i c_iᵀ = 0, the biharmonic spline (Duchon 1977).
///
/// A map that is affine is found as it is; a motion or scale of either side is carried along. Centres that all but coincide are averaged
/// (the diagonal gives way by a millionth of their spread).
/// Cost: dense, n³ once; a point n.
class BiharmonicMap {
public:
    /// @param from,to  n×3, four or more. @throws InvalidInput `too-few-places`  @throws SolverFailure  all of `from` in one plane
    BiharmonicMap(const Points& from, const Points& to);

    [[nodiscard]] Eigen::Vector3d operator()(const Eigen::Vector3d& x) const;

private:
    Points centres_; ///< moved to their middle and divided by `size_`
    Eigen::RowVector3d middle_;
    double size_ = 1;
    Points weights_; ///< λ, then the rows of t and M
};

} // namespace lissom
