#include "lissom/mesh/delaunay.h"

#include "shapes.h"

#include "lissom/mesh/half_edges.h"
#include "lissom/mesh/operators.h"
#include "lissom/mesh/topology.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace lissom;

namespace {

/// A flat sheet whose vertices are anywhere near their places: many edges are the worse diagonal.
TriangleMesh jumbled(int n) {
    TriangleMesh sheet = shapes::sheet(n, n);
    const double h = 0.35 / n;
    for (int v = 0; v < sheet.vertex_count(); ++v) {
        const double x = sheet.points(v, 0), y = sheet.points(v, 1);
        if (x <= 1e-9 || y <= 1e-9 || x >= 1 - 1e-9 || y >= 1 - 1e-9) continue;
        sheet.points(v, 0) += h * std::sin(37.0 * v);
        sheet.points(v, 1) += h * std::sin(53.0 * v + 1);
    }
    return sheet;
}

/// The least weight of an edge between two triangles, from the angles themselves.
double least_weight(const TriangleMesh& mesh) {
    double least = INFINITY;
    for_each_edge(half_edges(mesh), [&](auto first, auto last) {
        if (last - first != 2) return;
        double sum = 0;
        for (auto side = first; side != last; ++side) {
            const auto at = [&](int k) -> Eigen::Vector3d { return mesh.points.row(mesh.triangles(side->triangle, (side->corner + k) % 3)); };
            const Eigen::Vector3d a = at(0) - at(2), b = at(1) - at(2);
            sum += a.dot(b) / a.cross(b).norm();
        }
        least = std::min(least, sum);
    });
    return least;
}

} // namespace

TEST_CASE("a flat sheet has no negative weight afterwards, the same area, and nothing left to flip") {
    TriangleMesh sheet = jumbled(20);
    const double area = triangle_areas(sheet).sum();
    CHECK(least_weight(sheet) < -0.1);
    CHECK(flip_to_delaunay(sheet) > 10);
    CHECK(least_weight(sheet) > -1e-6);
    CHECK(triangle_areas(sheet).sum() == doctest::Approx(area));
    for (int t = 0; t < sheet.triangle_count(); ++t) {
        const auto at = [&](int k) -> Eigen::Vector3d { return sheet.points.row(sheet.triangles(t, k)); };
        CHECK((at(1) - at(0)).cross(at(2) - at(0))[2] > 0);
    }
    CHECK(euler_characteristic(sheet) == 1);
    CHECK(flip_to_delaunay(sheet) == 0);
}

TEST_CASE("neither unit nor place nor direction decides what is flipped") {
    TriangleMesh here = jumbled(12);
    const Eigen::Affine3d far = Eigen::Translation3d(5, -3, 2) * Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, 2, 3).normalized()) * Eigen::Scaling(1e-4);
    TriangleMesh there = shapes::moved(here, far);
    CHECK(flip_to_delaunay(here) == flip_to_delaunay(there));
    CHECK(here.triangles == there.triangles);
}

TEST_CASE("a needle is taken up by its neighbour") {
    TriangleMesh mesh = shapes::sheet(1, 1);
    mesh.points.resize(4, 3);
    mesh.points << 0, 0, 0, 2, 0, 0, 1, 1e-7, 0, 1, -1, 0;
    mesh.triangles.resize(2, 3);
    mesh.triangles << 0, 1, 2, 1, 0, 3; // the first has no height to speak of
    CHECK(flip_to_delaunay(mesh) == 1);
    CHECK(triangle_areas(mesh).minCoeff() > 0.49);
}

TEST_CASE("sharp edges stay, and so does what is no surface") {
    const TriangleMesh bar = shapes::bar();
    TriangleMesh flipped = bar;
    (void)flip_to_delaunay(flipped);
    CHECK(signed_volume(flipped) == doctest::Approx(signed_volume(bar)));
    for (TriangleMesh mesh : {shapes::three_sheets(), shapes::moebius(), shapes::klein_bottle(), shapes::bow_tie(), shapes::soup(shapes::icosphere(2))}) {
        const double area = triangle_areas(mesh).sum();
        const int euler = euler_characteristic(mesh);
        (void)flip_to_delaunay(mesh);
        CHECK(triangle_areas(mesh).sum() == doctest::Approx(area).epsilon(0.02));
        CHECK(euler_characteristic(mesh) == euler);
    }
}
