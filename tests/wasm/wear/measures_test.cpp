#include "lissom/wear/measures.h"

#include "refusal.h"
#include "shapes.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <string>

using Eigen::RowVector3d;
using lissom::Measure;
using lissom::Measurer;
using lissom::Points;
using lissom::TriangleMesh;
using Kind = lissom::Measure::Kind;

namespace {

int nearest(const TriangleMesh& mesh, const RowVector3d& p) {
    Eigen::Index v = 0;
    (mesh.points.rowwise() - p).rowwise().squaredNorm().minCoeff(&v);
    return static_cast<int>(v);
}

Measure height(const Eigen::Vector3d& up) { return {.kind = Kind::height, .direction = up, .vertices = {}, .wanted = {}}; }
Measure girth(const Eigen::Vector3d& normal, int vertex, bool hull = false) { return {.kind = Kind::section, .direction = normal, .vertex = vertex, .vertices = {}, .hull = hull, .wanted = {}}; }
Measure loop(std::vector<int> vertices, bool hull = false) { return {.kind = Kind::loop, .vertices = std::move(vertices), .hull = hull, .wanted = {}}; }
Measure path(std::vector<int> vertices) { return {.kind = Kind::path, .vertices = std::move(vertices), .wanted = {}}; }

double value(const TriangleMesh& mesh, const Measure& measure) { return Measurer(mesh.triangles, mesh.vertex_count()).measure(mesh.points, measure, 0).value; }

} // namespace

TEST_CASE("a ball is as high as its diameter and as far around as its circles") {
    const TriangleMesh ball = shapes::icosphere(5);
    CHECK(value(ball, height({1, 2, 0.5})) == doctest::Approx(2).epsilon(0.001));
    for (const double h : {0.0, 0.5, -0.8}) {
        const int v = nearest(ball, {std::sqrt(1 - h * h), h, 0});
        const double at = ball.points(v, 1);
        CHECK(value(ball, girth({0, 3, 0}, v)) == doctest::Approx(2 * std::numbers::pi * std::sqrt(1 - at * at)).epsilon(0.002));
    }
}

TEST_CASE("of several lines in a plane it is the one at the vertex") {
    const TriangleMesh ring = shapes::torus(96, 48);
    Eigen::Index out = 0;
    ring.points.col(0).maxCoeff(&out);
    // A plane through the axis cuts the ring in two circles.
    const RowVector3d p = ring.points.row(out);
    const Eigen::Vector3d axis = std::abs(ring.points.col(2).maxCoeff()) < 0.5 ? Eigen::Vector3d(0, 0, 1) : Eigen::Vector3d(0, 1, 0);
    CHECK(value(ring, girth(axis.cross(p.transpose()), static_cast<int>(out))) == doctest::Approx(2 * std::numbers::pi * 0.38).epsilon(0.01));
}

TEST_CASE("a tape lies over hollows") {
    TriangleMesh star = shapes::cylinder(96, 12, 1); // eight points
    for (Eigen::Index v = 0; v < star.points.rows(); ++v) {
        const double r = 1 + 0.3 * std::cos(8 * std::atan2(star.points(v, 1), star.points(v, 0)));
        star.points(v, 0) *= r, star.points(v, 1) *= r;
    }
    const int v = nearest(star, {1.3, 0, 0.5});
    const double line = value(star, girth({0, 0, 1}, v)), tape = value(star, girth({0, 0, 1}, v, true));
    CHECK(tape == doctest::Approx(16 * 1.3 * std::sin(std::numbers::pi / 8)).epsilon(0.02)); // an octagon, somewhat rounded
    CHECK(line > 1.2 * tape);
}

TEST_CASE("lines through vertices are as long as their sides") {
    const TriangleMesh box = shapes::box(4, 4, 4, {1, 2, 3});
    const std::vector<int> c{nearest(box, {-0.5, 0, -1.5}), nearest(box, {0.5, 0, -1.5}), nearest(box, {0.5, 2, -1.5}), nearest(box, {-0.5, 2, -1.5})};
    CHECK(value(box, path(c)) == doctest::Approx(4));
    CHECK(value(box, loop(c)) == doctest::Approx(6));
    CHECK(value(box, loop({c[0], c[2], c[1], c[3]}, true)) == doctest::Approx(6));
}

TEST_CASE("slopes are those that differences show") {
    const TriangleMesh body = shapes::bumpy_sphere(4);
    const Measurer m(body.triangles, body.vertex_count());
    Points change(body.vertex_count(), 3);
    for (Eigen::Index v = 0; v < change.rows(); ++v) change.row(v) << std::sin(3 * body.points(v, 1)), body.points(v, 0) * body.points(v, 2), std::cos(2 * body.points(v, 0));
    const int v = nearest(body, {1, 0.2, 0});
    for (const Measure& measure : {height({0, 1, 0.2}), girth({0.1, 1, 0}, v), girth({0.1, 1, 0}, v, true), loop({0, 50, 200, 90}), path({0, 50, 200, 90})}) {
        double slope = 0;
        for (const auto& [at, by] : m.measure(body.points, measure, 0).slope) slope += by.dot(change.row(at));
        const double h = 1e-6, difference = (m.measure(body.points + h * change, measure, 0).value - m.measure(body.points - h * change, measure, 0).value) / (2 * h);
        CHECK(slope == doctest::Approx(difference).epsilon(1e-4));
    }
}

TEST_CASE("whichever way triangles face the line is found, and at every size") {
    const TriangleMesh ball = shapes::icosphere(4), mixed = shapes::with_mixed_orientation(ball, 3);
    const Measure around = girth({0, 1, 0}, nearest(ball, {0.9, 0.3, 0}));
    CHECK(value(mixed, around) == doctest::Approx(value(ball, around)));
    for (const double size : {1e-6, 1e6}) CHECK(value({size * ball.points, ball.triangles}, around) == doctest::Approx(size * value(ball, around)));
}

TEST_CASE("what cannot be measured is refused by its number") {
    const TriangleMesh sheet = shapes::sheet(6, 6), ball = shapes::icosphere(3);
    CHECK(refusal([&] { value(sheet, girth({0, 1, 0}, 24)); }) == "loop-open");
    CHECK(refusal([&] { value(ball, girth({0, 1, 0}, nearest(ball, {0, 1, 0}))); }) == "loop-open");
    const Measurer m(ball.triangles, ball.vertex_count());
    const auto code = [&](const Measure& measure) { return refusal([&] { m.check(measure, 2); }); };
    CHECK(code(girth({0, 1, 0}, 100000)) == "vertex-out-of-range");
    CHECK(code(loop({1, 2})) == "bad-measure");
    CHECK(code(path({1})) == "bad-measure");
    CHECK(code(path({1, -1})) == "vertex-out-of-range");
    CHECK(code(height({0, 0, 0})) == "bad-measure");
    Measure wanted = height({0, 1, 0});
    wanted.wanted = -1;
    CHECK(code(wanted) == "bad-measure");
    wanted.wanted = 1;
    CHECK(code(wanted) == "none");
    try {
        m.check(path({1}), 7);
    } catch (const lissom::InvalidInput& error) {
        CHECK(std::string(error.what()).starts_with("measures[7]"));
    }
}
