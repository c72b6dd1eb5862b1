#include "lissom/curve/frames.h"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

using namespace lissom;
using Eigen::AngleAxisd;
using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

namespace {

constexpr double k_degrees = 57.29577951308232;

Points random_controls(unsigned seed, int count) {
    std::mt19937 draw(seed);
    std::normal_distribution<double> normal;
    Points points(count, 3);
    for (int i = 0; i < count; ++i) points.row(i) = Vector3d(normal(draw), normal(draw), normal(draw)).transpose();
    return points;
}

std::vector<double> even(int count) {
    std::vector<double> t;
    for (int k = 0; k < count; ++k) t.push_back(static_cast<double>(k) / (count - 1));
    return t;
}

double angle(const Matrix3d& a, const Matrix3d& b) { return AngleAxisd(Matrix3d(b * a.transpose())).angle() * k_degrees; }
double angle(const Vector3d& a, const Vector3d& b) { return std::atan2(a.cross(b).norm(), a.dot(b)) * k_degrees; }

} // namespace

TEST_CASE("frames are right-handed and turn no more than the curve does") {
    double worst = 0, sharp = 0;
    for (unsigned seed = 1; seed <= 40; ++seed) {
        const SplineCurve curve(random_controls(seed, 7));
        const std::vector<double> t = even(1021);
        for (const bool from_end : {false, true}) {
            const auto frames = frames_along(curve, t, axes_along(curve.tangent(from_end ? 1 : 0)), from_end);
            for (std::size_t k = 0; k < frames.size(); ++k) {
                CHECK(frames[k].axes.determinant() == doctest::Approx(1));
                CHECK((frames[k].axes.col(0) - curve.tangent(t[k])).norm() < 1e-12);
                if (k == 0) continue;
                const double turn = angle(Vector3d(frames[k - 1].axes.col(0)), Vector3d(frames[k].axes.col(0)));
                double& most = turn < 10 ? worst : sharp;
                most = std::max(most, angle(frames[k - 1].axes, frames[k].axes) - turn);
            }
        }
    }
    MESSAGE("frames turn more than the curve by at most " << worst << " degrees; in steps of over 10 degrees " << sharp);
    CHECK(worst < 0.05);
    CHECK(sharp < 0.05);
}

TEST_CASE("frames of few steps agree with those of many") {
    for (unsigned seed = 1; seed <= 10; ++seed) {
        const SplineCurve curve(random_controls(seed, 5));
        const auto some = frames_along(curve, even(201), axes_along(curve.tangent(0))), many = frames_along(curve, even(20001), axes_along(curve.tangent(0)));
        CHECK(angle(some.back().axes, many.back().axes) < 1);
    }
}

TEST_CASE("carried forward and back, frames come home") {
    const SplineCurve curve(random_controls(3, 6));
    const std::vector<double> t = even(1021);
    const auto forward = frames_along(curve, t, axes_along(curve.tangent(0)));
    const auto back = frames_along(curve, t, forward.back().axes, true);
    CHECK(angle(forward.front().axes, back.front().axes) < 1e-6);
}

TEST_CASE("frames of a plane curve keep their normal") {
    Points flat = random_controls(8, 6);
    flat.col(2).setZero();
    const SplineCurve curve(flat);
    Matrix3d first;
    first.col(0) = curve.tangent(0);
    first.col(1) = Vector3d::UnitZ();
    first.col(2) = first.col(0).cross(first.col(1));
    for (const CurveFrame& frame : frames_along(curve, even(500), first)) CHECK((frame.axes.col(1) - Vector3d::UnitZ()).norm() < 1e-12);
}

TEST_CASE("a base rotation carries roll that the points of a straight curve cannot") {
    const Matrix3d rest = axes_along(Vector3d::UnitY());
    for (double roll = -3; roll <= 3; roll += 0.5) {
        const Quaterniond base(AngleAxisd(roll, Vector3d::UnitY()));
        CHECK((posed_axes(rest, Vector3d::UnitY(), base) - base.toRotationMatrix() * rest).norm() < 1e-14);
    }
    const Quaterniond any(AngleAxisd(1.3, Vector3d(1, -2, 0.4).normalized()));
    CHECK((posed_axes(rest, any * Vector3d::UnitY(), any) - any.toRotationMatrix() * rest).norm() < 1e-14);
    CHECK((posed_axes(rest, Vector3d::Zero(), any) - any.toRotationMatrix() * rest).norm() < 1e-14);
}

TEST_CASE("axes stand on any tangent, and points that coincide carry a frame on") {
    for (const Vector3d& u : {Vector3d(0, 1, 0), Vector3d(0, -1, 0), Vector3d(0, 0, 1), Vector3d(1, 0, 0), Vector3d(1, 1, 1)}) {
        const Matrix3d axes = axes_along(u.normalized());
        CHECK((axes.transpose() * axes - Matrix3d::Identity()).norm() < 1e-14);
        CHECK(axes.determinant() == doctest::Approx(1));
    }
    const CurveFrame here{Vector3d(1, 2, 3), axes_along(Vector3d::UnitX())};
    CHECK(transported(here, here.origin, Vector3d::UnitX()).axes.isApprox(here.axes));
    CHECK(transported(here, here.origin, Vector3d::UnitZ()).axes.determinant() == doctest::Approx(1));
    CHECK(transported(here, Vector3d(2, 2, 3), Vector3d::Zero()).axes == here.axes);
    // A step back the way it came.
    CHECK(transported(here, Vector3d(0, 2, 3), -Vector3d::UnitX()).axes.determinant() == doctest::Approx(1));
}
