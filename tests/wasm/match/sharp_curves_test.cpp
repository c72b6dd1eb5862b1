#include "lissom/match/sharp_curves.h"

#include "../isoline/figures.h"
#include "refusal.h"
#include "shapes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace lissom;

namespace {

int closed(const std::vector<EdgeCurve>& curves) {
    return static_cast<int>(std::count_if(curves.begin(), curves.end(), [](const EdgeCurve& c) { return c.closed; }));
}

/// A sheet folded along x = 0 by an angle.
TriangleMesh folded(double degrees, int n = 10) {
    TriangleMesh mesh = shapes::sheet(n, n);
    const double a = degrees * 3.14159265358979323846 / 180, middle = (mesh.points.col(0).minCoeff() + mesh.points.col(0).maxCoeff()) / 2;
    for (int v = 0; v < mesh.vertex_count(); ++v)
        if (const double x = mesh.points(v, 0) - middle; x > 1e-9) mesh.points.row(v) << middle + x * std::cos(a), mesh.points(v, 1), x * std::sin(a);
    return mesh;
}

} // namespace

TEST_CASE("a box has its twelve edges between eight corners") {
    const TriangleMesh box = shapes::box(4, 5, 6, {1, 2, 3});
    const auto curves = sharp_curves(box);
    REQUIRE(curves.size() == 12);
    CHECK(closed(curves) == 0);
    for (const EdgeCurve& curve : curves) {
        const Eigen::RowVector3d all = (box.points.row(curve.vertices.back()) - box.points.row(curve.vertices.front())).cwiseAbs();
        CHECK((all.array() > 1e-12).count() == 1);
        for (const int v : curve.vertices) { // on the box's edges: two coordinates of the corner
            const Eigen::RowVector3d to = (box.points.row(v) - box.points.row(curve.vertices.front())).cwiseAbs();
            CHECK((to.array() > 1e-12).count() <= 1);
        }
    }
}

TEST_CASE("what is round has none, and the angle decides") {
    CHECK(sharp_curves(shapes::icosphere(3)).empty());
    CHECK(sharp_curves(folded(30)).empty());
    for (const double angle : {40.0, 90.0, 170.0, -90.0}) {
        const auto curves = sharp_curves(folded(angle));
        REQUIRE(curves.size() == 1);
        CHECK(curves[0].vertices.size() == 11);
    }
    CHECK(sharp_curves(folded(30), {.angle = 25}).size() == 1);
    CHECK(sharp_curves(folded(90), {.angle = 0}).empty());
    CHECK(sharp_curves(shapes::with_fin(shapes::icosphere(2)), {.shortest = 0}).size() == 1); // where three triangles meet
}

TEST_CASE("the same creases whatever the edges' length, the scale and the place") {
    const Eigen::Affine3d map = Eigen::Translation3d(1e3, 0, 5) * Eigen::AngleAxisd(1, Eigen::Vector3d(1, 2, 3).normalized()) * Eigen::Scaling(1e-4);
    for (const int n : {4, 10, 40}) {
        const TriangleMesh mesh = folded(60, n);
        const auto here = sharp_curves(mesh), there = sharp_curves(shapes::moved(mesh, map));
        REQUIRE(here.size() == 1);
        REQUIRE(there.size() == 1);
        CHECK(here[0].vertices == there[0].vertices);
        CHECK(here[0].vertices.size() == static_cast<std::size_t>(n + 1));
    }
}

TEST_CASE("short loose curves are noise, short ones between corners are not") {
    TriangleMesh ball = shapes::icosphere(4);
    const auto spike = [&](int v) { ball.points.row(v) *= 1.12; };
    spike(2000);
    CHECK(sharp_curves(ball, {.shortest = 0}).size() >= 1);
    CHECK(sharp_curves(ball, {.shortest = 0.4}).empty());
    const auto flat_box = sharp_curves(shapes::box(8, 1, 8, {1, 0.01, 1}), {.shortest = 0.1});
    CHECK(flat_box.size() == 12);
}

TEST_CASE("picked edges count whatever their angle, and gaps between them are closed along edges") {
    const TriangleMesh sheet = shapes::sheet(10, 10); // rows of 11 along x
    const auto curves = sharp_curves(sheet, {}, {{22, 23, 24}, {55, 59}});
    REQUIRE(curves.size() == 2);
    CHECK(curves[0].vertices == std::vector<int>{22, 23, 24});
    CHECK(curves[1].vertices == std::vector<int>{55, 56, 57, 58, 59});
    const auto loop = sharp_curves(sheet, {}, {{22, 24, 46, 44, 22}});
    REQUIRE(loop.size() >= 1);
    std::size_t steps = 0;
    for (const EdgeCurve& c : loop) steps += c.vertices.size() - (c.closed ? 0 : 1);
    CHECK(steps == 8);
    CHECK(refusal([&] { (void)sharp_curves(sheet, {}, {{3}}); }) == "picked-edges");
    CHECK(refusal([&] { (void)sharp_curves(sheet, {}, {{3, 121}}); }) == "picked-edges");
    CHECK(refusal([&] { (void)sharp_curves(shapes::two_spheres(), {}, {{3, 300}}); }) == "picked-edges");
    CHECK(refusal([&] { (void)sharp_curves(sheet, {.angle = 200}); }) == "bad-option");
}

TEST_CASE("a nut has twenty rims and edges, a bracket eighteen, a gear its teeth") {
    const TriangleMesh nut = figures::shared("generated/out/nut"), bracket = figures::shared("generated/out/bracket"), gear = figures::shared("generated/out/gear");
    if (nut.vertex_count() == 0 || bracket.vertex_count() == 0 || gear.vertex_count() == 0) return;
    const auto of_nut = sharp_curves(nut), of_bracket = sharp_curves(bracket), of_gear = sharp_curves(gear);
    CHECK(closed(of_nut) == 2);
    CHECK(of_nut.size() == 20); // 6 + 6 rims, 6 edges, 2 bores
    CHECK(of_bracket.size() == 18); // 6 of each end, 6 between
    CHECK(closed(of_gear) == 2);
    MESSAGE("gear: " << of_gear.size() << " curves");
}
