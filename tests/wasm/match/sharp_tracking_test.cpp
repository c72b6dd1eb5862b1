#include "lissom/match/sharp_tracking.h"

#include "../isoline/figures.h"
#include "lissom/match/sharp_curves.h"
#include "lissom/mesh/operators.h"
#include "lissom/mesh/remesh.h"
#include "lissom/mesh/self_intersections.h"
#include "lissom/mesh/stopwatch.h"
#include "pairs.h"
#include "ring_markers.h"
#include "sharp_truth.h"
#include "shapes.h"

#include <doctest/doctest.h>

#include <cmath>
#include <ctime>

using namespace lissom;

namespace {

std::vector<char> locks(const TriangleMesh& skin, const std::vector<Anchor>& markers) {
    std::vector<char> flags(static_cast<std::size_t>(skin.vertex_count()), 0);
    for (const Anchor& m : markers) flags[m.vertex] = 1;
    return flags;
}

} // namespace

TEST_CASE("held vertices arrive, those of the strip stay on the surface, all others stay where they are") {
    const TriangleMesh model = shapes::box(24, 24, 24);
    TriangleMesh skin = shapes::box(12, 13, 14);
    const FitSurface surface(model);
    // The skin's own edges lie beside the model's: it was turned a little on it.
    const Eigen::AngleAxisd turn(0.06, Eigen::Vector3d(1, 2, 3).normalized());
    const Eigen::Vector3d middle(0, 0.5, 0);
    for (int v = 0; v < skin.vertex_count(); ++v)
        skin.points.row(v) = surface.nearest(middle + turn * (skin.points.row(v).transpose() - middle), Eigen::Vector3d::Zero(), -1, 1).point.transpose();
    const double L = mean_edge_length(skin);
    const auto lines = sharp_lines(model.points, sharp_curves(model));
    const SharpPaths found = find_sharp_paths(skin, lines, {}, {L});
    REQUIRE(found.failed.empty());
    const auto anchors = anchors_of(found.paths);
    SharpTracking tracking(skin, surface, anchors, locks(skin, {}), {.strip = 2});
    TriangleMesh moved = skin;
    int slices = 1;
    while (tracking.step(moved)) ++slices;
    CHECK(slices == tracking.slices());
    CHECK(tracking.done() == slices);
    CHECK(tracking.farthest(moved.points) < 1e-12);
    CHECK(sharp_truth::error(lines, moved.points, found.paths, std::sqrt(3.0)).most < 1e-12);
    const SurfaceDistances apart = surface_distances(moved, model);
    CHECK(apart.mean_there < 1e-4);
    CHECK(apart.mean_back < 1e-4);
    int still = 0;
    for (int v = 0; v < skin.vertex_count(); ++v) still += moved.points.row(v) == skin.points.row(v);
    CHECK(still > 100);
}

TEST_CASE("markers and borders stay") {
    const TriangleMesh sheet = shapes::sheet(20, 20);
    const FitSurface surface(sheet);
    SharpLine line{Points(2, 3)};
    line.points << sheet.points(0, 0) + 0.2, sheet.points(0, 1) + 0.52, 0, sheet.points(0, 0) + 0.8, sheet.points(0, 1) + 0.48, 0;
    const Anchor marker{21 * 12 + 10, sheet.points.row(21 * 12 + 10).transpose()};
    const SharpPaths found = find_sharp_paths(sheet, {line}, {marker}, {0.05});
    REQUIRE(found.failed.empty());
    TriangleMesh moved = sheet;
    SharpTracking tracking(sheet, surface, anchors_of(found.paths), locks(sheet, {marker}), {.strip = 20});
    while (tracking.step(moved)) {
    }
    CHECK(tracking.farthest(moved.points) < 1e-12);
    CHECK(moved.points.row(marker.vertex) == sheet.points.row(marker.vertex));
    for (int v = 0; v < sheet.vertex_count(); ++v)
        if (v < 21 || v >= 21 * 20 || v % 21 == 0 || v % 21 == 20) CHECK(moved.points.row(v) == sheet.points.row(v));
    CHECK(self_intersections(moved).pairs == 0);
}

TEST_CASE("a ring becomes a nut: every sharp edge lies on edges of the skin within 0.05 % of the diagonal") {
    const TriangleMesh torus = figures::shared("generated/out/torus"), nut = figures::shared("generated/out/nut");
    if (torus.vertex_count() == 0 || nut.vertex_count() == 0) return;
    const Points from = rings::on_torus(torus), to = rings::on_nut(nut);
    const pairs::Matched matched = pairs::run(torus, nut, from, to, {.connectivity = false});
    MESSAGE("torus -> nut: " << pairs::figures(matched));
    TriangleMesh skin = matched.result.skins.mesh(1);
    const double D = diagonal(nut.points);
    std::vector<Anchor> markers;
    for (std::size_t m = 0; m < matched.result.marker_vertices.size(); ++m) markers.push_back({matched.result.marker_vertices[m], skin.points.row(matched.result.marker_vertices[m]).transpose()});
    Stopwatch watch;
    const auto lines = sharp_lines(nut.points, sharp_curves(nut));
    const SharpPaths found = find_sharp_paths(skin, lines, markers, {mean_edge_length(skin)});
    const double seconds = watch.lap();
    CHECK(found.failed.empty());
    CHECK(sharp_truth::are_single(skin, found.paths));
    const FitSurface surface(nut);
    SharpTracking tracking(skin, surface, anchors_of(found.paths), locks(skin, markers), {.reach = 0.1 * D});
    double longest = 0;
    while (tracking.step(skin)) longest = std::max(longest, watch.lap());
    const sharp_truth::Error error = sharp_truth::error(lines, skin.points, found.paths, D);
    const SurfaceDistances apart = surface_distances(skin, nut);
    MESSAGE(found.paths.size() << " paths of " << lines.size() << " lines in " << seconds << " s, longest slice " << longest << " s, " << found.moved_markers.size() << " markers snapped; sharp edges to skin edges "
                               << 100 * error.mean << " % (most " << 100 * error.most << " %), skin to nut " << apart.mean_there / D << ", back " << apart.mean_back / D << ", 99 % " << apart.most / D
                               << ", farthest held " << tracking.farthest(skin.points) / D << ", folds " << count_folds(skin, neighbouring_triangles(skin)) << ", crossings " << self_intersections(skin).pairs);
    CHECK(error.most < 0.0005);
    CHECK(tracking.farthest(skin.points) < 1e-9);
    CHECK(self_intersections(skin).pairs == 0);
    CHECK(apart.mean_back < 2e-4 * D);
}

// What a slice costs is in SharpTracking's manual; processor time, for machines are busy.
TEST_CASE("skins made without regard to edges find all sharp edges of a nut, a bracket and a gear") {
    for (const char* name : {"generated/out/nut", "generated/out/bracket", "generated/out/gear"}) {
        const TriangleMesh model = figures::shared(name);
        if (model.vertex_count() == 0) continue;
        CAPTURE(std::string(name));
        const double D = diagonal(model.points), L = 0.009 * D;
        TriangleMesh skin = remesh(model, {L}).mesh;
        const auto lines = sharp_lines(model.points, sharp_curves(model));
        const SharpPaths found = find_sharp_paths(skin, lines, {}, {L});
        const FitSurface surface(model);
        SharpTracking tracking(skin, surface, anchors_of(found.paths), locks(skin, {}), {.reach = 0.1 * D});
        double longest = 0, sum = 0;
        for (bool more = true; more;) {
            const std::clock_t before = std::clock();
            more = tracking.step(skin);
            const double lap = static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC;
            longest = std::max(longest, lap);
            sum += lap;
        }
        const sharp_truth::Error error = sharp_truth::error(lines, skin.points, found.paths, D);
        const SurfaceDistances apart = surface_distances(skin, model);
        MESSAGE(std::string(name) << ": " << skin.vertex_count() << " vertices, " << found.paths.size() << " paths of " << lines.size() << " lines, failed " << found.failed.size() << ", sharp edges to skin edges "
                                  << 100 * error.mean << " % (most " << 100 * error.most << " %), skin to model " << apart.mean_there / D << ", back " << apart.mean_back / D << ", 99 % " << apart.most / D
                                  << ", farthest held " << tracking.farthest(skin.points) / D << ", folds " << count_folds(skin, neighbouring_triangles(skin)) << ", crossings " << self_intersections(skin).pairs << ", "
                                  << sum << " s, longest slice " << longest << " s");
        CHECK(found.failed.empty());
        CHECK(sharp_truth::are_single(skin, found.paths));
        CHECK(error.most < 0.0005);
        CHECK(tracking.farthest(skin.points) < 1e-9 * D);
        CHECK(self_intersections(skin).pairs == 0);
    }
}

TEST_CASE("meshed anew with its curves, a model's sharp edges are the skin's own") {
    for (const char* name : {"generated/out/nut", "generated/out/bracket", "generated/out/gear"}) {
        const TriangleMesh model = figures::shared(name);
        if (model.vertex_count() == 0) continue;
        CAPTURE(std::string(name));
        const double D = diagonal(model.points), L = 0.012 * D;
        const auto curves = sharp_curves(model);
        const auto lines = sharp_lines(model.points, curves);
        const Remeshed out = remesh(model, {L}, curves);
        std::vector<SharpPath> own(out.curves.size());
        for (std::size_t k = 0; k < own.size(); ++k) {
            own[k].curve = out.curves[k];
            if (own[k].curve.closed) own[k].curve.vertices.push_back(own[k].curve.vertices.front());
        }
        const sharp_truth::Error error = sharp_truth::error(lines, out.mesh.points, own, D);
        const SurfaceDistances apart = surface_distances(out.mesh, model);
        MESSAGE(std::string(name) << ": " << out.mesh.vertex_count() << " vertices, sharp edges to skin edges " << 100 * error.mean << " % (most " << 100 * error.most << " %), skin to model " << apart.mean_there / D << ", back "
                                  << apart.mean_back / D << ", folds " << count_folds(out.mesh, neighbouring_triangles(out.mesh)) << ", crossings " << self_intersections(out.mesh).pairs);
        CHECK(error.most < 0.0005);
        CHECK(apart.mean_there < 1e-4 * D);
        CHECK(apart.mean_back < 1e-4 * D);
        CHECK(self_intersections(out.mesh).pairs == 0);
        // And found again as paths they are the same, whoever asks.
        const SharpPaths found = find_sharp_paths(out.mesh, lines, {}, {L});
        CHECK(found.failed.empty());
        CHECK(sharp_truth::error(lines, out.mesh.points, found.paths, D).most < 0.0005);
    }
}
