#include "lissom/curve/encoding.h"

#include "refusal.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

using namespace lissom;
using Eigen::AngleAxisd;
using Eigen::Vector3d;

namespace {

Points straight(int count, double length = 4) {
    Points points(count, 3);
    for (int i = 0; i < count; ++i) points.row(i) = Vector3d(0, length * i / (count - 1), 0).transpose();
    return points;
}

EncodedCurve curve(int count = 5, bool held = false) {
    EncodedCurveOptions options;
    options.radius.assign(count, 0.4);
    options.held = held;
    return {straight(count), options};
}

Vector3d moved(const Matrix34& map, const Vector3d& x) { return map.leftCols<3>() * x + map.col(3); }

} // namespace

TEST_CASE("rows of the rest pose are the identity") {
    const EncodedCurve at = curve();
    const CurveRows rows = at.pose(at.at_rest(), {}, CurveGuard::symmetric);
    REQUIRE(rows.affine.size() == EncodedCurve::k_rows);
    for (const Matrix34& map : rows.affine) CHECK((moved(map, {0.3, 1, 0.2}) - Vector3d(0.3, 1, 0.2)).norm() < 1e-14);
    CHECK(rows.bend < 1e-12);
    CHECK(rows.tilt == 0);
}

TEST_CASE("rows of a stretch move each place where the curve moves it, and the ends as they are") {
    const EncodedCurve at = curve();
    CurvePosture posture = at.at_rest();
    posture.points *= 1.7;
    const CurveRows rows = at.pose(posture, {}, CurveGuard::none);
    for (int i = 0; i < EncodedCurve::k_rows; ++i) {
        const double y = 4.0 * i / 255;
        CHECK((moved(rows.affine[i], {0.3, y, 0.1}) - Vector3d(0.3, 1.7 * y, 0.1)).norm() < 1e-9);
    }
    CHECK((moved(rows.affine.back(), {0, 5, 0}) - Vector3d(0, 6.8 + 1, 0)).norm() < 1e-9); // beyond the end nothing is stretched
}

TEST_CASE("the blend along the curve leaves its ends alone") {
    for (const bool held : {false, true}) {
        const EncodedCurve at = curve(5, held);
        CurvePosture posture = at.at_rest();
        posture.points.row(3) += Eigen::RowVector3d(0.5, 0, 0);
        posture.points.row(4) += Eigen::RowVector3d(1.5, -0.5, 0);
        const CurveRows rows = at.pose(posture, {}, CurveGuard::none);
        CHECK((moved(rows.affine.front(), {0, 0, 0}) - Vector3d(0, 0, 0)).norm() < 1e-12);
        CHECK((moved(rows.affine.back(), {0, 4, 0}) - Vector3d(1.5, 3.5, 0)).norm() < 1e-12);
        if (held) CHECK((moved(rows.affine.front(), {1, -2, 3}) - Vector3d(1, -2, 3)).norm() < 1e-12);
    }
}

TEST_CASE("twist and scale fade out towards a held end and reach the other") {
    const EncodedCurve free = curve(), held = curve(5, true);
    CurvePosture posture = free.at_rest();
    posture.twist.assign(5, 90);
    posture.scale.assign(5, {2, 2});
    const double lengths[] = {0, 2, 4};
    const auto at_free = free.across(posture, lengths), at_held = held.across(posture, lengths);
    CHECK(at_free[0].twist == 90);
    CHECK(at_held[0].twist == 0);
    CHECK(at_held[0].scale_v == 1);
    CHECK(at_held[2].twist == 90);
    CHECK(at_held[2].scale_w == 2);
}

TEST_CASE("what is fixed to a place moves rigidly with it") {
    const EncodedCurve at = curve();
    CurvePosture posture;
    posture.points = straight(5);
    for (int i = 0; i < 5; ++i) posture.points(i, 0) = 0.1 * i * i;
    const CurveRows rows = at.pose(posture, {}, CurveGuard::none);
    const Matrix34 map = at.motion_at(rows, posture, 0.5, {0, 2, 0});
    CHECK((map.leftCols<3>().transpose() * map.leftCols<3>() - Eigen::Matrix3d::Identity()).norm() < 1e-12);
    CHECK((moved(map, {0, 2, 0}) - SplineCurve(posture.points).point(0.5)).norm() < 2e-3);
}

TEST_CASE("a bend as tight as the limb is wide is told") {
    const EncodedCurve at = curve(9);
    CurvePosture posture = at.at_rest();
    const double radius = 0.8, angle = 4 / radius;
    for (int i = 0; i < 9; ++i) posture.points.row(i) = radius * Eigen::RowVector3d(1 - std::cos(angle * i / 8), std::sin(angle * i / 8), 0);
    // The spline's own curvature, which is that of the arc but in the two spans at the ends.
    const SplineCurve posed(posture.points);
    double most = 0;
    for (double t = 0; t <= 1; t += 1e-4) most = std::max(most, 0.4 * posed.curvature(t));
    CHECK(0.4 * posed.curvature(0.5) == doctest::Approx(0.4 / 0.8).epsilon(0.1));
    CHECK(at.pose(posture, {}, CurveGuard::none).bend == doctest::Approx(most).epsilon(0.05));
}

TEST_CASE("the change of the row with the place is that of the nearest place") {
    Points points(6, 3);
    for (int i = 0; i < 6; ++i) points.row(i) = Eigen::RowVector3d(2 * std::sin(0.4 * i), 2 * std::cos(0.4 * i), 0.1 * i * i);
    EncodedCurveOptions options;
    options.radius.assign(6, 0.4);
    const EncodedCurve at(points, options);
    const auto row = [&](const Vector3d& x) { return at.row_of(at.curve().nearest(x).t); };
    for (const double r : {20.0, 77.3, 130.6, 201.9})
        for (const double aside : {-0.3, 0.0, 0.4}) {
            const CurveFrame& frame = at.frame_at(r);
            const Vector3d x = frame.origin + aside * frame.axes.col(1) + 0.2 * frame.axes.col(2);
            const Vector3d gradient = at.row_gradient(row(x), x);
            for (int k = 0; k < 3; ++k) {
                const Vector3d step = 1e-4 * Vector3d::Unit(k);
                CHECK(gradient[k] == doctest::Approx((row(x + step) - row(x - step)) / 2e-4).epsilon(0.01).scale(gradient.norm()));
            }
        }
    CHECK(at.row_gradient(0, points.row(0).transpose()).isZero());
    CHECK(at.row_gradient(255, points.row(5).transpose()).isZero());
}

TEST_CASE("a curve or posture that does not fit is refused") {
    const auto made = [](Points rest, std::vector<double> radius) { return refusal([&] { EncodedCurveOptions options; options.radius = radius; (void)EncodedCurve(rest, options); }); };
    CHECK(made(straight(3), {1, 1}) == "curve-radius");
    CHECK(made(straight(3), {1, 0, 1}) == "curve-radius");
    CHECK(made(Points::Zero(3, 3), {1, 1, 1}) == "curve-without-length");
    const EncodedCurve at = curve();
    CurvePosture wrong = at.at_rest();
    wrong.base.coeffs().setZero();
    CHECK(refusal([&] { (void)at.pose(wrong, {}, CurveGuard::none); }) == "non-finite-curve");
}
