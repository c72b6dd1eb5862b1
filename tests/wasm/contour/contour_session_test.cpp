#include "lissom/contour/contour_session.h"

#include "deform/handles.h"
#include "refusal.h"
#include "round.h"
#include "shapes.h"

#include "lissom/mesh/operators.h"
#include "lissom/mesh/stopwatch.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

using namespace lissom;
using Eigen::Vector3d;
using Kind = ContourLine::Kind;

namespace {

ContourSession session_of(const TriangleMesh& mesh, int sweeps) {
    ContourSession session(std::make_shared<WorkingMesh>(shapes::working(mesh)), sweeps);
    while (session.step()) {
    }
    return session;
}

LineView parallel(const Vector3d& towards) { return {.perspective = false, .eye = towards}; }

/// Zeros of a function of places on the surface, by walking the mesh's edges and dividing each that changes sign.
std::vector<Vector3d> zeros(const TriangleMesh& mesh, const rounds::Implicit& surface, const std::function<double(const Vector3d&)>& value, const std::function<bool(const Vector3d&)>& wanted) {
    std::vector<double> at(static_cast<std::size_t>(mesh.vertex_count()));
    std::vector<Vector3d> on;
    for (int v = 0; v < mesh.vertex_count(); ++v) {
        on.push_back(surface.projected(mesh.points.row(v).transpose()));
        at[v] = value(on.back());
    }
    std::vector<Vector3d> found;
    for (int t = 0; t < mesh.triangle_count(); ++t)
        for (int k = 0; k < 3; ++k) {
            const int i = mesh.triangles(t, k), j = mesh.triangles(t, (k + 1) % 3);
            if (i > j || (at[i] > 0) == (at[j] > 0)) continue;
            Vector3d a = on[i], b = on[j];
            for (int n = 0; n < 25; ++n) {
                const Vector3d middle = surface.projected((a + b) / 2);
                ((value(middle) > 0) == (at[i] > 0) ? a : b) = middle;
            }
            if (wanted(a)) found.push_back(a);
        }
    return found;
}

double distance(const Vector3d& p, const ContourLine& line) {
    double least = INFINITY;
    const std::size_t n = line.points.size();
    for (std::size_t i = 0; i + (line.closed ? 0 : 1) < n; ++i) {
        const Vector3d a = line.points[i], b = line.points[(i + 1) % n] - a;
        const double u = b.squaredNorm() > 0 ? std::clamp((p - a).dot(b) / b.squaredNorm(), 0.0, 1.0) : 0;
        least = std::min(least, (a + u * b - p).norm());
    }
    return least;
}

struct Figures {
    double covered = 1, mean = 0, p95 = 0, false_length = 0, wrong_sign = 0;
    int chains = 0, loose = 0;
};

/// Found lines against true places: `covered` within an edge, distance in edges, share of found length farther than two edges from any.
Figures compare(const std::vector<ContourLine>& lines, Kind kind, const std::vector<Vector3d>& truth, const std::vector<Vector3d>& loosely, double edge) {
    Figures figures;
    std::vector<double> gaps;
    for (const Vector3d& p : truth) {
        double least = INFINITY;
        for (const ContourLine& line : lines)
            if (line.kind == kind) least = std::min(least, distance(p, line));
        gaps.push_back(least / edge);
    }
    std::sort(gaps.begin(), gaps.end());
    for (const double gap : gaps) figures.mean += std::min(gap, 1.0) / static_cast<double>(gaps.size());
    if (!gaps.empty()) {
        figures.covered = static_cast<double>(std::upper_bound(gaps.begin(), gaps.end(), 1.0) - gaps.begin()) / static_cast<double>(gaps.size());
        figures.p95 = gaps[gaps.size() * 95 / 100];
    }
    double total = 0, wrong = 0;
    for (const ContourLine& line : lines) {
        if (line.kind != kind) continue;
        ++figures.chains;
        for (std::size_t i = 0; i + 1 < line.points.size(); ++i) {
            const Vector3d middle = (line.points[i] + line.points[i + 1]) / 2;
            const double length = (line.points[i + 1] - line.points[i]).norm();
            double least = INFINITY;
            for (const Vector3d& p : loosely) least = std::min(least, (p - middle).norm());
            total += length;
            wrong += least > 2 * edge ? length : 0;
        }
    }
    figures.false_length = total > 0 ? wrong / total : 0;
    return figures;
}

struct Shape {
    const char* name;
    TriangleMesh mesh;
    rounds::Implicit surface;
    double least; ///< D below which places are not asked for: lines are as good as undetermined there
};
std::vector<Shape> shapes_by_formula() {
    return {{"torus", rounds::Torus().mesh(160, 64), rounds::Torus().implicit(), 0.1}, {"bumpy sphere", rounds::Bumpy().mesh(shapes::icosphere(5)), rounds::Bumpy().implicit(), 0.5}};
}

} // namespace

TEST_CASE("contours of a torus and a bumpy sphere lie on the true ones and have no loose end") {
    for (const Shape& shape : shapes_by_formula()) {
        const double edge = mean_edge_length(shape.mesh);
        ContourSession session = session_of(shape.mesh, 0);
        for (const Vector3d& towards : {Vector3d(0.3, 0.5, 0.8).normalized(), Vector3d(0.9, 0.1, 0.35).normalized()}) {
            const auto& lines = session.lines(parallel(towards), {.suggestive = false, .shortest = 0, .corner = 180});
            const auto facing = [&](const Vector3d& p) { return shape.surface.normal(p).dot(towards); };
            const auto truth = zeros(shape.mesh, shape.surface, facing, [](const Vector3d&) { return true; });
            const Figures f = compare(lines, Kind::contour, truth, truth, edge);
            std::printf("%-12s contours: %d, covered %.4f, mean %.3f edges, 95 %% %.3f\n", shape.name, f.chains, f.covered, f.mean, f.p95);
            CHECK(f.covered > 0.98); // where a loop is about to open or close, it may be there or not
            CHECK(f.mean < 0.1);
            for (const ContourLine& line : lines) CHECK(line.closed);
        }
    }
}

TEST_CASE("suggestive contours cover the true ones, and end only where those do") {
    for (const Shape& shape : shapes_by_formula()) {
        const double edge = mean_edge_length(shape.mesh);
        ContourSession session = session_of(shape.mesh, 0);
        for (const Vector3d& towards : {Vector3d(0.3, 0.5, 0.8).normalized(), Vector3d(0.9, 0.1, 0.35).normalized()}) {
            const LineOptions options{.strength = 0, .shortest = 0, .corner = 180};
            const auto& lines = session.lines(parallel(towards), options);
            const auto radial = [&](const Vector3d& p) { return shape.surface.radial(p, towards); };
            const auto shown = [&](double least, double steepness) {
                return [&shape, towards, least, steepness](const Vector3d& p) {
                    const double g = shape.surface.normal(p).dot(towards);
                    return g > least && 1 - g * g > steepness && shape.surface.growth(p, towards) > least;
                };
            };
            // Places that count are a little inside what is to be shown, places allowed a little outside.
            const auto truth = zeros(shape.mesh, shape.surface, radial, shown(shape.least, options.steepness * 1.5));
            const auto loosely = zeros(shape.mesh, shape.surface, radial, shown(-0.3, options.steepness / 2));
            REQUIRE(truth.size() > 20);
            const Figures f = compare(lines, Kind::suggestive, truth, loosely, edge);
            int loose = 0;
            for (const ContourLine& line : lines) {
                if (line.kind != Kind::suggestive || line.closed) continue;
                for (const Vector3d& end : {line.points.front(), line.points.back()}) {
                    const Vector3d p = shape.surface.projected(end);
                    const double g = shape.surface.normal(p).dot(towards);
                    // Well inside what is to be shown: D is positive for an edge and a half all around, n·v and sin²θ some edges from their limits.
                    bool inside = g > 4 * edge && 1 - g * g > options.steepness + 4 * edge && shape.surface.growth(p, towards) > 0;
                    const Vector3d n = shape.surface.normal(p), u = n.unitOrthogonal();
                    for (int k = 0; k < 16; ++k)
                        inside = inside && shape.surface.growth(shape.surface.projected(p + 1.5 * edge * (Eigen::AngleAxisd(k * std::numbers::pi / 8, n) * u)), towards) > 0;
                    loose += inside ? 1 : 0;
                }
            }
            std::printf("%-12s suggestive: %d lines, covered %.4f, mean %.3f edges, 95 %% %.3f, false length %.3f, loose ends %d\n", shape.name, f.chains, f.covered, f.mean, f.p95,
                        f.false_length, loose);
            CHECK(f.covered >= 0.999);
            CHECK(f.mean <= 0.15);
            CHECK(loose == 0);
        }
    }
}

TEST_CASE("noise draws hardly any line that is not there") {
    const rounds::Torus torus;
    const TriangleMesh clean = torus.mesh(96, 40);
    const double edge = mean_edge_length(clean);
    const rounds::Implicit surface = torus.implicit();
    // 0.2 % of the radius, 3 % of an edge.
    const TriangleMesh mesh = rounds::noisy(clean, vertex_normals(clean), 0.002 * (torus.R + torus.r), 7);
    for (const int sweeps : {0, 5, 10, 15}) {
        ContourSession session = session_of(mesh, sweeps);
        double wrong = 0, covered = 0, mean = 0;
        int lines = 0;
        const std::vector<Vector3d> views{Vector3d(0.9, 0.1, 0.35).normalized(), Vector3d(0.2, 0.7, 0.3).normalized()};
        for (const Vector3d& towards : views) {
            const auto radial = [&](const Vector3d& p) { return surface.radial(p, towards); };
            const auto truth = zeros(clean, surface, radial, [&](const Vector3d& p) {
                const double g = surface.normal(p).dot(towards);
                return g > 0.1 && 1 - g * g > 0.06 && surface.growth(p, towards) > 0.1;
            });
            const auto loosely = zeros(clean, surface, radial, [&](const Vector3d& p) { return surface.normal(p).dot(towards) > -0.1 && surface.growth(p, towards) > -0.5; });
            REQUIRE(truth.size() > 20);
            const Figures f = compare(session.lines(parallel(towards)), Kind::suggestive, truth, loosely, edge);
            wrong += f.false_length / 2;
            covered += f.covered / 2;
            mean += f.mean / 2;
            lines += f.chains;
        }
        std::printf("torus with 0.2 %% noise, %2d sweeps: %d lines in two views, false length %.3f, covered within an edge %.3f, mean %.3f\n", sweeps, lines, wrong, covered, mean);
        if (sweeps == 0) CHECK(wrong > 0.2); // else there would be nothing to smooth
        if (sweeps == 15) {
            CHECK(wrong <= 0.05);
            CHECK(covered >= 0.97);
        }
    }
}

TEST_CASE("a head is drawn with some ten to thirty lines") {
    const TriangleMesh mesh = handles::shared_model("human/head_female.ply");
    if (mesh.vertex_count() == 0) {
        MESSAGE("skipped: there is no shared/data/human/head_female.ply here");
        return;
    }
    Stopwatch clock;
    ContourSession session = session_of(mesh, 10);
    const double prepare = clock.lap();
    for (const Vector3d& towards : {Vector3d(0, 0, 1), Vector3d(0.5, 0.1, 0.85), Vector3d(0.9, 0.1, 0.4)}) {
        clock.lap();
        const auto& lines = session.lines(parallel(towards));
        const double seconds = clock.lap();
        const auto suggestive = std::count_if(lines.begin(), lines.end(), [](const ContourLine& line) { return line.kind == Kind::suggestive; });
        std::printf("head: %td lines, %td of them suggestive; prepared in %.0f ms, view %.1f ms\n", std::ssize(lines), suggestive, 1e3 * prepare, 1e3 * seconds);
        CHECK(std::ssize(lines) >= 10);
        CHECK(std::ssize(lines) <= 30);
    }
}

TEST_CASE("lines neither depend on size and place, nor on slices, nor on what was looked at before") {
    const TriangleMesh mesh = rounds::Bumpy().mesh(shapes::icosphere(4));
    ContourSession session = session_of(mesh, 5);
    const Vector3d towards(0.3, 0.5, 0.8);
    const std::vector<ContourLine> first = session.lines(parallel(towards));
    CHECK(first.size() > 3);
    (void)session.lines({.perspective = true, .eye = {5, 0, 0}});
    session.look(parallel({1, 0, 0}));
    (void)session.look_step(); // given up
    session.look(parallel(towards));
    while (session.look_step()) {
    }
    REQUIRE(session.lines().size() == first.size());
    for (std::size_t l = 0; l < first.size(); ++l) CHECK(session.lines()[l].points == first[l].points);
    TriangleMesh large = mesh;
    large.points = (1000 * large.points).rowwise() + Eigen::RowVector3d(5000, -3000, 100);
    ContourSession other = session_of(large, 5);
    const auto& again = other.lines(parallel(towards));
    REQUIRE(again.size() == first.size());
    for (std::size_t l = 0; l < first.size(); ++l) CHECK(again[l].length == doctest::Approx(1000 * first[l].length).epsilon(1e-6));
}

TEST_CASE("every point says where on the surface it is: its triangle's corners by its weights") {
    const TriangleMesh mesh = rounds::Bumpy().mesh(shapes::icosphere(4));
    ContourSession session = session_of(mesh, 5);
    int suggestive = 0;
    for (const ContourLine& line : session.lines(parallel({0.3, 0.5, 0.8}))) {
        suggestive += line.kind == Kind::suggestive;
        REQUIRE(line.places.size() == line.points.size());
        for (std::size_t i = 0; i < line.points.size(); ++i) {
            const SurfacePlace& place = line.places[i];
            CHECK(place.weights.minCoeff() >= -1e-12);
            CHECK(place.weights.sum() == doctest::Approx(1).epsilon(1e-12));
            Vector3d sum = Vector3d::Zero();
            for (int k = 0; k < 3; ++k) sum += place.weights[k] * mesh.points.row(place.corners[k]).transpose();
            CHECK((sum - line.points[i]).norm() < 1e-9);
        }
    }
    CHECK(suggestive > 0);
}

TEST_CASE("an eye far away sees as a parallel view does; within reach it sees less of the model") {
    const TriangleMesh mesh = rounds::Bumpy().mesh(shapes::icosphere(4));
    ContourSession session = session_of(mesh, 5);
    const Vector3d towards = Vector3d(0.3, 0.5, 0.8).normalized();
    const LineOptions only{.suggestive = false, .corner = 180};
    const double far = session.lines({.perspective = true, .eye = 1e4 * towards}, only).front().length;
    const double parallel_length = session.lines(parallel(towards), only).front().length;
    CHECK(far == doctest::Approx(parallel_length).epsilon(1e-2));
    CHECK(session.lines({.perspective = true, .eye = 2.5 * towards}, only).front().length < parallel_length);
}

TEST_CASE("broken models are drawn as far as they go; a view without direction is refused") {
    for (const TriangleMesh& mesh : {shapes::moebius(), shapes::three_sheets(), shapes::soup(shapes::bumpy_sphere()), shapes::with_needles(shapes::bumpy_sphere()), shapes::klein_bottle()}) {
        ContourSession session = session_of(mesh, 3);
        for (const ContourLine& line : session.lines(parallel({0.2, 0.3, 1}), {.strength = 0, .shortest = 0}))
            for (const Vector3d& p : line.points) CHECK(p.allFinite());
    }
    ContourSession session = session_of(shapes::icosphere(1), 0);
    CHECK(refusal([&] { session.look(parallel({0, 0, 0})); }) == "bad-view");
    CHECK(refusal([&] { session.look({.perspective = true, .eye = {NAN, 0, 0}}); }) == "bad-view");
    CHECK(refusal([&] { (void)ContourSession(std::make_shared<WorkingMesh>(shapes::working(shapes::icosphere(1))), -1); }) == "bad-option");
}
