#include "lissom/match/outer_surface.h"

#include "loose_bear.h"
#include "lissom/match/distances.h"
#include "lissom/match/match_session.h"
#include "lissom/mesh/operators.h"
#include "lissom/mesh/surface_samples.h"
#include "lissom/mesh/triangle_tree.h"
#include "refusal.h"
#include "shapes.h"

#include <doctest/doctest.h>

#include <cmath>
#include <ctime>
#include <string>
#include <utility>
#include <vector>

using namespace lissom;

namespace {

double area(const TriangleMesh& mesh) { return triangle_areas(mesh).sum(); }

/// Samples of the outer surface that lie deep inside, and samples of the true one that the outer surface leaves out: shares of all.
std::pair<double, double> wrong(const LooseShape& shape, const OuterSurface& found) {
    const TriangleMesh seen = found.seen();
    const Points places = sample_surface(seen, 20000).on(seen);
    double inside = 0;
    for (Eigen::Index i = 0; i < places.rows(); ++i) inside += shape.depth(places.row(i).transpose()) > 0.003;
    return {inside / static_cast<double>(places.rows()), std::abs(area(seen) - shape.outer_area()) / shape.outer_area()};
}

} // namespace

TEST_CASE("of primitives that overlap only the true union's surface is seen") {
    const LooseShape bear = loose_bear(4);
    const std::clock_t before = std::clock();
    const OuterSurface found = outer_surface(bear.mesh);
    const double seconds = static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC;
    const auto [inside, off] = wrong(bear, found);
    MESSAGE("bear: " << bear.mesh.triangle_count() << " triangles, cut to " << found.mesh.triangle_count() << "; hidden " << found.hidden_share << " of the area, seen area off by " << off << ", samples inside " << inside << "; " << seconds << " s");
    CHECK(found.hidden_share > 0.1);
    CHECK(inside < 0.002);
    CHECK(off < 0.005);
    // What is cut is still the same surface, and hangs together as before.
    CHECK(area(found.mesh) == doctest::Approx(area(bear.mesh)).epsilon(1e-9));
    CHECK(shapes::working(found.mesh).closed);
    CHECK(shapes::working(found.mesh).component_count == 7);
    CHECK(found.mesh.vertex_count() == bear.mesh.vertex_count() + std::ssize(found.between));
}

TEST_CASE("a soup of overlapping primitives is welded and told from within; one with holes, too, and a scattered one is left whole") {
    const LooseShape bear = loose_bear(4);
    const double D = diagonal(bear.mesh.points);
    TriangleMesh soup = shapes::soup(bear.mesh, 1e-5 * D);
    const OuterSurface welded = outer_surface(soup);
    const auto [inside, off] = wrong(bear, welded);
    MESSAGE("soup: hidden " << welded.hidden_share << ", off by " << off << ", samples inside " << inside);
    CHECK(welded.hidden_share > 0.1);
    CHECK(inside < 0.005);
    CHECK(off < 0.01);
    int row = 0;
    for (int t = 0; t < soup.triangle_count(); ++t)
        if (t % 40) soup.triangles.row(row++) = soup.triangles.row(t);
    soup.triangles.conservativeResize(row, 3);
    const OuterSurface holed = outer_surface(soup);
    const auto [inside_holed, off_holed] = wrong(bear, holed);
    MESSAGE("with holes: hidden " << holed.hidden_share << ", off by " << off_holed << ", samples inside " << inside_holed);
    CHECK(inside_holed < 0.02);
    CHECK(holed.hidden_share > 0.1);
    // Corners an edge apart are not meant to be one.
    const OuterSurface scattered = outer_surface(shapes::soup(bear.mesh, 0.01 * D));
    CHECK_FALSE(scattered.hides());
    CHECK(scattered.leader.empty());
}

TEST_CASE("what is wholly inside is hidden, whichever way it faces; pieces side by side and open sheets are not") {
    Eigen::Affine3d half = Eigen::Affine3d::Identity();
    half.scale(0.5);
    const TriangleMesh ball = shapes::icosphere(3), inner = shapes::moved(ball, half);
    for (const bool turned : {false, true}) {
        const TriangleMesh nested = shapes::joined({ball, turned ? shapes::turned_inside_out(inner) : inner});
        const OuterSurface found = outer_surface(nested);
        CHECK(found.hidden_share == doctest::Approx(0.2).epsilon(0.01));
        CHECK(found.between.empty());
    }
    CHECK_FALSE(outer_surface(shapes::two_spheres(3)).hides());
    CHECK_FALSE(outer_surface(shapes::bumpy_sheet()).hides());
    CHECK_FALSE(outer_surface(shapes::three_sheets()).hides());
    CHECK(refusal([] { (void)outer_surface(shapes::icosphere(2), {.cells = 5}); }) == "bad-option");
    CHECK(refusal([] { (void)outer_surface({Points::Zero(3, 3), Triangles::Zero(1, 3)}); }) == "flat-model");
}

TEST_CASE("an outer surface goes with its model in another unit, and flags and chains are carried onto it") {
    const LooseShape bear = loose_bear(2);
    TriangleMesh large = bear.mesh;
    large.points *= 1024;
    const OuterSurface a = outer_surface(bear.mesh), b = outer_surface(large);
    CHECK(a.mesh.triangles == b.mesh.triangles);
    CHECK(a.hidden == b.hidden);
    std::vector<char> flags(static_cast<std::size_t>(bear.mesh.vertex_count()), 1);
    flags[0] = 0;
    const std::vector<char> carried = a.carried(flags);
    REQUIRE(std::ssize(carried) == a.mesh.vertex_count());
    for (std::size_t i = 0; i < a.between.size(); ++i) CHECK(carried[flags.size() + i] == (carried[a.between[i][0]] && carried[a.between[i][1]]));
    // Edges of the model: what is left of them is seen, and is no longer than they are.
    int whole = 0, cut = 0, gone = 0;
    for (int t = 0; t < bear.mesh.triangle_count(); t += 19) {
        const int from = bear.mesh.triangles(t, 0), to = bear.mesh.triangles(t, 1);
        double length = 0;
        const auto pieces = a.along({from, to});
        for (const auto& piece : pieces)
            for (std::size_t i = 0; i + 1 < piece.size(); ++i) length += (a.mesh.points.row(piece[i]) - a.mesh.points.row(piece[i + 1])).norm();
        const double all = (bear.mesh.points.row(from) - bear.mesh.points.row(to)).norm();
        CHECK(length < all * (1 + 1e-9));
        (pieces.empty() ? gone : length > all * (1 - 1e-9) ? whole : cut) += 1;
    }
    CHECK(whole > 0);
    CHECK(cut > 0);
    CHECK(gone > 0);
    CHECK(a.along({-1, 2}) == std::vector<std::vector<int>>{{-1, 2}});
}

TEST_CASE("a bear of seven loose primitives and a surface in one piece get skins on what is seen of them, either way round") {
    const LooseShape bear = loose_bear(4);
    const WorkingMesh loose = shapes::working(bear.mesh);
    const WorkingMesh ball = shapes::working(shapes::moved(shapes::icosphere(5), Eigen::Affine3d(Eigen::Scaling(0.5, 0.8, 0.4))));
    Points on_bear(6, 3), on_ball(6, 3);
    on_bear << 0, 0.2, 0.1, 0, 1.5, 0.03, 0.64, 0.78, 0.08, -0.64, 0.78, 0.08, 0, 1.2, 0.32, 0, 0.62, -0.3;
    on_ball << 0, -0.8, 0, 0, 0.8, 0, 0.5, 0, 0, -0.5, 0, 0, 0, 0.4, 0.346, 0, 0, -0.4;
    const double D = diagonal(bear.mesh.points);
    for (const bool source : {true, false}) {
        const MatchModel a{&loose, on_bear}, b{&ball, on_ball};
        MatchSession session(source ? std::vector{a, b} : std::vector{b, a}, {.edge_length = 0.012});
        while (session.step()) {
        }
        const MatchResult out = session.result();
        const int k = source ? 0 : 1;
        const SkinReport& report = out.report.skins[static_cast<std::size_t>(k)];
        const TriangleMesh skin{out.skins.points[static_cast<std::size_t>(k)], out.skins.triangles};
        // Truth: by the formula, not by what was found to be hidden.
        const Points true_places = bear.outer_places(20000);
        const TriangleTree tree(skin);
        double back = 0, there = 0;
        for (Eigen::Index i = 0; i < true_places.rows(); ++i) back += tree.nearest(true_places.row(i).transpose()).distance / D / static_cast<double>(true_places.rows());
        const Points places = sample_surface(skin, 20000).on(skin);
        for (Eigen::Index i = 0; i < places.rows(); ++i) there += std::abs(bear.depth(places.row(i).transpose())) / D / static_cast<double>(places.rows());
        MESSAGE((source ? "bear first: " : "ball first: ") << skin.vertex_count() << " vertices; reported " << report.distances.mean_there << ", back " << report.distances.mean_back << ", 99 % " << report.distances.most << "; by the formula " << there << ", "
                                                           << back << "; crossings " << report.crossings << ", folds " << report.folds << ", flipped " << report.flipped << "; " << out.report.seconds.sum() << " s");
        CHECK(report.distances.mean_there < 0.001);
        CHECK(report.distances.mean_back < 0.001);
        CHECK(there < 0.001);
        CHECK(back < 0.001);
        for (const SkinReport& each : out.report.skins) CHECK(each.crossings == 0);
    }
}
