#include "lissom/curve/dual_quaternion.h"

#include <doctest/doctest.h>

using namespace lissom;
using Eigen::AngleAxisd;
using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {
DualQuaternion motion(double angle, const Vector3d& axis, const Vector3d& t) { return {AngleAxisd(angle, axis.normalized()).toRotationMatrix(), t}; }
} // namespace

TEST_CASE("a motion comes back as the matrix it was made of") {
    for (double angle = -3; angle <= 3; angle += 0.37) {
        const Vector3d axis(1, -0.4, 2), t(3, -1, 0.2);
        const Matrix34 map = motion(angle, axis, t).matrix();
        CHECK((map.leftCols<3>() - AngleAxisd(angle, axis.normalized()).toRotationMatrix()).norm() < 1e-14);
        CHECK((map.col(3) - t).norm() < 1e-14);
    }
}

TEST_CASE("blends are rigid, and half way between two turns lies half the turn") {
    DualQuaternion sum = motion(0.4, {0, 0, 1}, {1, 0, 0});
    sum.add(1, motion(1.2, {0, 0, 1}, {0, 2, 0}));
    const Matrix34 map = sum.matrix();
    CHECK((map.leftCols<3>().transpose() * map.leftCols<3>() - Matrix3d::Identity()).norm() < 1e-14);
    CHECK((map.leftCols<3>() - AngleAxisd(0.8, Vector3d::UnitZ()).toRotationMatrix()).norm() < 1e-14);
    // Moves alone blend in a straight line.
    DualQuaternion moves;
    moves.add(3, motion(0, {0, 0, 1}, {4, 0, 8}));
    CHECK((moves.matrix().col(3) - Vector3d(3, 0, 6)).norm() < 1e-14);
}

TEST_CASE("either sign of a quaternion stands for the same motion in a blend") {
    const DualQuaternion a = motion(0.3, {1, 0, 0}, {1, 2, 3});
    DualQuaternion b = motion(0.5, {1, 0, 0}, {1, 0, 3}), c = b, with_b = a, with_c = a;
    c.real *= -1;
    c.dual *= -1;
    with_b.add(1, b);
    with_c.add(1, c);
    CHECK((with_b.matrix() - with_c.matrix()).norm() < 1e-14);
}

TEST_CASE("maps compose from the inside out") {
    const Matrix34 a = motion(0.3, {1, 2, 0}, {1, 2, 3}).matrix(), b = motion(1.5, {0, 0, 1}, {-1, 0, 3}).matrix(), ab = composed(a, b);
    const Vector3d x(0.3, 0.7, -2);
    const Vector3d inner = b.leftCols<3>() * x + b.col(3);
    CHECK((ab.leftCols<3>() * x + ab.col(3) - (a.leftCols<3>() * inner + a.col(3))).norm() < 1e-14);
}
