#pragma once

#include <Eigen/Core>

namespace lissom {

/// The rotation nearest to M in the Frobenius norm: U Vᵀ of M = U Σ Vᵀ, with the smallest singular direction
/// flipped where that would be a reflection (Fu 2.4.4). The identity for a matrix that is zero.
///
/// Closed form but for one scalar: with λ = σ₁ + σ₂ ± σ₃, the largest root of
/// (λ² − ‖M‖²)² − 8 λ det M − 4 ‖cof M‖² = 0 (found by Newton from above),
/// R = (λ cof M + ½(λ² + ‖M‖²) M − M Mᵀ M) / ((σ₁+σ₂)(σ₂±σ₃)(σ₁±σ₃)), by Cayley–Hamilton on the stretch.
/// Where that denominator is small the singular value decomposition decides.
///
/// Where several rotations are equally near (σ₂ = ∓σ₃) one of them is returned, always the same.
[[nodiscard]] Eigen::Matrix3d nearest_rotation(const Eigen::Matrix3d& M);

/// √((σ₁² + σ₂² + σ₃²)/3), the uniform scale of Eq 2.11: no decomposition needed, for Σσ² = ‖M‖².
[[nodiscard]] inline double uniform_scale(const Eigen::Matrix3d& M) {
    return M.norm() / 1.7320508075688772;
}

} // namespace lissom
