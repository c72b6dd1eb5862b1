#pragma once

#include <Eigen/Geometry>

namespace lissom {

using Matrix34 = Eigen::Matrix<double, 3, 4>; ///< an affine map x ↦ A x + b as (A | b)

/// The affine map of two: first `inner`, then `outer`.
[[nodiscard]] inline Matrix34 composed(const Matrix34& outer, const Matrix34& inner) {
    Matrix34 result = outer.leftCols<3>() * inner;
    result.col(3) += outer.col(3);
    return result;
}

/// A rigid motion as a unit dual quaternion, coefficients (x, y, z, w): blends of several are again rigid.
///
/// Source: Kavan, Collins, Žára, O'Sullivan, "Geometric skinning with approximate dual quaternion blending", ACM Trans. Graph. 27(4), 2008.
struct DualQuaternion {
    Eigen::Vector4d real{0, 0, 0, 1};
    Eigen::Vector4d dual{0, 0, 0, 0};

    DualQuaternion() = default;
    /// x ↦ R x + t.
    DualQuaternion(const Eigen::Matrix3d& R, const Eigen::Vector3d& t) {
        const Eigen::Quaterniond q = Eigen::Quaterniond(R).normalized();
        real = q.coeffs();
        dual = 0.5 * (Eigen::Quaterniond(0, t[0], t[1], t[2]) * q).coeffs(); // q_ε = ½ t q
    }

    /// Adds `weight` of another, on the side of this one's hemisphere. Sums need no unit length until they are used.
    void add(double weight, const DualQuaternion& other) {
        const double sided = real.dot(other.real) < 0 ? -weight : weight;
        real += sided * other.real;
        dual += sided * other.dual;
    }

    /// The motion of a sum (Kavan 2008, Alg. 1): lengths are divided out. Requires real ≠ 0.
    [[nodiscard]] Matrix34 matrix() const {
        const double norm = real.norm();
        const Eigen::Vector4d r = real / norm, d = dual / norm;
        Matrix34 result;
        result.leftCols<3>() = Eigen::Quaterniond(r).toRotationMatrix();
        result.col(3) = 2 * (r[3] * d.head<3>() - d[3] * r.head<3>() + r.head<3>().cross(d.head<3>()));
        return result;
    }
};

} // namespace lissom
