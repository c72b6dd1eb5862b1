#include "lissom/mesh/remesh.h"

#include "../isoline/figures.h"
#include "lissom/mesh/operators.h"
#include "lissom/mesh/self_intersections.h"
#include "lissom/mesh/stopwatch.h"
#include "lissom/mesh/surface_samples.h"
#include "lissom/mesh/topology.h"
#include "lissom/mesh/triangle_tree.h"
#include "refusal.h"
#include "shapes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>

using namespace lissom;

namespace {

struct Shape {
    double shortest, longest, within;   ///< of the wanted length; share of edges between half and one and a half times
    double least_angle, one_percent;     ///< degrees
};
Shape shape_of(const TriangleMesh& mesh, double L) {
    Shape s{1e9, 0, 0, 180, 0};
    int count = 0;
    for (const Edge& e : edges(mesh)) {
        const double r = (mesh.points.row(e.a) - mesh.points.row(e.b)).norm() / L;
        s.shortest = std::min(s.shortest, r);
        s.longest = std::max(s.longest, r);
        s.within += r > 0.5 && r < 1.5;
        ++count;
    }
    s.within /= count;
    std::vector<double> angles;
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        double least = 180;
        for (int k = 0; k < 3; ++k) {
            const Eigen::RowVector3d p = mesh.points.row(mesh.triangles(t, k)), u = mesh.points.row(mesh.triangles(t, (k + 1) % 3)) - p, w = mesh.points.row(mesh.triangles(t, (k + 2) % 3)) - p;
            least = std::min(least, std::acos(std::clamp(u.dot(w) / (u.norm() * w.norm()), -1.0, 1.0)) * 57.29577951308232);
        }
        angles.push_back(least);
    }
    std::sort(angles.begin(), angles.end());
    s.least_angle = angles.front();
    s.one_percent = angles[angles.size() / 100];
    return s;
}

struct Apart {
    double there = 0, back = 0, most = 0;
};
Apart apart(const TriangleMesh& a, const TriangleMesh& b) {
    Apart found;
    std::vector<double> all;
    const auto one_way = [&](const TriangleMesh& from, const TriangleMesh& to) {
        const TriangleTree tree(to);
        const Points places = sample_surface(from, 20000).on(from);
        double sum = 0;
        for (Eigen::Index i = 0; i < places.rows(); ++i) {
            all.push_back(tree.nearest(places.row(i).transpose()).distance);
            sum += all.back();
        }
        return sum / static_cast<double>(places.rows());
    };
    const double D = diagonal(b.points);
    found.there = one_way(a, b) / D;
    found.back = one_way(b, a) / D;
    std::sort(all.begin(), all.end());
    found.most = all[all.size() * 99 / 100] / D;
    return found;
}

int folds(const TriangleMesh& mesh) {
    std::vector<Eigen::RowVector3d> normals;
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        const Eigen::Vector3d a = mesh.points.row(mesh.triangles(t, 0)), b = mesh.points.row(mesh.triangles(t, 1)), c = mesh.points.row(mesh.triangles(t, 2));
        normals.push_back((b - a).cross(c - a).stableNormalized().transpose());
    }
    int count = 0;
    std::vector<std::vector<int>> around(static_cast<std::size_t>(mesh.vertex_count()));
    for (int t = 0; t < mesh.triangle_count(); ++t)
        for (const int v : mesh.triangles.row(t)) around[v].push_back(t);
    for (const Edge& e : edges(mesh)) {
        std::vector<int> both;
        for (const int t : around[e.a])
            if ((mesh.triangles.row(t).array() == e.b).any()) both.push_back(t);
        count += both.size() == 2 && normals[both[0]].dot(normals[both[1]]) < -0.2;
    }
    return count;
}

std::string figures_of(const Remeshed& out, const TriangleMesh& mesh, double L) {
    const Shape s = shape_of(out.mesh, L);
    const Apart a = apart(out.mesh, mesh);
    std::ostringstream line;
    line.precision(3);
    line << mesh.vertex_count() << " -> " << out.mesh.vertex_count() << " vertices, apart " << a.there << ", " << a.back << ", 99 % " << a.most << "; edges " << s.shortest << " to " << s.longest << ", " << 100 * s.within
         << " % between half and one and a half; least angle " << s.least_angle << ", 1 % " << s.one_percent << "; folds " << folds(out.mesh) << " (" << folds(mesh) << "), crossings "
         << self_intersections(out.mesh).triangles.size() << " (" << self_intersections(mesh).triangles.size() << ")";
    return line.str();
}

} // namespace

TEST_CASE("a ball, a ring and a block with two tunnels stay what they are, in even triangles, finer and coarser") {
    for (const TriangleMesh& mesh : {shapes::icosphere(3), shapes::uv_sphere(), shapes::torus(), shapes::double_torus()})
        for (const double factor : {0.5, 1.0, 1.7}) {
            const double L = factor * mean_edge_length(mesh);
            const Remeshed out = remesh(mesh, {L});
            CHECK(euler_characteristic(out.mesh) == euler_characteristic(mesh));
            CHECK(boundary_loops(out.mesh).empty());
            CHECK(non_manifold_vertices(out.mesh).empty());
            CHECK_FALSE(out.full);
            const Shape s = shape_of(out.mesh, L);
            CHECK(s.within > 0.95);
            CHECK(s.one_percent > 20);
            // What is round keeps its volume; the block's edges are no curves here and are rounded.
            if (euler_characteristic(mesh) >= 0) CHECK(signed_volume(out.mesh) > 0.85 * signed_volume(mesh));
        }
}

TEST_CASE("curves of a box stay: corners exactly, the rest on their lines, and with them the box itself") {
    const TriangleMesh box = shapes::box(6, 7, 8, {1, 2, 3});
    std::vector<std::pair<int, int>> rims;
    const auto sides = [&](int v) {
        int on = 0;
        const Eigen::RowVector3d low = box.points.colwise().minCoeff(), high = box.points.colwise().maxCoeff();
        for (int k = 0; k < 3; ++k) on += std::abs(box.points(v, k) - low[k]) < 1e-12 || std::abs(box.points(v, k) - high[k]) < 1e-12;
        return on;
    };
    for (const Edge& e : edges(box))
        if (sides(e.a) >= 2 && sides(e.b) >= 2 && ((box.points.row(e.a) - box.points.row(e.b)).array().abs() > 1e-12).count() == 1) rims.emplace_back(e.a, e.b);
    const auto curves = chained(box.vertex_count(), rims);
    REQUIRE(curves.size() == 12);
    for (const double L : {0.11, 0.4}) {
        const Remeshed out = remesh(box, {L}, curves);
        REQUIRE(out.curves.size() == 12);
        double length = 0;
        const auto all = edges(out.mesh);
        for (std::size_t k = 0; k < 12; ++k) {
            const auto& v = out.curves[k].vertices;
            CHECK(out.mesh.points.row(v.front()) == box.points.row(curves[k].vertices.front()));
            CHECK(out.mesh.points.row(v.back()) == box.points.row(curves[k].vertices.back()));
            for (std::size_t i = 0; i + 1 < v.size(); ++i) {
                length += (out.mesh.points.row(v[i]) - out.mesh.points.row(v[i + 1])).norm();
                CHECK(std::any_of(all.begin(), all.end(), [&](const Edge& e) { return e.a == std::min(v[i], v[i + 1]) && e.b == std::max(v[i], v[i + 1]); }));
            }
        }
        CHECK(length == doctest::Approx(24).epsilon(1e-9)); // monotone on straight lines
        CHECK(signed_volume(out.mesh) == doctest::Approx(6).epsilon(1e-9));
        CHECK(triangle_areas(out.mesh).sum() == doctest::Approx(22).epsilon(1e-9));
        CHECK(shape_of(out.mesh, L).within > 0.95);
    }
}

TEST_CASE("borders stay where they are, with their corners, and fixed vertices do not move") {
    const TriangleMesh sheet = shapes::sheet(10, 14);
    const Remeshed out = remesh(sheet, {0.06}, {}, {37, 80});
    const double area = triangle_areas(sheet).sum();
    CHECK(triangle_areas(out.mesh).sum() == doctest::Approx(area).epsilon(1e-9));
    CHECK(boundary_loops(out.mesh).size() == 1);
    CHECK(out.mesh.points.col(2).cwiseAbs().maxCoeff() < 1e-12);
    REQUIRE(out.fixed.size() == 2);
    CHECK(out.mesh.points.row(out.fixed[0]) == sheet.points.row(37));
    CHECK(out.mesh.points.row(out.fixed[1]) == sheet.points.row(80));
    const Remeshed ring = remesh(shapes::flat_ring(), {0.3});
    CHECK(boundary_loops(ring.mesh).size() == 2);
    CHECK(triangle_areas(ring.mesh).sum() > 0.95 * triangle_areas(shapes::flat_ring()).sum());
}

TEST_CASE("what is broken is left as it is, and the rest is worked on") {
    for (const shapes::Broken& broken : shapes::eight_broken(shapes::bumpy_sphere(3))) {
        CAPTURE(std::string(broken.name));
        if (!broken.mesh.points.allFinite()) continue; // not for this floor
        const Remeshed out = remesh(broken.mesh, {1.3 * mean_edge_length(broken.mesh)});
        CHECK(out.mesh.vertex_count() > 0);
        CHECK(out.mesh.points.allFinite());
    }
    CHECK(euler_characteristic(remesh(shapes::three_sheets()).mesh) == euler_characteristic(shapes::three_sheets()));
    CHECK(refusal([] { (void)remesh({Points::Zero(3, 3), Triangles::Zero(0, 3)}); }) == "flat-model");
    CHECK(refusal([] { (void)remesh(shapes::icosphere(1), {.edge_length = -1}); }) == "bad-option");
    CHECK(refusal([] { (void)remesh(shapes::icosphere(1), {.adapt = 2}); }) == "bad-option");
    CHECK(refusal([] { (void)remesh(shapes::sheet(4, 4), {}, {{{0, 24}}}); }) == "bad-curve");
    const Remeshed capped = remesh(shapes::icosphere(3), {.edge_length = 0.01, .most_vertices = 2000});
    CHECK(capped.full);
    CHECK(capped.mesh.vertex_count() <= 2000);
}

TEST_CASE("the same in another unit, and again") {
    const TriangleMesh mesh = shapes::bumpy_sphere(4);
    TriangleMesh large = mesh;
    large.points *= 1024;
    const double L = 1.3 * mean_edge_length(mesh);
    const Remeshed a = remesh(mesh, {L, 0.5}), again = remesh(mesh, {L, 0.5}), b = remesh(large, {1024 * L, 0.5});
    CHECK(a.mesh.points == again.mesh.points);
    CHECK(a.mesh.triangles == again.mesh.triangles);
    REQUIRE(a.mesh.triangles == b.mesh.triangles);
    CHECK((1024 * a.mesh.points - b.mesh.points).cwiseAbs().maxCoeff() < 1e-9 * 1024);
}

TEST_CASE("by curvature fewer triangles come as near, or as many nearer") {
    TriangleMesh egg = shapes::icosphere(5);
    egg.points.col(0) *= 5;
    const double L = 0.25;
    const Remeshed even = remesh(egg, {L}), adapted = remesh(egg, {L, 1});
    MESSAGE("even: " << figures_of(even, egg, L));
    MESSAGE("adapted: " << figures_of(adapted, egg, L));
    CHECK(adapted.mesh.vertex_count() < 1.15 * even.mesh.vertex_count());
    CHECK(apart(adapted.mesh, egg).most < apart(even.mesh, egg).most);
}

TEST_CASE("animals and heads at their own edge length stay within 0.0005 of the diagonal") {
    for (const char* name : {"registry/spot_pp3d", "pairs/head_female_remesh", "pairs/head_troll_remesh", "human/head_male"}) {
        const TriangleMesh mesh = figures::shared(name);
        if (mesh.vertex_count() == 0) continue;
        const double L = mean_edge_length(mesh);
        for (const double adapt : {0.0, 1.0}) {
            Stopwatch watch;
            Remesher remesher(mesh, {}, {}, {L, adapt});
            double longest = watch.lap(), sum = longest;
            for (bool more = true; more;) {
                more = remesher.step();
                const double lap = watch.lap();
                longest = std::max(longest, lap);
                sum += lap;
            }
            const Remeshed out = remesher.result();
            MESSAGE(std::string(name) << ", adapt " << adapt << ": " << figures_of(out, mesh, L) << "; " << sum << " s, longest slice " << longest);
            const Apart a = apart(out.mesh, mesh);
            CHECK(a.there < 0.0005);
            CHECK(a.back < 0.0005);
            CHECK(euler_characteristic(out.mesh) == euler_characteristic(mesh));
        }
    }
}
