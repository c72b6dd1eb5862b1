#include "lissom/curve/line_weights.h"

#include "deform/handles.h"
#include "refusal.h"
#include "shapes.h"

#include "lissom/mesh/half_edges.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

using namespace lissom;
using Eigen::Vector3d;

namespace {

Polyline straight(const Vector3d& a, const Vector3d& b, int pieces = 10) {
    Polyline line;
    for (int k = 0; k <= pieces; ++k) line.push_back(a + (b - a) * k / pieces);
    return line;
}

Polyline shifted(Polyline line, const Vector3d& by) {
    for (Vector3d& p : line) p += by;
    return line;
}

/// Changes of the angles between neighbouring triangles, degrees, ascending.
std::vector<double> dihedral_changes(const TriangleMesh& rest, const Points& moved) {
    const auto normal = [&](const Points& p, int t) {
        const Vector3d a = p.row(rest.triangles(t, 0)), b = p.row(rest.triangles(t, 1)), c = p.row(rest.triangles(t, 2));
        return Vector3d((b - a).cross(c - a).normalized());
    };
    std::vector<double> changes;
    const auto sides = half_edges(rest);
    for_each_edge(sides, [&](auto first, auto last) {
        if (last - first != 2) return;
        const int s = first->triangle, t = (first + 1)->triangle;
        const Vector3d e0 = (rest.points.row(first->b) - rest.points.row(first->a)).normalized(), e1 = (moved.row(first->b) - moved.row(first->a)).normalized();
        const auto angle = [&](const Points& p, const Vector3d& e) { return std::atan2(e.dot(normal(p, s).cross(normal(p, t))), normal(p, s).dot(normal(p, t))); };
        changes.push_back(std::abs(std::remainder(angle(moved, e1) - angle(rest.points, e0), 2 * M_PI)) * 180 / M_PI);
    });
    std::sort(changes.begin(), changes.end());
    return changes;
}

Points after(const TriangleMesh& mesh, const CurveSurface& surface, const LineWeights& weights, const Polyline& line, const Vector3d& by) {
    Points moved = mesh.points;
    const Points rows = pulled(surface, weights, line, shifted(line, by));
    for (std::size_t i = 0; i < weights.vertices.size(); ++i) moved.row(weights.vertices[i]) = rows.row(static_cast<Eigen::Index>(i));
    return moved;
}

} // namespace

TEST_CASE("weights are one on the line, fade to nothing at the radius, whatever the size") {
    for (const double scale : {1e-3, 1.0, 1e3}) {
        TriangleMesh mesh = shapes::sheet(60, 60);
        mesh.points *= scale;
        const Vector3d centre = mesh.points.colwise().mean();
        const CurveSurface surface(std::make_shared<WorkingMesh>(shapes::working(mesh)));
        const Polyline line = straight(centre - Vector3d(0.2, 0, 0) * scale, centre + Vector3d(0.2, 0, 0) * scale);
        const LineWeights weights = line_weights(surface, line, {}, {.radius = 0.2 * scale});
        CHECK(weights.vertices.size() > 300);
        for (std::size_t i = 0; i < weights.vertices.size(); ++i) {
            const Vector3d p = (mesh.points.row(weights.vertices[i]).transpose() - centre) / scale;
            CHECK(weights.weights[i] > 0);
            CHECK(weights.weights[i] <= 1);
            CHECK(std::hypot(std::max(0.0, std::abs(p.x()) - 0.2), p.y()) < 0.21);
            if (std::abs(p.x()) < 0.19 && std::abs(p.y()) < 1e-9) CHECK(weights.weights[i] > 0.9);
            if (std::abs(p.x()) < 0.15 && std::abs(p.y()) < 0.05) CHECK(weights.along[i] == doctest::Approx(p.x() / 0.4 + 0.5).epsilon(0.15));
        }
        const Points still = pulled(surface, weights, line, line);
        for (std::size_t i = 0; i < weights.vertices.size(); ++i) CHECK((still.row(static_cast<Eigen::Index>(i)) - mesh.points.row(weights.vertices[i])).norm() == 0);
    }
}

TEST_CASE("another line stays where it is and blocks only where it is near") {
    const TriangleMesh mesh = shapes::sheet(80, 80);
    const Vector3d c = mesh.points.colwise().mean();
    const CurveSurface surface(std::make_shared<WorkingMesh>(shapes::working(mesh)));
    const Polyline line = straight(c - Vector3d(0.3, 0, 0), c + Vector3d(0.3, 0, 0)), other = straight(c + Vector3d(0.1, 0.08, 0), c + Vector3d(0.3, 0.08, 0));
    const auto weight_near = [&](const LineWeights& weights, const Vector3d& p) {
        double best = INFINITY, w = 0;
        for (int v = 0; v < mesh.vertex_count(); ++v)
            if (const double d = (mesh.points.row(v).transpose() - p).norm(); d < best) {
                best = d;
                const auto at = std::lower_bound(weights.vertices.begin(), weights.vertices.end(), v);
                w = at != weights.vertices.end() && *at == v ? weights.weights[at - weights.vertices.begin()] : 0;
            }
        return w;
    };
    const LineWeights free = line_weights(surface, line, {}, {.radius = 0.2}), blocked = line_weights(surface, line, {other}, {.radius = 0.2});
    CHECK(weight_near(blocked, c + Vector3d(0.2, 0.08, 0)) < 0.1);
    CHECK(weight_near(free, c + Vector3d(0.2, 0.08, 0)) > 0.5);
    CHECK(weight_near(blocked, c + Vector3d(-0.2, 0.08, 0)) == doctest::Approx(weight_near(free, c + Vector3d(-0.2, 0.08, 0))).epsilon(0.02));
    CHECK(weight_near(blocked, c + Vector3d(0.2, -0.08, 0)) == doctest::Approx(weight_near(free, c + Vector3d(0.2, -0.08, 0))).epsilon(0.02));
}

TEST_CASE("a brow lifted by 2 % of the head's height leaves no crease") {
    const TriangleMesh mesh = handles::shared_model("human/head_female.ply");
    if (mesh.vertex_count() == 0) {
        MESSAGE("skipped: there is no shared/data/human/head_female.ply here");
        return;
    }
    const CurveSurface surface(std::make_shared<WorkingMesh>(shapes::working(mesh)));
    const double height = mesh.points.col(1).maxCoeff() - mesh.points.col(1).minCoeff();
    // Along the brow ridge: where rays from the front meet the head; the lid below it stays.
    const auto on_front = [&](double x, double y) {
        const auto hits = surface.tree().hits(surface.working().to_working(Vector3d(x, y, 10 * height)), {0, 0, -1});
        REQUIRE_FALSE(hits.empty());
        return surface.working().to_source(surface.working().to_working(Vector3d(x, y, 10 * height)) - Vector3d(0, 0, hits.front().depth));
    };
    const double low = mesh.points.col(1).minCoeff();
    Polyline brow, lid;
    for (int k = 0; k <= 12; ++k) {
        const double x = height * (0.05 + 0.12 * k / 12.0), arch = height * 0.015 * std::sin(M_PI * k / 12.0);
        brow.push_back(on_front(x, low + 0.60 * height + arch));
        lid.push_back(on_front(x, low + 0.55 * height + arch));
    }
    const LineWeights weights = line_weights(surface, brow, {lid});
    const Points moved = after(mesh, surface, weights, brow, {0, 0.02 * height, 0});
    const std::vector<double> changes = dihedral_changes(mesh, moved);
    std::printf("brow lifted by 2 %%: %zu vertices move, dihedral changes 99.9 %% under %.1f, most %.1f degrees\n", weights.vertices.size(), changes[changes.size() * 999 / 1000], changes.back());
    CHECK(changes[changes.size() * 999 / 1000] < 20);
    CHECK((moved - mesh.points).rowwise().norm().maxCoeff() == doctest::Approx(0.02 * height).epsilon(0.01));
}

TEST_CASE("broken surfaces have weights, nonsense is refused") {
    for (const TriangleMesh& mesh : {shapes::moebius(), shapes::soup(shapes::icosphere(3)), shapes::three_sheets()}) {
        const CurveSurface surface(std::make_shared<WorkingMesh>(shapes::working(mesh)));
        const LineWeights weights = line_weights(surface, straight(mesh.points.row(0).transpose(), mesh.points.row(5).transpose()), {});
        CHECK_FALSE(weights.vertices.empty());
        for (const double w : weights.weights) CHECK(std::isfinite(w));
    }
    const CurveSurface surface(std::make_shared<WorkingMesh>(shapes::working(shapes::icosphere(2))));
    const Polyline line = straight({1, 0, 0}, {0, 1, 0});
    CHECK(refusal([&] { (void)line_weights(surface, {{1, 0, 0}, {1, 0, 0}}, {}); }) == "line-too-short");
    CHECK(refusal([&] { (void)line_weights(surface, {}, {}); }) == "line-too-short");
    CHECK(refusal([&] { (void)line_weights(surface, line, {}, {.radius = -1}); }) == "line-radius");
    CHECK(refusal([&] { (void)line_weights(surface, {{1, 0, 0}, {NAN, 0, 0}}, {}); }) == "non-finite-curve");
    CHECK(refusal([&] { (void)pulled(surface, line_weights(surface, line, {}), line, {{1, 0, 0}}); }) == "line-places");
}

TEST_CASE("a line that runs on far beyond the model ends, and pulls as its part on the model does") {
    const TriangleMesh mesh = shapes::sheet(40, 40);
    const Vector3d c = mesh.points.colwise().mean();
    const CurveSurface surface(std::make_shared<WorkingMesh>(shapes::working(mesh)));
    const Polyline on = straight(c - Vector3d(0.3, 0, 0), c + Vector3d(0.3, 0, 0), 4);
    Polyline far = on;
    far.push_back(c + Vector3d(1e20, 0, 0));
    const LineWeights near = line_weights(surface, on, {}), reached = line_weights(surface, far, {});
    CHECK(reached.vertices.size() >= near.vertices.size());
    CHECK(std::all_of(reached.weights.begin(), reached.weights.end(), [](double w) { return w > 0 && w <= 1; }));
    CHECK(std::all_of(reached.along.begin(), reached.along.end(), [](double x) { return x >= 0 && x <= 1; }));
    // Beside the model, and right through it from far away.
    CHECK(line_weights(surface, {c + Vector3d(0, 1e9, 0), c + Vector3d(1e9, 1e9, 0)}, {}).vertices.empty());
    CHECK(line_weights(surface, {c - Vector3d(1e9, 0, 0), c + Vector3d(1e9, 0, 0)}, {}).vertices.size() > near.vertices.size());
    far.back().x() = 1e200;
    CHECK(refusal([&] { (void)line_weights(surface, far, {}); }) == "non-finite-curve");
}
