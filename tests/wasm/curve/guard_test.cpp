#include "lissom/curve/guard.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

using namespace lissom;
using Eigen::AngleAxisd;
using Eigen::Vector3d;

namespace {

/// Planes along a circular arc in the xy plane, `reach` around each.
struct Arc {
    std::vector<CurvePlane> planes;
    std::vector<RowSupport> supports;

    Arc(double radius, double degrees, double reach, int count = 101) {
        for (int i = 0; i < count; ++i) {
            const double a = degrees * i / (count - 1) * std::numbers::pi / 180;
            CurvePlane plane{radius * Vector3d(std::sin(a), 1 - std::cos(a), 0), AngleAxisd(a, Vector3d::UnitZ()).toRotationMatrix()};
            planes.push_back(plane);
            RowSupport support;
            for (int k = 0; k < 64; ++k) support.take_in(reach * std::cos(k * 0.1), reach * std::sin(k * 0.1));
            supports.push_back(support);
        }
    }
    /// Smallest distance, in reaches, at which neighbouring planes meet, seen from the first of them.
    [[nodiscard]] double closest(const GuardedPlanes& guarded, double reach) const {
        double least = 1e300;
        for (std::size_t i = 0; i + 1 < planes.size(); ++i) {
            const Vector3d n = guarded.turns[i] * Vector3d(planes[i].axes.col(0)), m = guarded.turns[i + 1] * Vector3d(planes[i + 1].axes.col(0));
            const Vector3d line = n.cross(m);
            if (line.norm() < 1e-9) continue;
            const Vector3d in = line.normalized().cross(n);
            least = std::min(least, std::abs(m.dot(planes[i + 1].origin - planes[i].origin) / m.dot(in)) / reach);
        }
        return least;
    }
};

} // namespace

TEST_CASE("a support tells how far points reach in any direction") {
    RowSupport support;
    support.take_in(2, 0);
    support.take_in(0, -1);
    CHECK(support.towards(1, 0) == doctest::Approx(2));
    CHECK(support.towards(0, -1) == doctest::Approx(1));
    CHECK(support.towards(-1, 0) < 0.5); // from above: nothing lies there, the next direction sees the other point
    CHECK(support.circle() == doctest::Approx(2));
}

TEST_CASE("a bend that is wide enough is left alone, bit for bit") {
    const Arc wide(2, 90, 0.5);
    const GuardedPlanes guarded = guarded_planes(wide.planes, wide.supports, CurveGuard::symmetric, 50);
    CHECK(guarded.tilt == 0);
    for (const auto& turn : guarded.turns) CHECK(turn.w() == 1);
    CHECK(guarded_planes(Arc(0.1, 90, 5).planes, Arc(0.1, 90, 5).supports, CurveGuard::none, 0).tilt == 0);
}

TEST_CASE("planes of a tight bend no longer meet within what belongs to them") {
    const double reach = 0.5;
    const Arc tight(0.45, 60, reach);
    CHECK(tight.closest(guarded_planes(tight.planes, tight.supports, CurveGuard::none, 0), reach) < 1);
    for (const auto guard : {CurveGuard::symmetric, CurveGuard::thesis}) {
        const GuardedPlanes guarded = guarded_planes(tight.planes, tight.supports, guard, 50);
        CHECK(tight.closest(guarded, reach) > 0.999);
        CHECK(guarded.tilt > 0);
    }
    // From the middle both ways the bend is spread over both halves.
    CHECK(guarded_planes(tight.planes, tight.supports, CurveGuard::symmetric, 50).tilt < guarded_planes(tight.planes, tight.supports, CurveGuard::symmetric, 0).tilt);
}

TEST_CASE("a bend beside the end that is held turns planes away from it, and not the end") {
    const double reach = 0.5;
    const Arc tight(0.45, 60, reach);
    const int last = static_cast<int>(tight.planes.size()) - 1;
    CHECK(guarded_planes(tight.planes, tight.supports, CurveGuard::symmetric, 3).turns[0].w() != 1);
    for (const int held : {0, last}) {
        const GuardedPlanes guarded = guarded_planes(tight.planes, tight.supports, CurveGuard::symmetric, held == 0 ? 3 : last - 3, held);
        CHECK(guarded.turns[held].w() == 1);
        CHECK(tight.closest(guarded, reach) > 0.999);
    }
    // Where the held end is not reached nothing changes.
    const Arc wide(2, 90, 0.5);
    CHECK(guarded_planes(wide.planes, wide.supports, CurveGuard::symmetric, 50, 0).tilt == 0);
}
