#include "lissom/hair/parting_guard.h"

#include "lissom/hair/hair_volume.h"
#include "lissom/mesh/chance.h"
#include "shapes.h"

#include <doctest/doctest.h>

#include <numeric>

using namespace lissom;
using Eigen::Vector3d;

namespace {

/// A ball of a head with a bent parting over its top.
struct Parted {
    TriangleMesh ball = shapes::icosphere(4);
    std::vector<int> all = [this] {
        std::vector<int> v(static_cast<std::size_t>(ball.vertex_count()));
        std::iota(v.begin(), v.end(), 0);
        return v;
    }();
    HairVolume volume = hair_volume(ball, all, 32);
    HeadDistance head{volume.head, volume.distance};
    DividingCurve bent;

    Parted() {
        for (const double t : {-0.6, -0.2, 0.1, 0.4, 0.7})
            bent.points.push_back(Vector3d(t > 0 ? 0.8 * t : 0.3 * t, 1, t).normalized());
    }
    [[nodiscard]] PartingGuard guard() const {
        return {std::span<const DividingCurve>(&bent, 1), head, volume.field.step, 0.12};
    }
    /// Places over the skin beside the line, some of them on the other side.
    [[nodiscard]] Vector3d place(int i) const {
        const auto chance_of = [&](std::uint64_t what) { return chance(7, static_cast<std::uint64_t>(i), what); };
        const double at = chance_of(1) * 4;
        const auto k = std::min<std::size_t>(3, static_cast<std::size_t>(at));
        const Vector3d on = bent.points[k] + (at - static_cast<double>(k)) * (bent.points[k + 1] - bent.points[k]);
        const Vector3d off(chance_of(2) - 0.5, 0, chance_of(3) - 0.5);
        return (on + 0.15 * off).normalized() * (1 + 0.1 * chance_of(4));
    }
};

} // namespace

TEST_CASE("what is kept beside a bent parting lies on its own side, wherever it came from") {
    const Parted parted;
    const PartingGuard guard = parted.guard();
    int moved = 0;
    for (int i = 0; i < 4000; ++i) {
        const Vector3d p = parted.place(i);
        for (const std::int8_t side : {std::int8_t(-1), std::int8_t(1)}) {
            const Vector3d kept = guard.kept(p, {side});
            const PartingGuard::Sides now = guard.sides(kept);
            CHECK(now[0] != -side);
            CHECK(!guard.on_line(kept));
            moved += kept != p;
        }
    }
    CHECK(moved > 1000);
}

TEST_CASE("a direction beside a parting leads away from it") {
    const Parted parted;
    const PartingGuard guard = parted.guard();
    for (int i = 0; i < 1000; ++i) {
        const Vector3d p = parted.place(i);
        const PartingGuard::Sides sides = guard.sides(p);
        const Vector3d straight_back(0, 0, -1), out = guard.outward(p, straight_back, sides);
        CHECK(out.norm() == doctest::Approx(1));
        if (sides[0] == 0) CHECK(out == straight_back);
    }
}

TEST_CASE("two strands are apart when a parting lies between them") {
    CHECK(PartingGuard::apart({1, -1}, {1, 1}));
    CHECK(!PartingGuard::apart({1, 0}, {1, 1}));
    CHECK(!PartingGuard::apart({}, {}));
}
