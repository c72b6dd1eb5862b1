#include "lissom/curve/extract.h"

#include "lissom/curve/region.h"
#include "lissom/curve/spline.h"
#include "lissom/mesh/operators.h"
#include "limbs.h"
#include "refusal.h"
#include "shapes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

using namespace lissom;
using Eigen::Vector3d;

namespace {

Stroke across(const TriangleMesh& mesh, const std::vector<Vector3d>& through, const Vector3d& forward = {0, 0, -1}, double noise = 0) {
    return limbs::drawn(limbs::view_of(mesh, forward), through, noise, 1);
}

} // namespace

TEST_CASE("a stroke along a bar becomes its axis, wherever the bar stands and however large it is") {
    for (const double scale : {1e-5, 1.0, 1e5}) {
        TriangleMesh mesh = shapes::bar();
        mesh.points = (mesh.points * scale).rowwise() + Eigen::RowVector3d(3, -2, 5) * scale;
        const Vector3d move = Vector3d(3, -2, 5) * scale;
        const CurveSurface surface(shapes::working(mesh).mesh.vertex_count() > 0 ? std::make_shared<WorkingMesh>(shapes::working(mesh)) : nullptr);
        const ExtractedCurve curve = extract_curve(surface, across(mesh, {move + Vector3d(0.2, 1, 0) * scale, move + Vector3d(-0.1, 7, 0) * scale}, {0.3, 0, -1}));
        CHECK(curve.kind == CurveKind::skeleton);
        CHECK(curve.warnings.empty());
        for (int i = 0; i < curve.controls.rows(); ++i) {
            const Vector3d p = (curve.controls.row(i).transpose() - move) / scale;
            CHECK(std::hypot(p.x(), p.z()) < 0.02);
            CHECK(curve.radius[i] / scale == doctest::Approx(1 / std::sqrt(M_PI)).epsilon(0.02));
        }
    }
}

TEST_CASE("a stroke that leaves the model at its ends is a stroke as far as it lies on it") {
    const TriangleMesh mesh = shapes::bar();
    const CurveSurface surface(std::make_shared<WorkingMesh>(shapes::working(mesh)));
    const ExtractedCurve curve = extract_curve(surface, across(mesh, {{0, -2, 0}, {0, 9, 0}}));
    REQUIRE(curve.warnings.size() == 1);
    CHECK(curve.warnings[0].code == "stroke-overshoots");
    CHECK(curve.controls.col(1).minCoeff() > -0.01);
    CHECK(curve.controls.col(1).maxCoeff() < 8.01);
    CHECK(curve.controls.col(1).maxCoeff() > 7.8);
}

TEST_CASE("an open sheet has a surface curve, whose reach is half the sheet's width") {
    const TriangleMesh mesh = shapes::sheet(20, 20);
    const CurveSurface surface(std::make_shared<WorkingMesh>(shapes::working(mesh)));
    const Vector3d centre = mesh.points.colwise().mean();
    const ExtractedCurve curve = extract_curve(surface, across(mesh, {centre - Vector3d(0.4, 0, 0), centre + Vector3d(0.4, 0, 0)}), {.kind = ExtractOptions::Kind::skeleton});
    CHECK(curve.kind == CurveKind::surface);
    REQUIRE(curve.warnings.size() == 1);
    CHECK(curve.warnings[0].code == "open-sheet");
    for (int i = 0; i < curve.controls.rows(); ++i) {
        CHECK(std::abs(curve.controls(i, 2)) < 1e-12);
        CHECK(curve.radius[i] == doctest::Approx(0.5).epsilon(0.01));
    }
    CHECK(std::ssize(curve_region(surface, SplineCurve(curve.controls), curve.radius, {.hits = curve.hits}).vertices) > 0.7 * mesh.vertex_count());
}

TEST_CASE("a surface curve stays where it was drawn, on a soup as on what it was torn from") {
    const TriangleMesh mesh = shapes::bar();
    for (const TriangleMesh& torn : {mesh, shapes::soup(mesh)}) {
        const CurveSurface surface(std::make_shared<WorkingMesh>(shapes::working(torn)));
        const Stroke stroke = across(mesh, {{0.1, 2, 0}, {0, 6, 0}});
        const ExtractedCurve on = extract_curve(surface, stroke, {.kind = ExtractOptions::Kind::surface});
        CHECK(on.kind == CurveKind::surface);
        CHECK((on.controls.col(2).array() - 0.5).abs().maxCoeff() < 1e-9);
        const CurveRegion region = curve_region(surface, SplineCurve(on.controls), on.radius, {.hits = on.hits});
        CHECK(std::any_of(region.vertices.begin(), region.vertices.end(), [&](int v) { return torn.points(v, 2) < -0.49; })); // it reaches the far side
        const ExtractedCurve in = extract_curve(surface, stroke);
        CHECK(in.controls.col(2).cwiseAbs().maxCoeff() < 0.02);
    }
}

TEST_CASE("what is no stroke on the model is refused in words") {
    const TriangleMesh mesh = shapes::bar();
    const CurveSurface surface(std::make_shared<WorkingMesh>(shapes::working(mesh)));
    CHECK(refusal([&] { (void)extract_curve(surface, across(mesh, {{3, 0, 0}, {3, 8, 0}})); }) == "stroke-off-model");
    CHECK(refusal([&] { (void)extract_curve(surface, across(mesh, {{0, 4, 0}, {0, 4.001, 0}})); }) == "stroke-too-short");
    Stroke one = part_of(across(mesh, {{0, 1, 0}, {0, 6, 0}}), 0, 0);
    CHECK(refusal([&] { (void)extract_curve(surface, one); }) == "stroke-too-short");
    CHECK(refusal([&] { (void)extract_curve(surface, {}); }) == "stroke-too-short");
    Stroke inside = across(mesh, {{0, 1, 0}, {0, 6, 0}});
    inside.origins.col(2).setZero();
    CHECK(refusal([&] { (void)extract_curve(surface, inside); }) == "eye-inside-model");
    inside.origins(3, 1) = NAN;
    CHECK(refusal([&] { (void)extract_curve(surface, inside); }) == "bad-stroke");
    inside.origins.resize(2, 3);
    CHECK(refusal([&] { (void)extract_curve(surface, inside); }) == "bad-stroke");
}

TEST_CASE("skeleton curves of seventeen limbs lie at their bones, and their regions are the limbs") {
    double worst_mean = 0;
    int seen = 0;
    for (const limbs::Limb& limb : limbs::all()) {
        const limbs::Creature& creature = limbs::creature(limb.creature);
        if (creature.mesh.vertex_count() == 0) continue;
        ++seen;
        const std::vector<limbs::Bone> bones = creature.bones(limb), others = creature.others(limb);
        double mean = 0, worst = 0, precision = 0, recall = 0, planes_precision = 0;
        int controls = 0;
        constexpr int strokes = 3;
        for (int seed = 1; seed <= strokes; ++seed) {
            const ExtractedCurve found = extract_curve(*creature.surface, limbs::along(creature, limb, 1.5, seed));
            REQUIRE(found.kind == CurveKind::skeleton);
            const SplineCurve curve(found.controls);
            controls = curve.control_count();
            for (int k = 0; k <= 40; ++k) {
                const double e = limbs::error(bones, curve.point(k / 40.0));
                mean += e / (41 * strokes);
                worst = std::max(worst, e);
            }
            // A vertex is the limb's where its bones are nearest, between the two ends of the curve.
            const auto measure = [&](const CurveRegion& region) {
                std::vector<char> in(static_cast<std::size_t>(creature.mesh.vertex_count()), 0);
                for (const int v : region.vertices) in[v] = 1;
                double right = 0, own = 0;
                for (int v = 0; v < creature.mesh.vertex_count(); ++v) {
                    const Vector3d p = creature.mesh.points.row(v);
                    double here = INFINITY, there = INFINITY;
                    for (const limbs::Bone& bone : bones) here = std::min(here, bone.distance(p));
                    for (const limbs::Bone& bone : others) there = std::min(there, bone.distance(p));
                    const double t = curve.nearest(p).t;
                    if (here > there || t <= 0 || t >= 1) continue;
                    own += 1;
                    right += in[v];
                }
                return std::pair(right / std::max<double>(1, std::ssize(region.vertices)), right / own);
            };
            const auto [p, r] = measure(curve_region(*creature.surface, curve, found.radius, {.hits = found.hits}));
            const auto [planes, unused] = measure(curve_region(*creature.surface, curve, found.radius, {.method = RegionMethod::planes, .hits = found.hits}));
            (void)unused;
            precision += p / strokes;
            recall += r / strokes;
            planes_precision += planes / strokes;
        }
        std::printf("%-8s %-10s %2d points, error mean %.3f max %.2f radii; region precision %.2f (planes %.2f) recall %.2f\n", limb.creature.c_str(), limb.name.c_str(), controls, mean,
                    worst, precision, planes_precision, recall);
        worst_mean = std::max(worst_mean, mean);
        CHECK(mean <= 0.3);
        if (limb.slender) {
            CHECK(precision >= 0.8);
            CHECK(recall >= 0.9);
        }
    }
    if (seen > 0) std::printf("worst mean over %d limbs: %.3f radii\n", seen, worst_mean);
}
