#include "lissom/match/match_session.h"

#include "lissom/match/fit_surface.h"
#include "lissom/match/marker_curves.h"

#include "../refusal.h"
#include "armed.h"
#include "lissom/mesh/errors.h"
#include "lissom/mesh/operators.h"
#include "lissom/mesh/self_intersections.h"
#include "lissom/mesh/topology.h"
#include "shapes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace lissom;
using armed::figure;
using armed::some;
using Eigen::Affine3d;
using Eigen::RowVector3d;
using Eigen::Vector3d;

namespace {

/// Runs a match to its end.
MatchResult matched(const TriangleMesh& source, const TriangleMesh& target, const Points& from, const Points& to, const MatchOptions& options = {}) {
    const WorkingMesh a = shapes::working(source), b = shapes::working(target);
    MatchSession session({{&a, from}, {&b, to}}, options);
    double before = 0;
    while (session.step()) {
        CHECK(session.fraction() >= before);
        before = session.fraction();
    }
    CHECK(session.fraction() == 1);
    return session.result();
}

Affine3d placed(double scale) { return Eigen::Translation3d(scale * Vector3d(3, -2, 7)) * Eigen::AngleAxisd(2.3, Vector3d(1, -2, 3).normalized()) * Eigen::Scaling(scale); }

bool has(const MatchReport& report, const std::string& code) {
    return std::any_of(report.warnings.begin(), report.warnings.end(), [&](const MatchWarning& w) { return w.code == code; });
}

} // namespace

TEST_CASE("a model matched to itself is itself, with and without changes of edges") {
    const TriangleMesh mesh = figure(0, 3);
    for (const bool connectivity : {false, true})
        for (const int count : {0, 12}) {
            CAPTURE(count);
            const MatchResult result = matched(mesh, mesh, some(mesh, count), some(mesh, count), {.connectivity = connectivity});
            const double D = diagonal(mesh.points);
            // Both skins are kept on their model by ways of their own once edges change: they slide by a little of an edge against each other.
            CHECK((result.skins.points[0] - result.skins.points[1]).rowwise().norm().maxCoeff() < (connectivity ? 0.1 * mean_edge_length(mesh) : 1e-9 * D));
            if (!connectivity) {
                CHECK(result.skins.triangles == mesh.triangles);
                CHECK((result.skins.points[1] - mesh.points).rowwise().norm().maxCoeff() < 1e-9 * D);
            }
            CHECK(result.report.marker_error < 1e-12);
            CHECK(result.report.skins[1].distances.mean_there < 3e-3);
            CHECK(result.report.skins[1].flipped == 0);
        }
}

TEST_CASE("two figures: skins of one connectivity on both, markers met, nothing crossed, turned over or left behind") {
    const TriangleMesh a = figure(), b = figure(0.5);
    const MatchResult result = matched(a, b, some(a), some(b));
    const MatchReport& report = result.report;
    MESSAGE("distances " << report.skins[1].distances.mean_there << " / " << report.skins[1].distances.mean_back << ", 99 % " << report.skins[1].distances.most << ", source's " << report.skins[0].distances.mean_there << " / "
                         << report.skins[0].distances.mean_back << ", folds " << report.skins[1].folds << ", " << report.connectivity.splits << " splits, " << report.connectivity.collapses
                         << " collapses, " << report.connectivity.swaps << " swaps, " << report.seconds.sum() << " s");
    CHECK(result.skins.points[0].rows() == result.skins.points[1].rows());
    CHECK(report.marker_error < 1e-12);
    CHECK(report.skins[0].crossings == 0);
    CHECK(report.skins[1].crossings == 0);
    CHECK(report.skins[1].flipped == 0);
    CHECK(report.skins[1].distances.mean_there < 8e-4);
    CHECK(report.skins[1].distances.mean_back < 8e-4);
    CHECK(report.skins[1].distances.most < 0.005);
    CHECK(report.skins[0].distances.most < 0.005);
    CHECK(report.connectivity.any());
    CHECK(std::ssize(report.skins[1].residuals) == result.skins.vertex_count());
    CHECK(euler_characteristic(result.skins.mesh(0)) == 2);
    for (int m = 0; m < 12; ++m) {
        const int v = result.marker_vertices[static_cast<std::size_t>(m)];
        CHECK((result.skins.points[0].row(v) - a.points.row(m)).norm() < 1e-12 * diagonal(a.points));
        CHECK((result.skins.points[1].row(v) - b.points.row(m)).norm() < 1e-12 * diagonal(b.points));
    }
}

TEST_CASE("of both starts the better one is kept: a bent arm is bent by its markers, what has one pose is not") {
    // A tapered arm, straight and bent by a right angle about z.
    TriangleMesh straight = shapes::box(6, 40, 6, {1, 8, 1.4});
    for (int v = 0; v < straight.vertex_count(); ++v) {
        const double taper = 1.2 - 0.08 * straight.points(v, 1);
        straight.points(v, 0) *= taper;
        straight.points(v, 2) *= taper * (1 + 0.05 * straight.points(v, 0));
    }
    TriangleMesh bent = straight;
    for (int v = 0; v < bent.vertex_count(); ++v) {
        const RowVector3d p = straight.points.row(v);
        const double turn = std::clamp((p.y() - 2) / 4, 0.0, 1.0) * M_PI / 2, beyond = std::max(0.0, p.y() - 6), along = std::min(p.y(), 2.0), r = 8 / M_PI;
        bent.points.row(v) << r - (r - p.x()) * std::cos(turn) + beyond * std::sin(turn), along + (r - p.x()) * std::sin(turn) + beyond * std::cos(turn), p.z();
    }
    Points from(16, 3), to(16, 3);
    int m = 0;
    for (int v = 0; v < straight.vertex_count() && m < 16; ++v)
        if (v % (straight.vertex_count() / 16) == 0) {
            from.row(m) = straight.points.row(v);
            to.row(m++) = bent.points.row(v);
        }
    const MatchOptions options{.connectivity = false, .levels = 2, .fine_steps = 4};
    const MatchResult kept = matched(straight, bent, from, to, options);
    CHECK(kept.report.skins[1].bent);
    const auto apart = [&](const MatchResult& result) { return (result.skins.points[1] - bent.points).rowwise().norm().mean(); };
    MatchOptions similar = options;
    similar.start = MatchStart::similarity;
    const MatchResult other = matched(straight, bent, from, to, similar);
    CHECK_FALSE(other.report.skins[1].bent);
    MESSAGE("bent start " << apart(kept) << ", similarity " << apart(other));
    CHECK(apart(kept) < apart(other));
    const TriangleMesh a = figure(0, 3), b = figure(0.3, 3);
    CHECK_FALSE(matched(a, b, some(a), some(b), options).report.skins[1].bent);
    MatchOptions radial = options;
    radial.start = MatchStart::radial;
    CHECK(matched(a, b, some(a), some(b), radial).report.skins[1].bent);
}

TEST_CASE("four figures get skins of one connectivity at once") {
    const TriangleMesh a = figure(0, 3), b = figure(0.5, 3), c = figure(-0.3, 4), d = figure(0.2, 3);
    std::vector<WorkingMesh> working;
    for (const TriangleMesh* mesh : {&a, &b, &c, &d}) working.push_back(shapes::working(*mesh));
    MatchSession session({{&working[0], some(a)}, {&working[1], some(b)}, {&working[2], some(c)}, {&working[3], some(d)}});
    CHECK(session.positions(3).rows() == 0);
    double before = 0;
    while (session.step()) {
        CHECK(session.fraction() >= before);
        before = session.fraction();
        for (int k = 0; k < 4; ++k) CHECK(session.positions(k).rows() == session.positions(0).rows());
    }
    CHECK(session.fraction() == 1);
    const MatchResult result = session.result();
    REQUIRE(result.skins.count() == 4);
    REQUIRE(result.report.skins.size() == 4);
    CHECK(result.report.connectivity.any());
    CHECK(result.report.marker_error < 1e-12);
    for (const SkinReport& skin : result.report.skins) {
        CHECK(skin.crossings == 0);
        CHECK(skin.flipped == 0);
        CHECK(skin.distances.mean_there < 3e-3); // of edges as long as the model is coarse
        CHECK(skin.distances.mean_back < 3e-3);
        CHECK(std::ssize(skin.residuals) == result.skins.vertex_count());
    }
}

TEST_CASE("a target is carried the same whatever the other targets are: only edges know of one another") {
    const TriangleMesh a = figure(0, 3), b = figure(0.5, 3), c = figure(-0.3, 3);
    const MatchOptions options{.connectivity = false, .levels = 2, .fine_steps = 4};
    const WorkingMesh s = shapes::working(a), t = shapes::working(b), u = shapes::working(c);
    MatchSession session({{&s, some(a)}, {&t, some(b)}, {&u, some(c)}}, options);
    while (session.step()) {
    }
    const SkinSet together = session.result().skins;
    const MatchResult first = matched(a, b, some(a), some(b), options), second = matched(a, c, some(a), some(c), options);
    CHECK((together.points[1] - first.skins.points[1]).rowwise().norm().maxCoeff() < 1e-9);
    CHECK((together.points[2] - second.skins.points[1]).rowwise().norm().maxCoeff() < 1e-9);
}

TEST_CASE("what lies between markers corresponds: vertices find their own image") {
    const TriangleMesh a = figure(), b = figure(0.5);
    const MatchResult result = matched(a, b, some(a), some(b), {.connectivity = false});
    const double apart = (result.skins.points[1] - b.points).rowwise().norm().mean() / diagonal(b.points);
    MESSAGE("mean " << apart << " of the diagonal from the true image");
    CHECK(apart < 0.004);
}

TEST_CASE("scaling, turning and moving either model goes along") {
    const TriangleMesh a = figure(0, 3), b = figure(0.4, 3);
    const MatchResult here = matched(a, b, some(a), some(b));
    CHECK(here.report.connectivity.any());
    for (const double scale : {1e-4, 1e4}) {
        const TriangleMesh c = shapes::moved(a, placed(scale)), d = shapes::moved(b, placed(3 / scale));
        const MatchResult there = matched(c, d, some(c), some(d));
        REQUIRE(here.skins.triangles.rows() == there.skins.triangles.rows());
        CHECK(here.skins.triangles == there.skins.triangles);
        CHECK((shapes::moved(here.skins.mesh(0), placed(scale)).points - there.skins.points[0]).rowwise().norm().maxCoeff() < 1e-9 * diagonal(c.points));
        CHECK((shapes::moved(here.skins.mesh(1), placed(3 / scale)).points - there.skins.points[1]).rowwise().norm().maxCoeff() < 1e-9 * diagonal(d.points));
    }
}

TEST_CASE("the same comes out every time, another seed makes little difference") {
    const TriangleMesh a = figure(0, 3), b = figure(0.4, 3);
    const MatchResult once = matched(a, b, some(a), some(b), {.levels = 2, .fine_steps = 7}), twice = matched(a, b, some(a), some(b), {.levels = 2, .fine_steps = 7}),
                      other = matched(a, b, some(a), some(b), {.levels = 2, .fine_steps = 7, .seed = 7});
    CHECK(once.skins.triangles == twice.skins.triangles);
    CHECK(once.skins.points[0] == twice.skins.points[0]);
    CHECK(once.skins.points[1] == twice.skins.points[1]);
    CHECK(other.report.skins[1].distances.mean_back < 2 * once.report.skins[1].distances.mean_back + 1e-4);
}

TEST_CASE("the target's connectivity does not matter: as a soup it gives nearly the same skin") {
    const TriangleMesh a = figure(0, 3), b = figure(0.4, 4);
    const MatchOptions options{.connectivity = false};
    const MatchResult clean = matched(a, b, some(a), some(b), options);
    const double D = diagonal(b.points);
    const TriangleMesh torn = shapes::soup(b, 1e-4 * D);
    const MatchResult soup = matched(a, torn, some(a), some(b), options);
    const double apart = (soup.skins.points[1] - clean.skins.points[1]).rowwise().norm().mean() / D;
    MESSAGE("soup: mean " << apart << " of the diagonal from the clean target's skin");
    CHECK(apart < 5e-4);
    CHECK(soup.report.skins[1].distances.mean_there < clean.report.skins[1].distances.mean_there + 2e-4);
    CHECK(soup.report.skins[1].crossings == 0);
}

TEST_CASE("open models keep their borders on each other") {
    TriangleMesh a = shapes::bumpy_sheet(24, 24), b = shapes::bumpy_sheet(31, 31);
    for (int v = 0; v < b.vertex_count(); ++v) b.points(v, 2) += 0.15 * b.points(v, 0) * b.points(v, 0) + 0.05 * std::sin(5 * b.points(v, 1));
    const auto corners = [](const TriangleMesh& mesh, int n) {
        Points four(4, 3);
        int k = 0;
        for (const int v : {0, n, n * (n + 1), (n + 1) * (n + 1) - 1}) four.row(k++) = mesh.points.row(v);
        return four;
    };
    const MatchResult result = matched(a, b, corners(a, 24), corners(b, 31));
    CHECK(boundary_loops(result.skins.mesh(1)).size() == 1);
    CHECK(result.report.skins[1].distances.mean_there < 1e-3);
    CHECK(result.report.skins[1].distances.mean_back < 2e-3);
    CHECK(result.report.skins[1].distances.most < 0.01);
    CHECK(result.report.skins[1].crossings == 0);
}

TEST_CASE("few, flat, one-sided and crowded markers give a finite match") {
    const TriangleMesh a = figure(0, 3), b = figure(0.4, 3);
    const auto pick = [](const TriangleMesh& mesh, auto chosen) {
        std::vector<int> list;
        const TriangleMesh rest = figure(0, 3);
        for (int v = 0; v < mesh.vertex_count() && list.size() < 8; ++v)
            if (chosen(Vector3d(rest.points.row(v)))) list.push_back(v);
        Points places(std::ssize(list), 3);
        for (std::size_t k = 0; k < list.size(); ++k) places.row(static_cast<Eigen::Index>(k)) = mesh.points.row(list[k]);
        return places;
    };
    const auto check = [&](const char* name, const Points& from, const Points& to) {
        CAPTURE(name);
        const MatchResult result = matched(a, b, from, to, {.levels = 2, .fine_steps = 4});
        CHECK(result.skins.points[1].allFinite());
        CHECK(std::isfinite(result.report.skins[1].distances.mean_there));
        CHECK(result.report.skins[1].distances.mean_there < 0.02);
        return result.report;
    };
    for (const int n : {0, 1, 2, 3, 4}) (void)check("few", some(a, n), some(b, n));
    const auto flat = [](const Vector3d& p) { return std::abs(p.z()) < 0.03; };
    const MatchReport of_flat = check("flat", pick(a, flat), pick(b, flat));
    CHECK(has(of_flat, "markers-flat"));
    CHECK_FALSE(of_flat.skins[1].bent);
    const auto one_side = [](const Vector3d& p) { return p.x() > 0.6; };
    (void)check("one side", pick(a, one_side), pick(b, one_side));
    Points same_from(6, 3), same_to(6, 3);
    same_from.rowwise() = a.points.row(5);
    same_to.rowwise() = b.points.row(5);
    (void)check("all in one place", same_from, same_to);
}

TEST_CASE("the paper's own loop: markers met, edges of all skins alike, an end; and what it cannot do is told") {
    const TriangleMesh a = figure(0, 3), b = figure(0.5, 3);
    const MatchResult result = matched(a, b, some(a), some(b), {.method = MatchMethod::paper});
    const MatchReport& report = result.report;
    MESSAGE("paper's loop: skin to model " << report.skins[1].distances.mean_there << ", back " << report.skins[1].distances.mean_back << ", 99 % " << report.skins[1].distances.most << ", crossings "
                                           << report.skins[1].crossings << ", folds " << report.skins[1].folds << ", " << result.skins.vertex_count() << " vertices");
    CHECK(report.marker_error < 1e-12);
    CHECK(report.skins[1].distances.mean_there < 5e-3);
    CHECK(report.skins[1].distances.mean_back < 0.02);
    CHECK(euler_characteristic(result.skins.mesh(0)) == 2);
    CHECK(result.skins.vertex_count() <= 4 * a.vertex_count());
    CHECK(report.connectivity.any());
    // A box around a figure with arms: the loop ends, within the vertices allowed.
    TriangleMesh box = shapes::box(14, 14, 14, {2.6, 2.6, 2.6});
    box.points.col(1).array() -= 1.3;
    const MatchResult from_box = matched(box, b, Points(0, 3), Points(0, 3), {.method = MatchMethod::paper, .most_vertices = 3000});
    CHECK(from_box.skins.vertex_count() <= 3000);
    CHECK(from_box.skins.points[1].allFinite());
}

TEST_CASE("first skins: a remesh, a wrap around a torn source, and the paper's simple shapes") {
    const TriangleMesh a = figure(0, 4), b = figure(0.5, 4);
    const MatchResult even = matched(a, b, some(a), some(b), {.first = FirstSkin::remesh, .edge_length = 0.05});
    CHECK(even.skins.vertex_count() < a.vertex_count());
    CHECK(even.report.marker_error < 1e-12);
    for (const SkinReport& skin : even.report.skins) {
        CHECK(skin.crossings == 0);
        CHECK(skin.distances.mean_there < 2e-3);
        CHECK(skin.distances.mean_back < 2e-3);
    }
    const TriangleMesh torn = shapes::soup(a, 1e-4 * diagonal(a.points));
    const MatchResult wrapped = matched(torn, b, some(a), some(b), {.first = FirstSkin::wrap, .edge_length = 0.04});
    MESSAGE("wrapped soup: source's skin " << wrapped.report.skins[0].distances.mean_there << ", back " << wrapped.report.skins[0].distances.mean_back << ", 99 % " << wrapped.report.skins[0].distances.most
                                           << ", target's " << wrapped.report.skins[1].distances.mean_back << ", " << wrapped.skins.vertex_count() << " vertices");
    CHECK(boundary_loops(wrapped.skins.mesh(1)).empty());
    CHECK(euler_characteristic(wrapped.skins.mesh(1)) == 2);
    for (const SkinReport& skin : wrapped.report.skins) {
        CHECK(skin.crossings == 0);
        CHECK(skin.distances.mean_there < 2e-3);
        CHECK(skin.distances.mean_back < 2e-3);
    }
    const TriangleMesh egg = shapes::bumpy_sphere(4);
    for (const FirstSkin first : {FirstSkin::box, FirstSkin::sphere}) {
        const MatchResult shape = matched(egg, egg, Points(0, 3), Points(0, 3), {.first = first, .edge_length = 0.05});
        CHECK(shape.report.skins[1].distances.mean_back < 3e-3);
        CHECK(shape.report.skins[1].crossings == 0);
    }
    const MatchResult ring = matched(shapes::torus(64, 32), shapes::torus(48, 24), Points(0, 3), Points(0, 3), {.first = FirstSkin::torus, .edge_length = 0.05});
    CHECK(ring.report.skins[1].distances.mean_back < 3e-3);
    CHECK(euler_characteristic(ring.skins.mesh(0)) == 0);
}

TEST_CASE("masks: an arm that the target alone has is left out, an arm that the source alone has keeps its shape") {
    const TriangleMesh a = figure(0, 4);
    // The same without its first arm: pressed flat onto the ball.
    TriangleMesh b = a;
    std::vector<int> arm;
    const Vector3d first = Vector3d(1, 0.2, 0.1).normalized();
    for (int v = 0; v < b.vertex_count(); ++v) {
        const Vector3d d = b.points.row(v).normalized();
        if (d.dot(first) > 0.75) arm.push_back(v);
        if (d.dot(first) < 0.8) continue;
        b.points.row(v) = (std::min(b.points.row(v).norm(), 0.56) * d).transpose();
    }
    Points from(0, 3), to(0, 3);
    for (int m = 0; m < 12; ++m)
        if (a.points.row(m).normalized().dot(first) < 0.75) {
            from.conservativeResize(from.rows() + 1, 3);
            to.conservativeResize(to.rows() + 1, 3);
            from.row(from.rows() - 1) = a.points.row(m);
            to.row(to.rows() - 1) = b.points.row(m);
        }
    const WorkingMesh with = shapes::working(a), without = shapes::working(b);
    const auto run = [&](const MatchModel& source, const MatchModel& target, bool connectivity) {
        MatchSession session({source, target}, {.connectivity = connectivity});
        while (session.step()) {
        }
        return session.result();
    };
    const auto tallest = [&](const Points& points) { return (points * first).maxCoeff(); };
    const double arm_height = tallest(a.points);
    for (const bool connectivity : {false, true}) {
        CAPTURE(connectivity);
        // The target has an arm more: masked, nothing of the skin goes up it.
        const MatchResult drawn = run({&without, to}, {&with, from}, connectivity), left = run({&without, to}, {&with, from, arm}, connectivity);
        MESSAGE("height reached: " << tallest(drawn.skins.points[1]) << " unmasked, " << tallest(left.skins.points[1]) << " masked, of " << arm_height);
        CHECK(tallest(left.skins.points[1]) < 0.7);
        CHECK(left.report.skins[1].distances.mean_back < 2e-3);
        // The source has an arm more: masked, as the place where the target has none, it stays an arm.
        const MatchResult pressed = run({&with, from}, {&without, to}, connectivity), kept = run({&with, from, arm}, {&without, to, arm}, connectivity);
        MESSAGE("height kept: " << tallest(pressed.skins.points[1]) << " unmasked, " << tallest(kept.skins.points[1]) << " masked, of " << arm_height);
        CHECK(tallest(kept.skins.points[1]) > 0.85 * arm_height);
        CHECK(tallest(pressed.skins.points[1]) < 0.75 * arm_height);
        CHECK(kept.report.skins[1].distances.mean_there < 2e-3);
    }
}

TEST_CASE("a marker curve brings what it runs along onto the other, where markers alone leave it aside") {
    // A ball with nothing on it that tells directions: markers at the poles and around the equator, a curve along a meridian that is bent on the other.
    const TriangleMesh ball = shapes::icosphere(4);
    const auto meridian = [](double bend) {
        Points line(40, 3);
        for (int i = 0; i < 40; ++i) {
            const double up = -1 + 2 * i / 39.0, angle = bend * std::sin(M_PI * up);
            line.row(i) << std::cos(angle) * std::cos(up), std::sin(angle) * std::cos(up), std::sin(up);
        }
        return line;
    };
    Points six(6, 3);
    six << 0, 0, 1, 0, 0, -1, 1, 0, 0, 0, 1, 0, -1, 0, 0, 0, -1, 0;
    const WorkingMesh working = shapes::working(ball);
    const auto apart = [&](const std::vector<Points>& from, const std::vector<Points>& to) {
        MatchSession session({{&working, six, {}, from}, {&working, six, {}, to}}, {.connectivity = true});
        while (session.step()) {
        }
        const MatchResult result = session.result();
        CHECK(result.report.skins[1].crossings == 0);
        const FitSurface skin(result.skins.mesh(0));
        const Points line = places_along_polyline(meridian(0), 40), other = places_along_polyline(meridian(0.4), 40);
        double sum = 0;
        for (int i = 0; i < 40; ++i) {
            const auto at = skin.nearest(line.row(i), Vector3d::Zero(), -1, 1);
            const Vector3d weights = corner_weights(skin.mesh(), at.triangle, at.point);
            RowVector3d image = RowVector3d::Zero();
            for (int k = 0; k < 3; ++k) image += weights[k] * result.skins.points[1].row(skin.mesh().triangles(at.triangle, k));
            sum += (image - other.row(i)).norm() / 40;
        }
        return sum;
    };
    const double by_markers = apart({}, {}), by_curve = apart({meridian(0)}, {meridian(0.4)});
    MESSAGE("from the curve: " << by_markers << " by markers alone, " << by_curve << " by the curve");
    CHECK(by_curve < 0.1 * by_markers);
    CHECK(by_markers > 0.1);
}

TEST_CASE("lengths that adapt put vertices where surfaces are curved: nearer to the model with as many") {
    const TriangleMesh a = figure(0, 4), b = figure(0.5, 4);
    const MatchResult even = matched(a, b, some(a), some(b), {.edge_length = 0.045, .fine_steps = 18}), adapted = matched(a, b, some(a), some(b), {.edge_length = 0.045, .fine_steps = 18, .adapt = 1});
    const auto most = [](const MatchResult& r) { return std::max(r.report.skins[0].distances.most, r.report.skins[1].distances.most); };
    MESSAGE(even.skins.vertex_count() << " even: 99 % " << most(even) << "; " << adapted.skins.vertex_count() << " adapted: " << most(adapted));
    CHECK(adapted.skins.vertex_count() < even.skins.vertex_count());
    CHECK(most(adapted) < 0.95 * most(even));
    CHECK(adapted.report.skins[1].crossings == 0);
}

TEST_CASE("where it is worst is told: at an arm that the source has not got") {
    const TriangleMesh a = figure(0, 4);
    TriangleMesh b = a;
    const Vector3d up = Vector3d(-1, -1, 1).normalized();
    for (int v = 0; v < b.vertex_count(); ++v) {
        const Vector3d d = a.points.row(v).normalized();
        b.points.row(v) += 0.6 * std::exp(200 * (d.dot(up) - 1)) * d.transpose();
    }
    const MatchResult result = matched(a, b, some(a), some(b), {.connectivity = false, .levels = 2, .fine_steps = 4});
    const SkinReport& report = result.report.skins[1];
    REQUIRE(report.worst.size() > 1);
    CHECK(report.worst.size() <= 5);
    CHECK(result.skins.points[1].row(report.worst[0]).normalized().dot(up) > 0.95);
    for (std::size_t k = 1; k < report.worst.size(); ++k) CHECK(report.residuals[report.worst[k]] <= report.residuals[report.worst[k - 1]]);
}

TEST_CASE("what is wrong with markers is said") {
    const TriangleMesh a = figure(0, 3), b = figure(0.1, 3);
    TriangleMesh mirror = shapes::turned_inside_out(b);
    mirror.points.col(0) *= -1;
    const MatchOptions quick{.connectivity = false, .levels = 1, .fine_steps = 1};
    CHECK(has(matched(a, mirror, some(a), some(mirror), quick).report, "markers-mirrored"));
    CHECK_FALSE(has(matched(a, b, some(a), some(b), quick).report, "markers-mirrored"));
    Points to = some(b);
    to.row(2).swap(to.row(9));
    const MatchReport report = matched(a, b, some(a), to, quick).report;
    REQUIRE(has(report, "markers-swapped"));
    Points away = 1.5 * some(a);
    CHECK(has(matched(a, b, away, some(b), quick).report, "markers-moved"));
}

TEST_CASE("models of different kinds are matched all the same, and told to be") {
    const MatchOptions quick{.levels = 2, .fine_steps = 4};
    const TriangleMesh ball = shapes::bumpy_sphere(3);
    const auto report_of = [&](const TriangleMesh& a, const TriangleMesh& b) {
        const MatchResult result = matched(a, b, Points(0, 3), Points(0, 3), quick);
        CHECK(result.skins.points[1].allFinite());
        return result.report;
    };
    const MatchReport genus = report_of(ball, shapes::torus());
    CHECK(has(genus, "genus-differs"));
    CHECK_FALSE(has(genus, "pieces-differ"));
    CHECK(has(report_of(shapes::torus(), shapes::double_torus(3)), "genus-differs"));
    for (const auto& [a, b] : {std::pair(ball, shapes::two_spheres(3)), std::pair(shapes::two_spheres(3), ball)}) CHECK(has(report_of(a, b), "pieces-differ"));
    for (const auto& [a, b] : {std::pair(ball, shapes::bumpy_sheet(16, 16)), std::pair(shapes::bumpy_sheet(16, 16), ball)}) CHECK(has(report_of(a, b), "borders-differ"));
    const MatchReport same = report_of(ball, shapes::bumpy_sphere(2));
    for (const char* code : {"genus-differs", "pieces-differ", "borders-differ", "poses-differ", "markers-one-sided"}) CHECK_FALSE(has(same, code));
    CHECK_FALSE(has(report_of(ball, shapes::soup(ball)), "pieces-differ"));
}

TEST_CASE("markers on one side, markers in one place and two hundred markers are told and survived") {
    const TriangleMesh a = figure(0, 3), b = figure(0.4, 3);
    const MatchOptions quick{.levels = 2, .fine_steps = 4};
    std::vector<int> side;
    for (int v = 0; v < a.vertex_count() && side.size() < 9; v += 3)
        if (a.points(v, 0) > 0.3) side.push_back(v);
    const auto places = [](const TriangleMesh& mesh, const std::vector<int>& list) {
        Points rows(std::ssize(list), 3);
        for (std::size_t k = 0; k < list.size(); ++k) rows.row(static_cast<Eigen::Index>(k)) = mesh.points.row(list[k]);
        return rows;
    };
    CHECK(has(matched(a, b, places(a, side), places(b, side), quick).report, "markers-one-sided"));
    CHECK_FALSE(has(matched(a, b, some(a), some(b), quick).report, "markers-one-sided"));

    std::vector<int> twice{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 4, 7}, clash = twice;
    clash[12] = 100; // one place on the source, two on the target
    for (const auto& on_target : {twice, clash}) {
        const MatchResult result = matched(a, b, places(a, twice), places(b, on_target), quick);
        REQUIRE(has(result.report, "markers-coincide"));
        CHECK(result.marker_vertices[12] == result.marker_vertices[4]);
        CHECK(result.marker_vertices[13] == result.marker_vertices[7]);
        CHECK(result.report.marker_error < 1e-12);
        CHECK(result.report.skins[1].crossings == 0);
    }

    std::vector<int> many;
    for (int k = 0; k < 200; ++k) many.push_back(3 * k);
    const MatchResult result = matched(a, b, places(a, many), places(b, many), quick);
    CHECK(result.report.marker_error < 1e-12);
    CHECK(result.report.skins[1].crossings == 0);
    CHECK(result.report.skins[1].distances.mean_there < 2e-3);
    CHECK(std::find(result.marker_vertices.begin(), result.marker_vertices.end(), -1) == result.marker_vertices.end());
}

TEST_CASE("a match may be stopped at any step and still has skins and a report") {
    const TriangleMesh a = figure(0, 3), b = figure(0.4, 3);
    const WorkingMesh s = shapes::working(a), t = shapes::working(b);
    MatchSession session({{&s, some(a)}, {&t, some(b)}});
    CHECK(refusal([&] { (void)session.result(); }) == "not-begun");
    int steps = 0;
    while (session.step())
        if (++steps % 25 == 1) {
            const MatchResult now = session.result();
            CHECK(now.skins.points[1].allFinite());
            CHECK(has(now.report, "stopped-early"));
            CHECK(session.positions(1).rows() == now.skins.vertex_count());
        }
    CHECK_FALSE(has(session.result().report, "stopped-early"));
    CHECK_FALSE(session.step());
}

TEST_CASE("skins do not grow beyond what is allowed, and say so") {
    const TriangleMesh a = figure(0, 3), b = figure(0.4, 3);
    const MatchResult result = matched(a, b, some(a), some(b), {.edge_length = 0.01, .most_vertices = 900});
    CHECK(result.skins.vertex_count() <= 900);
    CHECK(has(result.report, "skins-full"));
    for (const FirstSkin first : {FirstSkin::remesh, FirstSkin::wrap, FirstSkin::box}) {
        const MatchResult anew = matched(a, b, some(a), some(b), {.first = first, .edge_length = 1e-6, .levels = 1, .fine_steps = 1, .most_vertices = 900});
        CHECK(anew.skins.vertex_count() < 3000);
        CHECK(has(anew.report, "first-full"));
    }
}

TEST_CASE("models without area and options out of range are refused; broken models are matched") {
    const TriangleMesh ball = shapes::bumpy_sphere(2);
    const Points none(0, 3);
    const WorkingMesh good = shapes::working(ball);
    TriangleMesh line = ball;
    line.points.rightCols(2).setZero();
    const WorkingMesh flat = shapes::working(line);
    CHECK(refusal([&] { MatchSession({{&flat, none}, {&good, none}}); }) == "flat-model");
    CHECK(refusal([&] { MatchSession({{&good, none}, {&flat, none}}); }) == "flat-model");
    CHECK(refusal([&] { MatchSession({{&good, none}, {&good, Points::Zero(1, 3)}}); }) == "marker-count");
    CHECK(refusal([&] { MatchSession({{&good, none}}); }) == "model-count");
    CHECK(refusal([&] { MatchSession({{&good, Points::Constant(1, 3, std::nan(""))}, {&good, Points::Zero(1, 3)}}); }) == "non-finite-marker");
    const Points dot = Points::Zero(3, 3);
    Points way(2, 3);
    way << 0, 0, 0, 1, 0, 0;
    CHECK(refusal([&] { MatchSession({{&good, none, {}, {way}}, {&good, none}}); }) == "curve-count");
    CHECK(refusal([&] { MatchSession({{&good, none, {}, {way}}, {&good, none, {}, {dot}}}); }) == "bad-curve");
    CHECK(refusal([&] { MatchSession({{&good, none, {1000000}}, {&good, none}}); }) == "bad-mask");
    std::vector<int> everything;
    for (int v = 0; v < ball.vertex_count(); ++v) everything.push_back(v);
    CHECK(refusal([&] { MatchSession({{&good, none}, {&good, none, everything}}); }) == "bad-mask");
    CHECK(refusal([&] { MatchSession({{&good, none}, {&good, none}}, {.adapt = 2}); }) == "bad-option");
    for (const MatchOptions& options : {MatchOptions{.edge_length = -1}, MatchOptions{.levels = 0}, MatchOptions{.levels = 9}, MatchOptions{.fine_steps = 0}, MatchOptions{.most_vertices = -1}})
        CHECK(refusal([&] { MatchSession({{&good, none}, {&good, none}}, options); }) == "bad-option");
    for (const auto& [name, broken] : shapes::eight_broken(ball)) {
        CAPTURE(name);
        for (const bool source : {false, true}) {
            const MatchResult result = matched(source ? broken : ball, source ? ball : broken, none, none, {.levels = 2, .fine_steps = 6});
            CHECK(result.skins.points[0].allFinite());
            CHECK(result.skins.points[1].allFinite());
        }
    }
}
