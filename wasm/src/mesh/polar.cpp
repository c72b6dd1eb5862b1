#include "lissom/mesh/polar.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/SVD>

#include <cmath>

namespace lissom {
namespace {

using Eigen::Matrix3d;

/// Of a matrix with ‖A‖² = 3, for which a rotation gives 8. The closed form's error grows like 1e-16 / denominator²,
/// so that here six digits are gone; below, the decomposition is worth its time.
constexpr double k_least_denominator = 1e-3;

Matrix3d cofactors(const Matrix3d& M) {
    Matrix3d C;
    C.col(0) = M.col(1).cross(M.col(2));
    C.col(1) = M.col(2).cross(M.col(0));
    C.col(2) = M.col(0).cross(M.col(1));
    return C;
}

Matrix3d rotation_by_svd(const Matrix3d& M) {
    const Eigen::JacobiSVD<Matrix3d> svd(M, Eigen::ComputeFullU | Eigen::ComputeFullV);
    Matrix3d U = svd.matrixU();
    const Matrix3d& V = svd.matrixV();
    if ((U * V.transpose()).determinant() < 0) U.col(2) *= -1; // singular values fall: column 2 is the smallest
    return U * V.transpose();
}

} // namespace

Matrix3d nearest_rotation(const Matrix3d& M) {
    const double size = M.norm();
    if (!(size > 1e-150)) return Matrix3d::Identity();
    // Scaled to ‖A‖² = 3 so that a rotation has λ = 3 exactly, and nothing over- or underflows.
    const Matrix3d A = M * (1.7320508075688772 / size);
    const double F = A.squaredNorm();
    const Matrix3d C = cofactors(A);
    const double det = A.col(0).dot(C.col(0));
    const double cof2 = 4 * C.squaredNorm();

    double lambda = std::sqrt(3 * F); // σ₁+σ₂+σ₃ ≤ √3 ‖A‖: Newton falls monotonically from here
    for (int k = 0; k < 30; ++k) {
        const double g = lambda * lambda - F;
        const double f = g * g - 8 * lambda * det - cof2;
        const double slope = 4 * lambda * g - 8 * det;
        if (!(slope > 0)) break;
        const double step = f / slope;
        lambda -= step;
        if (std::abs(step) <= 1e-13 * lambda) break;
    }

    const double i2 = 0.5 * (lambda * lambda - F);
    const double denominator = lambda * i2 - det; // (σ₁+σ₂)(σ₂±σ₃)(σ₁±σ₃)
    if (!(denominator > k_least_denominator)) return rotation_by_svd(A);
    Matrix3d R = lambda * C + (lambda * lambda - i2) * A;
    R.noalias() -= A * (A.transpose() * A);
    R /= denominator;
    // One Newton–Schulz step restores the digits that a small denominator cost.
    const Matrix3d polished = 0.5 * (R * (3 * Matrix3d::Identity() - R.transpose() * R));
    return polished;
}

} // namespace lissom
