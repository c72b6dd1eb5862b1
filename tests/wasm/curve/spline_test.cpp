#include "lissom/curve/spline.h"

#include "refusal.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <random>

using namespace lissom;
using Eigen::Vector3d;

namespace {

Points of(std::initializer_list<Vector3d> list) {
    Points points(static_cast<int>(list.size()), 3);
    int i = 0;
    for (const Vector3d& p : list) points.row(i++) = p.transpose();
    return points;
}

Points random_controls(unsigned seed, int count) {
    std::mt19937 draw(seed);
    std::normal_distribution<double> normal;
    Points points(count, 3);
    for (int i = 0; i < count; ++i) points.row(i) = Vector3d(normal(draw), normal(draw), normal(draw) + i).transpose();
    return points;
}

/// Turn of the Catmull–Rom spline with equal knots, the curve that this one is not.
double uniform_turn(const Points& p, int steps) {
    const int n = static_cast<int>(p.rows());
    const auto tangent = [&](int i) -> Vector3d {
        if (i == 0) return (p.row(1) - p.row(0)).transpose();
        if (i == n - 1) return (p.row(n - 1) - p.row(n - 2)).transpose();
        return (p.row(i + 1) - p.row(i - 1)).transpose() / 2;
    };
    double sum = 0;
    Vector3d last = tangent(0).normalized();
    for (int i = 0; i + 1 < n; ++i)
        for (int k = 1; k <= steps; ++k) {
            const double u = static_cast<double>(k) / steps;
            const Vector3d d = (6 * u * u - 6 * u) * (p.row(i) - p.row(i + 1)).transpose() + (3 * u * u - 4 * u + 1) * tangent(i) + (3 * u * u - 2 * u) * tangent(i + 1);
            const Vector3d here = d.normalized();
            sum += std::atan2(last.cross(here).norm(), last.dot(here));
            last = here;
        }
    return sum;
}

double turn_of(const SplineCurve& curve, int steps) {
    double sum = 0;
    for (int k = 0; k < steps; ++k) {
        const Vector3d a = curve.tangent(static_cast<double>(k) / steps), b = curve.tangent(static_cast<double>(k + 1) / steps);
        sum += std::atan2(a.cross(b).norm(), a.dot(b));
    }
    return sum;
}

} // namespace

TEST_CASE("a curve passes through its control points, and its tangent turns smoothly there") {
    const Points controls = random_controls(1, 7);
    const SplineCurve curve(controls);
    for (int i = 0; i < 7; ++i) {
        CAPTURE(i);
        const double t = i / 6.0;
        CHECK((curve.point(t) - controls.row(i).transpose()).norm() < 1e-13);
        CHECK((curve.tangent(t - 1e-9) - curve.tangent(t + 1e-9)).norm() < 1e-6);
    }
    for (double t = 0.01; t < 1; t += 0.0371) { // derivatives beside differences
        const double h = 1e-6;
        CHECK((curve.derivative(t) - (curve.point(t + h) - curve.point(t - h)) / (2 * h)).norm() < 1e-6 * curve.length());
        CHECK((curve.second_derivative(t) - (curve.derivative(t + h) - curve.derivative(t - h)) / (2 * h)).norm() < 1e-4 * curve.length());
    }
}

TEST_CASE("points on a line give that line, evenly where they are even") {
    const SplineCurve even(of({{0, 0, 0}, {0, 1, 0}, {0, 2, 0}, {0, 3, 0}}));
    for (double t = 0; t <= 1; t += 0.05) CHECK((even.point(t) - Vector3d(0, 3 * t, 0)).norm() < 1e-14);
    const SplineCurve uneven(of({{0, 0, 0}, {0, 0.2, 0}, {0, 3, 0}}));
    CHECK(uneven.length() == doctest::Approx(3).epsilon(1e-12));
    for (double s = 0; s <= 3; s += 0.1) CHECK(uneven.point(uneven.parameter(s)).y() == doctest::Approx(s).epsilon(1e-9));
}

TEST_CASE("arc length and parameter undo each other, in any unit") {
    for (const double unit : {1e-6, 1.0, 1e6}) {
        const SplineCurve curve(unit * random_controls(3, 6)), plain(random_controls(3, 6));
        CHECK(curve.length() == doctest::Approx(unit * plain.length()).epsilon(1e-12));
        double fine = 0; // beside a polygon of many sides
        for (int k = 0; k < 200000; ++k) fine += (curve.point((k + 1) / 200000.0) - curve.point(k / 200000.0)).norm();
        CHECK(curve.length() == doctest::Approx(fine).epsilon(1e-8));
        for (double t = 0; t <= 1; t += 0.013) CHECK(curve.parameter(curve.arc_length(t)) == doctest::Approx(t).epsilon(1e-8));
        CHECK(curve.parameter(-unit) == 0);
        CHECK(curve.parameter(2 * curve.length()) == 1);
    }
}

TEST_CASE("the nearest point is no farther than any sample, and the way to it is square to the curve") {
    std::mt19937 draw(5);
    std::normal_distribution<double> normal;
    for (unsigned seed = 10; seed < 20; ++seed) {
        CAPTURE(seed);
        const SplineCurve curve(random_controls(seed, 6));
        for (int k = 0; k < 50; ++k) {
            const Vector3d p(2 * normal(draw), 2 * normal(draw), 6 * normal(draw));
            const NearestOnCurve near = curve.nearest(p);
            CHECK(near.distance == doctest::Approx((curve.point(near.t) - p).norm()));
            double least = 1e300;
            for (int i = 0; i <= 5000; ++i) least = std::min(least, (curve.point(i / 5000.0) - p).norm());
            CHECK(near.distance <= least + 1e-4 * curve.length());
            if (near.t > 0 && near.t < 1)
                CHECK(std::abs((curve.point(near.t) - p).normalized().dot(curve.tangent(near.t))) < 1e-6);
            for (const double aside : {-0.01, 0.0, 0.01}) CHECK(curve.nearest(p, near.t + aside).t == doctest::Approx(near.t).epsilon(1e-9));
        }
    }
}

TEST_CASE("unequal control points make the curve overshoot less than equal knots do") {
    double worst = 0, sum = 0, uniform_sum = 0;
    for (unsigned seed = 100; seed < 200; ++seed) {
        std::mt19937 draw(seed);
        std::uniform_real_distribution<double> uniform(0, 1);
        Points controls(6, 3);
        Vector3d at = Vector3d::Zero();
        double polygon = 0;
        Vector3d last = Vector3d::Zero();
        for (int i = 0; i < 6; ++i) {
            controls.row(i) = at.transpose();
            const double angle = 2 * (uniform(draw) - 0.5), size = std::pow(10.0, -1.3 * uniform(draw));
            const Vector3d way(std::sin(angle), std::cos(angle), 0.3 * (uniform(draw) - 0.5));
            if (i > 0 && i < 5) polygon += std::atan2(last.cross(way).norm(), last.dot(way));
            last = way;
            at += size * way;
        }
        uniform_sum += uniform_turn(controls, 400) / polygon;
        const double ratio = turn_of(SplineCurve(controls), 2000) / polygon;
        worst = std::max(worst, ratio);
        sum += ratio;
    }
    MESSAGE("turn of the curve over that of its polygon: mean " << sum / 100 << ", most " << worst << "; with equal knots mean " << uniform_sum / 100);
    CHECK(sum < 0.9 * uniform_sum);
    CHECK(worst < 2);
}

TEST_CASE("a rigid segment is nearly straight and hardly longer than its chord") {
    const Points leg = of({{0, 0, 0}, {0.2, 1, 0}, {-0.4, 2, 0.1}, {0, 3, 0}});
    SplineOptions rigid;
    rigid.rigid = {0, 1, 2};
    const SplineCurve straight(leg, rigid), bent(leg);
    const auto sag = [&](const SplineCurve& curve) { // of the middle half of the second segment
        const Vector3d a = leg.row(1).transpose(), way = (leg.row(2) - leg.row(1)).transpose().normalized();
        double most = 0;
        for (double u = 0.25; u <= 0.75; u += 0.05) {
            const Vector3d p = curve.point((1 + u) / 3) - a;
            most = std::max(most, (p - way * way.dot(p)).norm());
        }
        return most;
    };
    CHECK(sag(straight) < 0.25 * sag(bent));
    const double chords = (leg.row(1) - leg.row(0)).norm() + (leg.row(2) - leg.row(1)).norm() + (leg.row(3) - leg.row(2)).norm();
    CHECK(straight.length() < 1.01 * chords);
    CHECK(straight.length() < bent.length());
}

TEST_CASE("a clamped end keeps its direction wherever the next control point goes") {
    SplineOptions clamped;
    clamped.start_direction = Vector3d(0, 2, 0);
    clamped.end_direction = Vector3d(0, 0, 1);
    const SplineCurve curve(of({{0, 0, 0}, {1, 0.1, 0}, {2, 2, 2}}), clamped);
    CHECK((curve.tangent(0) - Vector3d(0, 1, 0)).norm() < 1e-15);
    CHECK((curve.tangent(1) - Vector3d(0, 0, 1)).norm() < 1e-15);
}

TEST_CASE("coincident control points leave a curve of finite numbers, its tangents of length one") {
    const SplineCurve curve(of({{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {1, 1, 0}}));
    for (double t = 0; t <= 1; t += 0.01) {
        CHECK(curve.point(t).allFinite());
        CHECK(curve.tangent(t).norm() == doctest::Approx(1));
        CHECK(std::isfinite(curve.curvature(t)));
    }
    const SplineCurve nothing(of({{1, 2, 3}, {1, 2, 3}}));
    CHECK(nothing.length() == 0);
    CHECK(nothing.tangent(0.5).norm() == 0);
    CHECK(nothing.nearest({2, 2, 3}).distance == doctest::Approx(1));
}

TEST_CASE("a curve that is none is refused") {
    CHECK(refusal([] { SplineCurve{Points(1, 3)}; }) == "curve-points");
    Points points = Points::Zero(3, 3);
    points(1, 1) = std::nan("");
    CHECK(refusal([&] { SplineCurve{points}; }) == "non-finite-curve");
    SplineOptions options;
    options.rigid = {2};
    CHECK(refusal([&] { SplineCurve(Points::Random(3, 3), options); }) == "rigid-span");
}
