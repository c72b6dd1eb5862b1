#include "lissom/curve/frames.h"

#include <cmath>

namespace lissom {

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

namespace {

/// Columns u, v, w from u and something near v: rounding is not carried along the curve.
Matrix3d squared(const Vector3d& u, const Vector3d& near_v) {
    Matrix3d axes;
    axes.col(0) = u;
    axes.col(1) = (near_v - u * u.dot(near_v)).normalized();
    axes.col(2) = u.cross(axes.col(1));
    return axes;
}

Vector3d reflected(const Vector3d& x, const Vector3d& mirror) { return x - mirror * (2 * mirror.dot(x) / mirror.squaredNorm()); }

} // namespace

Matrix3d axes_along(const Vector3d& u) {
    const bool xz = std::abs(u.x()) >= std::abs(u.y());
    const Vector3d v = xz ? Vector3d(-u.z(), 0, u.x()) : Vector3d(-u.y(), u.x(), 0);
    return v.norm() > 0 ? squared(u, v) : squared(u, Vector3d(1, 0, 0));
}

Quaterniond least_turn(const Vector3d& from, const Vector3d& to) { return Quaterniond::FromTwoVectors(from, to); }

Matrix3d posed_axes(const Matrix3d& rest, const Vector3d& tangent, const Quaterniond& base) {
    const Vector3d u = base * Vector3d(rest.col(0)), v = base * Vector3d(rest.col(1));
    if (tangent.isZero()) return squared(u, v);
    return squared(tangent, least_turn(u, tangent) * v); // v₀′ = R(B u₀ → u₀′) B v₀
}

CurveFrame transported(const CurveFrame& from, const Vector3d& to, const Vector3d& tangent) {
    CurveFrame result{to, from.axes};
    if (tangent.isZero()) return result;
    const Vector3d u = from.axes.col(0), v = from.axes.col(1), way = to - from.origin;
    if (way.squaredNorm() == 0) {
        result.axes = squared(tangent, least_turn(u, tangent) * v);
        return result;
    }
    // Two mirrors: one half way to the next place, one that brings the mirrored tangent onto the tangent there.
    const Vector3d u_mirrored = reflected(u, way), v_mirrored = reflected(v, way), second = tangent - u_mirrored;
    // Where the mirrored tangent is there already, the second mirror is the plane square to it: v keeps its side.
    result.axes = squared(tangent, second.squaredNorm() > 1e-30 ? reflected(v_mirrored, second) : v_mirrored);
    return result;
}

std::vector<CurveFrame> frames_along(const SplineCurve& curve, std::span<const double> parameters, const Matrix3d& axes, bool from_end) {
    const int count = static_cast<int>(parameters.size());
    std::vector<CurveFrame> frames(count);
    if (count == 0) return frames;
    const int first = from_end ? count - 1 : 0, way = from_end ? -1 : 1;
    frames[first] = {curve.point(parameters[first]), axes};
    for (int k = 1; k < count; ++k) {
        const int here = first + way * k;
        frames[here] = transported(frames[here - way], curve.point(parameters[here]), curve.tangent(parameters[here]));
    }
    return frames;
}

} // namespace lissom
