#include "lissom/merge/opened_target.h"

#include "lissom/mesh/nearest_on_triangle.h"
#include "lissom/mesh/operators.h"
#include "lissom/mesh/topology.h"
#include "refusal.h"
#include "tubes.h"

#include <doctest/doctest.h>

#include <cmath>
#include <map>
#include <numbers>

using namespace lissom;
using tubes::within;

namespace {

PlanePoints polygon(int n, double radius, const Eigen::RowVector2d& middle = {0, 0}, double wave = 0) {
    PlanePoints out(n, 2);
    for (int k = 0; k < n; ++k) {
        const double a = 2 * std::numbers::pi * (k + 0.3) / n, r = radius * (1 + wave * std::sin(5 * a));
        out.row(k) << middle.x() + r * std::cos(a), middle.y() + r * std::sin(a);
    }
    return out;
}

double area_of(const PlanePoints& p) {
    double area = 0;
    for (Eigen::Index i = 0; i < p.rows(); ++i) area += (p(i, 0) * p((i + 1) % p.rows(), 1) - p(i, 1) * p((i + 1) % p.rows(), 0)) / 2;
    return area;
}

struct Opened {
    TriangleMesh target = shapes::bumpy_sphere(4);
    TriangleMesh source = shapes::icosphere(3);
    RegionMaps maps = map_regions(source, within(source, 0, 2), within(source, 0.7, 2), target, within(target, -0.3, 2));
    PlaneLocator locator{maps.disk_map, maps.disk.triangles};

    [[nodiscard]] Part along(const PlanePoints& outline) const {
        std::vector<PlanePlace> places;
        for (Eigen::Index k = 0; k < outline.rows(); ++k) places.push_back(locator.locate(outline.row(k).transpose(), true));
        return open_target(target, maps, outline, places);
    }
};

} // namespace

TEST_CASE("a band between two polygons is covered once, all of it facing up") {
    for (const auto& [n, m] : {std::pair{24, 40}, {40, 11}, {6, 5}}) {
        CAPTURE(n);
        const PlanePoints outer = polygon(n, 2), inner = polygon(m, 0.9, {0.3, -0.2}, 0.1);
        const auto triangles = triangulate_band(outer, inner);
        CHECK(static_cast<int>(triangles.size()) == n + m);
        double area = 0;
        std::map<std::pair<int, int>, int> runs;
        for (const auto& t : triangles) {
            const auto point = [&](int k) -> Eigen::RowVector2d { return k < n ? outer.row(k) : inner.row(k - n); };
            const Eigen::RowVector2d a = point(t[0]), b = point(t[1]), c = point(t[2]);
            const double part = ((b - a).x() * (c - a).y() - (b - a).y() * (c - a).x()) / 2;
            CHECK(part > 0);
            area += part;
            for (std::size_t k = 0; k < 3; ++k) ++runs[{t[k], t[(k + 1) % 3]}];
        }
        CHECK(area == doctest::Approx(area_of(outer) - area_of(inner)));
        for (int k = 0; k < n; ++k) CHECK(runs[{k, (k + 1) % n}] == 1);
        for (int k = 0; k < m; ++k) CHECK(runs[{n + (k + 1) % m, n + k}] == 1); // the hole's side runs backwards
    }
}

TEST_CASE("a target opened along an outline has that one loop, on its own surface") {
    const Opened o;
    const PlanePoints outline = polygon(40, 0.5, {0.1, -0.1}, 0.1);
    const Part part = o.along(outline);
    CHECK(euler_characteristic(part.mesh) == 1);
    REQUIRE(part.loops.size() == 1);
    REQUIRE(boundary_loops(part.mesh).size() == 1);
    CHECK(part.loops[0].size() == 40);
    CHECK(non_manifold_vertices(part.mesh).empty());
    // The outline's points, the first first, then backwards.
    for (std::size_t k = 0; k < 40; ++k) {
        const Eigen::Index at = static_cast<Eigen::Index>((40 - k) % 40);
        const PlanePlace place = o.locator.locate(outline.row(at).transpose());
        Eigen::RowVector3d wanted = Eigen::RowVector3d::Zero();
        for (int c = 0; c < 3; ++c) wanted += place.weight[static_cast<std::size_t>(c)] * o.maps.disk.points.row(o.maps.disk.triangles(place.triangle, c));
        CHECK((part.mesh.points.row(part.loops[0][k]) - wanted).norm() < 1e-12);
    }
}

TEST_CASE("beyond the gap the target is what it was, and every vertex knows where it lies on it") {
    const Opened o;
    const Part part = o.along(polygon(40, 0.4));
    for (int v = 0; v < part.mesh.vertex_count(); ++v) {
        Eigen::RowVector3d place = Eigen::RowVector3d::Zero();
        for (std::size_t k = 0; k < 3; ++k) place += part.origin[v].weight[k] * o.target.points.row(part.origin[v].vertex[k]);
        CHECK((place - part.mesh.points.row(v)).norm() < 1e-12);
    }
    int whole = 0;
    for (int t = 0; t < part.mesh.triangle_count(); ++t) {
        if (!part.is_whole[t]) continue;
        ++whole;
        for (int c = 0; c < 3; ++c) CHECK(part.origin[part.mesh.triangles(t, c)].vertex[0] == o.target.triangles(part.triangle_origin[t], c));
    }
    CHECK(whole > o.target.triangle_count() / 2);
}

TEST_CASE("an outline that crosses itself or leaves no face around it is refused") {
    const Opened o;
    PlanePoints eight = polygon(20, 0.5);
    eight.row(3).swap(eight.row(12));
    CHECK(refusal([&] { (void)o.along(eight); }) == "outline-crosses-itself");
    CHECK(refusal([&] { (void)o.along(polygon(60, 0.99)); }) == "target-region-too-small");
    CHECK(refusal([&] { (void)o.along(polygon(20, 0.3)); }) == "none");
}
