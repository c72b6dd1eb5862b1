#include "lissom/hair/strand_growth.h"

#include "hair/egg.h"
#include "refusal.h"

#include <doctest/doctest.h>

#include <algorithm>

using namespace lissom;
using Eigen::Vector3d;

namespace {

double length_of(const Strand& strand) {
    double sum = 0;
    for (std::size_t k = 1; k < strand.points.size(); ++k) sum += (strand.points[k] - strand.points[k - 1]).norm();
    return sum;
}

const eggs::Grounds& grounds() {
    static const eggs::Grounds made;
    return made;
}

StrandGrowth growth(const VectorField& field, GrowthOptions options) {
    const eggs::Grounds& g = grounds();
    return {g.volume, g.head, field, g.roots, g.no_partings, std::move(options)};
}

} // namespace

TEST_CASE("in a field that leads off the skin a strand has the length asked for, in segments of one length") {
    const VectorField out = grounds().field({0, 1, 0});
    GrowthOptions options;
    options.length = 0.06;
    options.length_variation = 0;
    const StrandGrowth grow = growth(out, options);
    for (std::uint64_t i = 0; i < 50; ++i) {
        const Strand strand = grow.grow(i);
        CHECK(strand.points[0] == strand.root.position);
        CHECK(length_of(strand) == doctest::Approx(0.06).epsilon(0.01));
        for (std::size_t k = 2; k + 1 < strand.points.size(); ++k)
            CHECK((strand.points[k] - strand.points[k - 1]).norm() == doctest::Approx(strand.segment).epsilon(0.05));
    }
}

TEST_CASE("where the field fades a strand ends, once it has left its root") {
    const VectorField faint = grounds().field({0, 0.01, 0});
    const StrandGrowth grow = growth(faint, {});
    for (std::uint64_t i = 0; i < 50; ++i) {
        const Strand strand = grow.grow(i);
        CHECK(length_of(strand) > 0.05 * eggs::Egg::height);
        CHECK(length_of(strand) < 0.2 * eggs::Egg::height);
    }
}

TEST_CASE("a field that leads into the head is followed along the skin, not through it") {
    const eggs::Convex skull(grounds().egg.mesh);
    for (const Vector3d& way : {Vector3d(0, -1, 0), Vector3d(1, 0, 0), Vector3d(-1, -1, 1)}) {
        const VectorField field = grounds().field(way);
        const StrandGrowth grow = growth(field, {});
        for (std::uint64_t i = 0; i < 200; ++i)
            for (const Vector3d& p : grow.grow(i).points) CHECK(skull.depth(p) <= 0.001 * eggs::Egg::height);
    }
}

TEST_CASE("a strand has at most 255 points and stays in the volume") {
    const VectorField field = grounds().field({0, 1, 0.2});
    GrowthOptions options;
    options.step = 0.1;
    options.length = 5;
    const StrandGrowth grow = growth(field, options);
    for (std::uint64_t i = 0; i < 50; ++i) {
        const Strand strand = grow.grow(i);
        CHECK(static_cast<int>(strand.points.size()) <= StrandGrowth::max_points);
        for (std::size_t k = 1; k < strand.points.size(); ++k) CHECK(grounds().volume.field.contains(strand.points[k]));
    }
    options.wave = 0.001; // finer than 255 points can be
    for (std::uint64_t i = 0; i < 50; ++i) CHECK(static_cast<int>(growth(field, options).grow(i).points.size()) <= StrandGrowth::max_points);
}

TEST_CASE("a strand is a matter of its number and the seed alone") {
    const VectorField field = grounds().field({0, 1, 0});
    const StrandGrowth grow = growth(field, {}), again = growth(field, {});
    const auto last = again.grow(9).points;
    CHECK(grow.grow(3).points == again.grow(3).points);
    CHECK(grow.grow(9).points == last);
    CHECK(grow.grow(3).points != last);
    GrowthOptions other;
    other.seed = 2;
    CHECK(growth(field, other).grow(3).root.position != grow.grow(3).root.position);
}

TEST_CASE("a painted length scales a strand where it is rooted") {
    const VectorField field = grounds().field({0, 1, 0});
    GrowthOptions options;
    options.length = 0.08;
    options.length_variation = 0;
    options.length_map.assign(static_cast<std::size_t>(grounds().egg.mesh.vertex_count()), 0.5f);
    for (std::uint64_t i = 0; i < 20; ++i) CHECK(length_of(growth(field, options).grow(i)) == doctest::Approx(0.04).epsilon(0.01));
}

TEST_CASE("a point too near to the skin is moved straight out, one far enough stays") {
    const eggs::Grounds& g = grounds();
    for (int i = 0; i < 40; ++i) {
        const Vector3d way(std::sin(1.0 * i), std::cos(2.0 * i), std::sin(3.0 * i + 1));
        const Vector3d deep = g.egg.skin(way, -0.01), out = StrandGrowth::lifted(g.head, deep, 0.002);
        CHECK(g.head.at(out) >= 0.002);
        CHECK((out - deep).norm() < 0.02);
        const Vector3d far = g.egg.skin(way, 0.01);
        CHECK(StrandGrowth::lifted(g.head, far, 0.002) == far);
    }
}

TEST_CASE("options that make no sense are refused") {
    const VectorField field = grounds().field({0, 1, 0});
    const auto code = [&](auto&& change) {
        GrowthOptions options;
        change(options);
        return refusal([&] { (void)growth(field, options); });
    };
    CHECK(code([](GrowthOptions&) {}) == "none");
    CHECK(code([](GrowthOptions& o) { o.step = 0.05; }) == "bad-option");
    CHECK(code([](GrowthOptions& o) { o.step = 3; }) == "bad-option");
    CHECK(code([](GrowthOptions& o) { o.length = 0; }) == "bad-option");
    CHECK(code([](GrowthOptions& o) { o.length = INFINITY; }) == "bad-option");
    CHECK(code([](GrowthOptions& o) { o.volume = -1; }) == "bad-option");
    CHECK(code([](GrowthOptions& o) { o.length_variation = 1.1; }) == "bad-option");
    CHECK(code([](GrowthOptions& o) { o.wave = 0; }) == "bad-option");
    CHECK(code([](GrowthOptions& o) { o.length_map = {1, 1}; }) == "bad-option");
}

TEST_CASE("a refined strand passes through the points it had, at an even pace on a straight line") {
    const Vector3d root = Vector3d::Zero(), up = Vector3d::UnitY();
    Strand strand{{0, 0, 0, root, up}, {}, 0.3, {}};
    for (int k = 0; k < 5; ++k) strand.points.push_back({0.3 * k, 0, 0});
    const Strand fine = refined(strand, 3);
    REQUIRE(fine.points.size() == 13);
    CHECK(fine.segment == doctest::Approx(0.1));
    for (std::size_t k = 0; k < 13; ++k) CHECK((fine.points[k] - Vector3d(0.1 * static_cast<double>(k), 0, 0)).norm() < 1e-12);
    strand.points[2].y() = 0.2;
    for (std::size_t k = 0; k < 5; ++k) CHECK(refined(strand, 4).points[4 * k] == strand.points[k]);
}
