#include "lissom/mesh/polar.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/SVD>

#include <cmath>
#include <random>

using Eigen::Matrix3d;
using Eigen::Vector3d;
using lissom::nearest_rotation;

namespace {

struct Source {
    std::mt19937_64 bits{7};
    double number() { return static_cast<double>(bits() >> 11) * 0x1p-52 - 1; } // [−1, 1)
    Matrix3d matrix() {
        Matrix3d M;
        for (int i = 0; i < 9; ++i) M(i) = number();
        return M;
    }
    Matrix3d rotation() {
        return Eigen::Quaterniond(number(), number(), number(), number()).normalized().toRotationMatrix();
    }
    Matrix3d with_singular_values(const Vector3d& s) { return rotation() * s.asDiagonal() * rotation(); }
};

Matrix3d by_svd(const Matrix3d& M) {
    const Eigen::JacobiSVD<Matrix3d> svd(M, Eigen::ComputeFullU | Eigen::ComputeFullV);
    Matrix3d U = svd.matrixU();
    if ((U * svd.matrixV().transpose()).determinant() < 0) U.col(2) *= -1;
    return U * svd.matrixV().transpose();
}

bool is_rotation(const Matrix3d& R) {
    return (R.transpose() * R - Matrix3d::Identity()).norm() < 1e-12 && R.determinant() > 0;
}

} // namespace

TEST_CASE("the nearest rotation agrees with the singular value decomposition") {
    Source source;
    double worst = 0;
    for (int k = 0; k < 5000; ++k) {
        const Matrix3d M = source.matrix(); // half of them reflect
        const Matrix3d R = nearest_rotation(M);
        REQUIRE(is_rotation(R));
        const Eigen::JacobiSVD<Matrix3d> svd(M);
        const Vector3d s = svd.singularValues();
        const double separation = (s[1] + (M.determinant() < 0 ? -s[2] : s[2])) / s[0];
        worst = std::max(worst, (R - by_svd(M)).norm() * std::min(1.0, separation));
    }
    CHECK(worst < 1e-9);
}

TEST_CASE("near rotations, which is what a drag asks for, come out to the last digits") {
    Source source;
    for (const double noise : {0.0, 1e-12, 1e-6, 1e-2, 0.3})
        for (int k = 0; k < 500; ++k) {
            const Matrix3d M = (0.5 + std::abs(source.number())) * (source.rotation() + noise * source.matrix());
            CHECK((nearest_rotation(M) - by_svd(M)).norm() < 1e-13);
        }
}

TEST_CASE("thin, reflecting and tiny matrices still give the rotation that fits best") {
    Source source;
    const Vector3d shapes[] = {{1, 1, 0}, {1, 0.5, 1e-9}, {1, 1e-3, 1e-3}, {1, 1e-6, 1e-9}, {1, 0.4, -0.3}, {1, 0.9, -0.9 + 1e-7}, {1, 1e-12, 0}};
    for (const Vector3d& s : shapes)
        for (const double size : {1.0, 1e-40, 1e40})
            for (int k = 0; k < 200; ++k) {
                CAPTURE(s.transpose());
                const Matrix3d M = size * source.with_singular_values(s);
                const Matrix3d R = nearest_rotation(M);
                REQUIRE(is_rotation(R));
                // The best rotation maximises tr(Rᵀ M); where several do, any will serve.
                const double best = by_svd(M).cwiseProduct(M).sum();
                CHECK(R.cwiseProduct(M).sum() > best - 1e-9 * std::abs(M.norm()));
            }
}

TEST_CASE("rotations and the zero matrix are met exactly") {
    CHECK(nearest_rotation(Matrix3d::Identity()) == Matrix3d::Identity());
    CHECK(nearest_rotation(Matrix3d::Zero()) == Matrix3d::Identity());
}

TEST_CASE("the uniform scale is the root mean square of the singular values") {
    Source source;
    const Vector3d s(3, 2, 0.5);
    CHECK(lissom::uniform_scale(source.with_singular_values(s)) == doctest::Approx(std::sqrt(s.squaredNorm() / 3)));
}
