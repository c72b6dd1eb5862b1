#include "lissom/merge/region_maps.h"

#include "lissom/mesh/topology.h"
#include "refusal.h"
#include "tubes.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <set>

using namespace lissom;
using tubes::within;

namespace {

double area_of(const PlanePoints& map, const Triangles& triangles) {
    double area = 0;
    for (int t = 0; t < triangles.rows(); ++t) {
        const Eigen::RowVector2d a = map.row(triangles(t, 0)), b = map.row(triangles(t, 1)), c = map.row(triangles(t, 2));
        area += ((b - a).x() * (c - a).y() - (b - a).y() * (c - a).x()) / 2;
    }
    return area;
}

struct Mapped {
    TriangleMesh source = shapes::bumpy_sphere(4), target = shapes::icosphere(4);
    std::vector<int> region = within(source, -0.1, 2), feature = within(source, 0.7, 2), target_region = within(target, -0.3, 2);
    RegionMaps maps = map_regions(source, region, feature, target, target_region);
};

} // namespace

TEST_CASE("the ring is the region without its feature, between two borders that keep it to their left") {
    const Mapped m;
    const RegionMaps& maps = m.maps;
    CHECK(euler_characteristic(maps.ring) == 0);
    const std::set<int> feature(m.feature.begin(), m.feature.end()), region(m.region.begin(), m.region.end());
    for (const int v : maps.inner) CHECK(feature.contains(maps.ring_vertices[v]));
    for (int v = 0; v < maps.ring.vertex_count(); ++v) {
        CHECK(region.contains(maps.ring_vertices[v]));
        CHECK(maps.ring.points.row(v) == m.source.points.row(maps.ring_vertices[v]));
    }
    const auto loops = boundary_loops(maps.ring); // with the surface to the left
    CHECK(std::set<std::vector<int>>(loops.begin(), loops.end()) == std::set<std::vector<int>>{maps.outer, maps.inner});
}

TEST_CASE("the disk is the target's region, with the way back") {
    const Mapped m;
    const RegionMaps& maps = m.maps;
    CHECK(euler_characteristic(maps.disk) == 1);
    CHECK(boundary_loops(maps.disk) == std::vector<std::vector<int>>(1, maps.border));
    REQUIRE(static_cast<int>(maps.disk_triangles.size()) == maps.disk.triangle_count());
    for (int t = 0; t < maps.disk.triangle_count(); ++t)
        for (int c = 0; c < 3; ++c) CHECK(maps.disk_vertices[maps.disk.triangles(t, c)] == m.target.triangles(maps.disk_triangles[t], c));
}

TEST_CASE("maps keep the orientation, the target's has area π, the source's with its hole filled has it too") {
    const Mapped m;
    CHECK(area_of(m.maps.disk_map, m.maps.disk.triangles) == doctest::Approx(std::numbers::pi));
    const double ring = area_of(m.maps.ring_map, m.maps.ring.triangles);
    CHECK(ring > 0);
    double hole = 0; // of the inner border's polygon, which runs around it clockwise
    for (std::size_t i = 0; i < m.maps.inner.size(); ++i) {
        const Eigen::RowVector2d a = m.maps.ring_map.row(m.maps.inner[i]), b = m.maps.ring_map.row(m.maps.inner[(i + 1) % m.maps.inner.size()]);
        hole -= (a.x() * b.y() - a.y() * b.x()) / 2;
    }
    CHECK(ring + hole == doctest::Approx(std::numbers::pi));
}

TEST_CASE("what the feature looks like does not matter to the maps") {
    Mapped m;
    const PlanePoints before = m.maps.ring_map;
    std::set<int> rim;
    for (const int v : m.maps.inner) rim.insert(m.maps.ring_vertices[v]);
    for (const int v : m.feature)
        if (!rim.contains(v)) m.source.points.row(v) *= 1 + 0.5 * std::sin(5.0 * v);
    CHECK(map_regions(m.source, m.region, m.feature, m.target, m.target_region).ring_map == before);
}

TEST_CASE("a placement scales, turns and then moves") {
    PlanePoints points(2, 2);
    points << 1, 0, 0, 2;
    const PlanePoints placed = Placement{{10, 20}, 90, 3}(points);
    PlanePoints wanted(2, 2);
    wanted << 10, 23, 4, 20;
    CHECK((placed - wanted).norm() < 1e-12);
    CHECK(Placement{}(points) == points);
}

TEST_CASE("regions that cannot work are refused with what is wrong") {
    const TriangleMesh ball = shapes::icosphere(4);
    const auto code = [&](const std::vector<int>& region, const std::vector<int>& feature, const std::vector<int>& target) {
        return refusal([&] { (void)map_regions(ball, region, feature, ball, target); });
    };
    const std::vector<int> cap = within(ball, 0.1, 2), tip = within(ball, 0.7, 2), belt = within(ball, -0.4, 0.4), none;
    CHECK(code(cap, tip, cap) == "none");
    CHECK(code(cap, none, cap) == "no-feature");
    CHECK(code(tip, cap, cap) == "feature-outside-region");
    CHECK(code(cap, cap, cap) == "region-touches-feature");
    CHECK(code(cap, tip, none) == "no-target-region");
    CHECK(code(cap, tip, belt) == "target-region-not-a-disk");
    CHECK(code(within(ball, -2, 2), tip, cap) == "region-not-a-ring");
}
