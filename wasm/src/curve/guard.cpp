#include "lissom/curve/guard.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace lissom {

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

namespace {

constexpr double k_margin = 1.2; ///< planes that just touch leave triangles that do (1.02: 840 crossings at 135 degrees)
constexpr double k_sector = std::numbers::pi / 8;

/// The sixteen directions of a support: cosines, then sines. Half a million vertices are held against them.
const auto k_directions = [] {
    std::array<std::array<double, 16>, 2> result;
    for (int k = 0; k < 16; ++k) {
        result[0][k] = std::cos(k * k_sector);
        result[1][k] = std::sin(k * k_sector);
    }
    return result;
}();

/// Turns plane b until it meets a at the edge of what belongs to either; no turn where they meet outside already.
Quaterniond apart(const CurvePlane& a, const CurvePlane& b, const RowSupport& of_a, const RowSupport& of_b, CurveGuard guard) {
    const Vector3d na = a.axes.col(0), nb = b.axes.col(0), line = na.cross(nb);
    if (line.norm() < 1e-12) return Quaterniond::Identity(); // parallel
    const Vector3d e = line.normalized();
    const Vector3d inwards = e.cross(na); // in plane a, square to the line where both meet
    const double slope = nb.dot(inwards);
    const double to_line = nb.dot(b.origin - a.origin) / slope; // of the line from a's origin, along `inwards`
    const double side = to_line < 0 ? -1 : 1;
    const auto reach = [&](const RowSupport& support, const CurvePlane& plane, const Vector3d& direction) {
        if (guard == CurveGuard::thesis) return support.circle();
        return k_margin * support.towards(direction.dot(plane.axes.col(1)), direction.dot(plane.axes.col(2)));
    };
    const Vector3d in_b = side * e.cross(nb);
    const double from_b = std::abs(na.dot(b.origin - a.origin) / na.dot(e.cross(nb)));
    const double ra = reach(of_a, a, side * inwards), rb = reach(of_b, b, in_b);
    if (std::abs(to_line) >= ra && from_b >= rb) return Quaterniond::Identity();
    // Through b's origin, along the line, and the point of a just outside.
    const Vector3d outside = a.origin + side * std::max(ra, std::abs(to_line)) * inwards;
    Vector3d normal = e.cross(outside - b.origin);
    if (normal.norm() < 1e-12 * (ra + rb)) return Quaterniond::Identity();
    normal.normalize();
    if (normal.dot(nb) < 0) normal = -normal;
    return Quaterniond::FromTwoVectors(nb, normal);
}

} // namespace

void RowSupport::take_in(double b, double g) {
    for (int k = 0; k < 16; ++k) reach[k] = std::max(reach[k], b * k_directions[0][k] + g * k_directions[1][k]);
}

double RowSupport::towards(double b, double g) const {
    const double place = std::atan2(g, b) / k_sector + 16;
    const int k = static_cast<int>(place);
    return std::max(reach[k % 16], reach[(k + 1) % 16]);
}

double RowSupport::circle() const { return *std::max_element(reach.begin(), reach.end()); }

GuardedPlanes guarded_planes(std::span<const CurvePlane> planes, std::span<const RowSupport> supports, CurveGuard guard, int from, int held) {
    const int count = static_cast<int>(planes.size());
    GuardedPlanes result;
    result.turns.assign(count, Quaterniond::Identity());
    if (guard == CurveGuard::none) return result;
    const auto outwards = [&](int start) {
        std::vector<CurvePlane> turned(planes.begin(), planes.end());
        result.tilt = 0;
        result.turns[start] = Quaterniond::Identity();
        for (const int way : {1, -1})
            for (int i = start + way; i >= 0 && i < count; i += way) {
                const Quaterniond turn = apart(turned[i - way], turned[i], supports[i - way], supports[i], guard);
                turned[i].axes = turn.toRotationMatrix() * turned[i].axes;
                result.turns[i] = turn;
                const double angle = 2 * std::atan2(turn.vec().norm(), std::abs(turn.w()));
                result.tilt = std::max(result.tilt, angle * 180 / std::numbers::pi);
            }
    };
    outwards(guard == CurveGuard::thesis ? 0 : std::clamp(from, 0, count - 1));
    if (guard == CurveGuard::symmetric && held >= 0 && result.turns[held].w() != 1) outwards(held);
    return result;
}

} // namespace lissom
