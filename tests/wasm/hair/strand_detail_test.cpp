#include "lissom/hair/strand_detail.h"

#include "hair/egg.h"
#include "refusal.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace lissom;
using Eigen::Vector3d;

namespace {

constexpr DetailOptions k_none{0, 0, {}, 0, 0};

/// Hair that stands up off an egg, and what adds detail to it.
struct Lawn {
    eggs::Grounds grounds{};
    VectorField field = grounds.field({0, 1, 0.3});
    StrandGrowth growth{grounds.volume, grounds.head, field, grounds.roots, grounds.no_partings, {}};
    TailTie no_ties{{}};

    [[nodiscard]] std::vector<Strand> guides(std::uint64_t count = 400) const {
        std::vector<Strand> out;
        for (std::uint64_t i = 0; i < count; ++i) out.push_back(growth.grow(i));
        return out;
    }
    [[nodiscard]] StrandDetail detail(const DetailOptions& options, std::uint64_t seed = 1, std::uint64_t count = 400) const {
        return {grounds.volume, grounds.head, grounds.no_partings, no_ties, options, seed, guides(count)};
    }
    [[nodiscard]] Strand with(const StrandDetail& detail, std::uint64_t index) const {
        Strand strand = growth.grow(index);
        detail.apply(strand, index);
        return strand;
    }
};

const Lawn& lawn() {
    static const Lawn made;
    return made;
}

double farthest(const Strand& a, const Strand& b) {
    double out = 0;
    for (std::size_t k = 0; k < a.points.size(); ++k) out = std::max(out, (a.points[k] - b.points[k]).norm());
    return out;
}

} // namespace

TEST_CASE("where no detail is asked for, hair stays as it grew") {
    const StrandDetail detail = lawn().detail(k_none);
    for (std::uint64_t i = 0; i < 600; i += 7) CHECK(farthest(lawn().with(detail, i), lawn().growth.grow(i)) < 1e-6 * eggs::Egg::height);
}

TEST_CASE("detail moves a strand's points but not its root nor their number, and none into the head") {
    const eggs::Convex skull(lawn().grounds.egg.mesh);
    const StrandDetail detail = lawn().detail({1, 1, {}, 1, 1});
    double moved = 0;
    for (std::uint64_t i = 400; i < 800; i += 3) {
        const Strand before = lawn().growth.grow(i), after = lawn().with(detail, i);
        CHECK(after.points.size() == before.points.size());
        CHECK(after.points[0] == before.points[0]);
        for (const Vector3d& p : after.points) CHECK(skull.depth(p) <= 0.001 * eggs::Egg::height);
        moved = std::max(moved, farthest(before, after));
    }
    CHECK(moved > 0.02 * eggs::Egg::height);
}

TEST_CASE("a strand's detail is a matter of its number and the seed, whatever is grown beside it") {
    const DetailOptions all{0.5, 0.5, {}, 0.5, 0.5};
    const StrandDetail detail = lawn().detail(all), again = lawn().detail(all), other = lawn().detail(all, 2);
    const Strand first = lawn().with(detail, 500);
    for (std::uint64_t i = 0; i < 20; ++i) (void)lawn().with(again, i);
    CHECK(lawn().with(again, 500).points == first.points);
    CHECK(lawn().with(other, 500).points != first.points);
}

TEST_CASE("clumps gather tips: the more they are asked to, the nearer those come to their neighbours") {
    const auto spread = [&](double clump) {
        const StrandDetail detail = lawn().detail({clump, 0, {}, 0, 0});
        std::vector<std::vector<Vector3d>> tips(StrandDetail::large_guides + 1);
        for (std::uint64_t i = 400; i < 1400; ++i) {
            Strand strand = lawn().growth.grow(i);
            const int large = detail.apply(strand, i);
            REQUIRE(large >= 0);
            REQUIRE(large <= StrandDetail::large_guides);
            tips[static_cast<std::size_t>(large)].push_back(strand.points.back());
        }
        double sum = 0;
        int count = 0;
        for (const auto& clumped : tips) {
            Vector3d middle = Vector3d::Zero();
            for (const Vector3d& p : clumped) middle += p / static_cast<double>(clumped.size());
            for (const Vector3d& p : clumped) sum += (p - middle).norm();
            count += static_cast<int>(clumped.size());
        }
        return sum / count;
    };
    const double loose = spread(0), half = spread(0.5), tight = spread(1);
    CHECK(half < 0.9 * loose);
    CHECK(tight < 0.9 * half);
}

TEST_CASE("without guides a strand belongs to no clump") {
    const StrandDetail detail = lawn().detail({1, 0, {}, 0, 0}, 1, 0);
    Strand strand = lawn().growth.grow(5);
    CHECK(detail.apply(strand, 5) == StrandDetail::large_guides);
    CHECK(farthest(strand, lawn().growth.grow(5)) < 1e-6 * eggs::Egg::height);
}

TEST_CASE("the shortest turn follows the head's height, grows where curls are shallow and is none without curls") {
    CHECK(!shortest_turn(k_none, 1));
    const auto turn = [](double curl, double height, std::optional<double> length = {}) { return *shortest_turn({0, curl, length, 0, 0}, height); };
    CHECK(turn(0.5, 24) == doctest::Approx(24 * turn(0.5, 1)));
    CHECK(turn(1, 1) <= turn(0.5, 1));
    CHECK(turn(0.5, 1) <= turn(0.1, 1));
    CHECK(turn(1e-6, 1) == doctest::Approx(2 * 0.8 * 0.16)); // twice the shortest turn of a clump, at most
    CHECK(turn(1, 1, 0.01) == doctest::Approx(0.8 * 0.01).epsilon(0.01)); // deep curls: the turn itself
    CHECK(turn(0.5, 1, 0.1) < turn(0.5, 1, 0.2));
}

TEST_CASE("shares outside 0 to 1 and curls without length are refused") {
    const auto code = [](const DetailOptions& options) { return refusal([&] { (void)lawn().detail(options, 1, 0); }); };
    CHECK(code({1, 1, 0.01, 1, 1}) == "none");
    CHECK(code({-0.1, 0, {}, 0, 0}) == "bad-option");
    CHECK(code({0, 1.1, {}, 0, 0}) == "bad-option");
    CHECK(code({0, 0, 0.0, 0, 0}) == "bad-option");
    CHECK(code({0, 0, {}, 2, 0}) == "bad-option");
    CHECK(code({0, 0, {}, 0, NAN}) == "bad-option");
}
