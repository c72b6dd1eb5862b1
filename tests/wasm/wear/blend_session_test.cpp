#include "lissom/wear/blend_session.h"

#include "refusal.h"
#include "shapes.h"

#include <doctest/doctest.h>

#include <limits>

using Eigen::Vector2d;
using Eigen::Vector3d;
using lissom::BlendSession;
using lissom::Measure;
using lissom::PartSpec;
using lissom::Points;

namespace {

lissom::TriangleMesh ball() { return shapes::icosphere(4); }

std::vector<Points> skins() {
    const Points a = ball().points;
    return {a, a * Vector3d(1.5, 1.2, 0.8).asDiagonal()};
}

PartSpec cap() {
    PartSpec part{.from = 1, .vertices = {}};
    const Points points = ball().points;
    for (int v = 0; v < points.rows(); ++v)
        if (points(v, 2) > 0.8) part.vertices.push_back(v);
    return part;
}

BlendSession session(const std::vector<PartSpec>& parts = {}) {
    BlendSession made(ball().triangles, skins(), parts);
    while (made.step()) {
    }
    return made;
}

Measure extent(const Vector3d& along, double wanted = 0) {
    Measure measure;
    measure.direction = along;
    if (wanted > 0) measure.wanted = wanted;
    return measure;
}

} // namespace

TEST_CASE("a blend is the sum of the skins by their weights") {
    BlendSession blends = session();
    const auto both = skins();
    CHECK(blends.blend(Vector2d(1, 0)).positions == both[0]);
    CHECK((blends.blend(Vector2d(0.25, 0.75)).positions - 0.25 * both[0] - 0.75 * both[1]).norm() < 1e-12);
    CHECK((blends.blend(Vector2d(1.5, -0.5)).positions - 1.5 * both[0] + 0.5 * both[1]).norm() < 1e-12);
}

TEST_CASE("parts are set in anew for every weight") {
    BlendSession blends = session({cap()});
    const auto both = skins();
    const Points half = blends.blend(Vector2d(0.5, 0.5)).positions;
    CHECK((half - 0.5 * (both[0] + both[1])).rowwise().norm().maxCoeff() > 0.005);
    CHECK((blends.blend(Vector2d(0, 1)).positions - both[1]).cwiseAbs().maxCoeff() < 1e-8);
    CHECK(blends.blend(Vector2d(0.5, 0.5)).positions == half);
    CHECK(blends.fraction() == 1);
}

TEST_CASE("wanted measures find weights, others are only measured; misses are told") {
    BlendSession blends = session({cap()});
    const std::vector<Measure> wide{extent({1, 0, 0}, 2.5)}, plain{extent({1, 0, 0})}, far{extent({1, 0, 0}, 30)}, both{extent({1, 0, 0}, 2), extent({0, 1, 0}, 9)};
    const auto found = blends.blend(Vector2d(0.9, 0.1), wide);
    CHECK(found.reached[0] == doctest::Approx(2.5).epsilon(1e-3));
    CHECK((found.weights - Vector2d(0.5, 0.5)).norm() < 2e-3);
    CHECK(found.warnings.empty());
    const auto measured = blends.blend(Vector2d(1, 0), plain);
    CHECK(measured.reached[0] == doctest::Approx(2).epsilon(1e-3));
    CHECK(measured.weights == Vector2d(1, 0));
    const auto giant = blends.blend(Vector2d(1, 0), far).warnings;
    REQUIRE(giant.size() == 1);
    CHECK(giant[0].code == "weights-far");
    const auto missed = blends.blend(Vector2d(1, 0), both).warnings;
    REQUIRE(!missed.empty());
    CHECK(missed[0].code == "measure-missed");
}

TEST_CASE("skins, weights and parts that do not fit are refused") {
    const auto code = [&](const std::vector<Points>& bodies, const std::vector<PartSpec>& parts) { return refusal([&] { BlendSession(ball().triangles, bodies, parts); }); };
    CHECK(code({}, {}) == "no-skins");
    CHECK(code({skins()[0], skins()[1].topRows(100)}, {}) == "wrong-size");
    CHECK(code({skins()[0].topRows(100)}, {}) == "vertex-out-of-range");
    CHECK(code({std::numeric_limits<double>::quiet_NaN() * skins()[0]}, {}) == "non-finite-position");
    CHECK(code(skins(), {PartSpec{.from = 2, .vertices = {1}}}) == "unknown-skin");
    CHECK(code(skins(), {PartSpec{.from = 1, .vertices = {}}}) == "empty-part");
    BlendSession blends = session();
    CHECK(refusal([&] { (void)blends.blend(Vector3d(1, 0, 0)); }) == "wrong-size");
    CHECK(refusal([&] { (void)blends.blend(Vector2d(0, 0)); }) == "no-weights");
    CHECK(refusal([&] { (void)blends.blend(Vector2d(1, std::numeric_limits<double>::quiet_NaN())); }) == "no-weights");
    std::vector<Measure> nowhere{Measure{}};
    nowhere[0].kind = Measure::Kind::section, nowhere[0].vertex = 99999;
    CHECK(refusal([&] { (void)blends.blend(Vector2d(1, 0), nowhere); }) == "vertex-out-of-range");
}
