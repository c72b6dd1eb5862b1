#include "lissom/mesh/triangle_tree.h"

#include "lissom/mesh/nearest_on_triangle.h"
#include "shapes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace lissom;
using Eigen::Vector3d;

namespace {

/// What meets a ray by trying every triangle, through planes and areas.
std::vector<int> tried(const TriangleMesh& mesh, const Vector3d& o, const Vector3d& d) {
    std::vector<int> found;
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        const Vector3d a = mesh.points.row(mesh.triangles(t, 0)), b = mesh.points.row(mesh.triangles(t, 1)), c = mesh.points.row(mesh.triangles(t, 2));
        const Vector3d n = (b - a).cross(c - a);
        const double depth = n.dot(a - o) / n.dot(d);
        const Vector3d p = o + depth * d;
        const bool inside = n.dot((b - a).cross(p - a)) > 0 && n.dot((c - b).cross(p - b)) > 0 && n.dot((a - c).cross(p - c)) > 0;
        if (depth >= 0 && inside) found.push_back(t);
    }
    return found;
}

} // namespace

TEST_CASE("a tree finds every triangle on a ray, whatever the mesh and however large") {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> unit(-1, 1);
    const auto vector = [&] { return Vector3d(unit(random), unit(random), unit(random)); };
    for (const double scale : {1e-6, 1.0, 1e6})
        for (TriangleMesh mesh : {shapes::torus(), shapes::soup(shapes::bumpy_sphere()), shapes::moebius(), shapes::klein_bottle(), shapes::two_spheres()}) {
            mesh.points *= scale;
            const TriangleTree tree(mesh);
            for (int k = 0; k < 100; ++k) {
                const Vector3d o = 3 * scale * vector(), d = 0.7 * scale * vector() - o;
                const std::vector<RayHit> hits = tree.hits(o, d);
                CHECK(std::is_sorted(hits.begin(), hits.end(), [](const RayHit& a, const RayHit& b) { return a.depth < b.depth; }));
                std::vector<int> found;
                for (const RayHit& hit : hits) found.push_back(hit.triangle);
                std::sort(found.begin(), found.end());
                CHECK(found == tried(mesh, o, d));
            }
        }
}

TEST_CASE("a ray through a corner, along an axis or from within still meets the surface") {
    const TriangleMesh mesh = shapes::box(4, 4, 4);
    const TriangleTree tree(mesh);
    const std::vector<RayHit> through = tree.hits({0, 0.5, 5}, {0, 0, -1});
    REQUIRE(through.size() >= 2);
    CHECK(through.front().depth == doctest::Approx(4.5));
    CHECK(through.back().depth == doctest::Approx(5.5));
    CHECK(tree.hits({0, 0.4, 0}, {0.01, 0.003, 1}).size() == 1);
    CHECK(tree.hits({0, 0.4, 2}, {0.01, 0.003, 1}).empty());
    CHECK(tree.hits({0, 0.4, 2}, {0, 0, 0}).empty());
}

TEST_CASE("the nearest triangle is that of trying them all; a plane crosses those with corners on both sides") {
    std::mt19937 random(8);
    std::uniform_real_distribution<double> unit(-1.5, 1.5);
    const TriangleMesh mesh = shapes::bumpy_sphere();
    const TriangleTree tree(mesh);
    for (int k = 0; k < 60; ++k) {
        const Vector3d p(unit(random), unit(random), unit(random));
        double least = INFINITY;
        for (int t = 0; t < mesh.triangle_count(); ++t)
            least = std::min(least, (nearest_on_triangle(p, mesh.points.row(mesh.triangles(t, 0)), mesh.points.row(mesh.triangles(t, 1)), mesh.points.row(mesh.triangles(t, 2))).point - p).norm());
        CHECK(tree.nearest(p).distance == doctest::Approx(least).epsilon(1e-12));
        const double offset = 0.5 * unit(random);
        std::vector<int> expected;
        for (int t = 0; t < mesh.triangle_count(); ++t) {
            int above = 0;
            for (int c = 0; c < 3; ++c) above += mesh.points.row(mesh.triangles(t, c)).dot(p) > offset ? 1 : 0;
            if (above % 3 != 0) expected.push_back(t);
        }
        CHECK(tree.crossed(p, offset) == expected);
    }
}

TEST_CASE("no triangles, or some that are not finite, are no hindrance") {
    const TriangleMesh none;
    CHECK(TriangleTree(none).hits({0, 0, 0}, {1, 0, 0}).empty());
    CHECK(TriangleTree(none).nearest({0, 0, 0}).triangle == -1);
    const TriangleMesh broken = shapes::with_nan_vertex(shapes::icosphere(2), 3);
    const TriangleTree tree(broken);
    CHECK(tree.hits({0, 0, 5}, {0.01, 0.02, -1}).size() == 2);
    CHECK(tree.nearest({0, 0, 3}).distance == doctest::Approx(2).epsilon(0.01));
}

TEST_CASE("the nearest triangle of some is that of trying them all, with and without a hint, and none beyond the reach") {
    std::mt19937 random(8);
    std::uniform_real_distribution<double> unit(-1, 1);
    const TriangleMesh mesh = shapes::bumpy_sphere();
    const TriangleTree tree(mesh);
    const auto accepts = [](int t) { return t % 7 == 3; };
    for (int k = 0; k < 100; ++k) {
        const Vector3d p(unit(random), unit(random), unit(random));
        double least = INFINITY;
        for (int t = 3; t < mesh.triangle_count(); t += 7)
            least = std::min(least, (nearest_on_triangle(p, mesh.points.row(mesh.triangles(t, 0)), mesh.points.row(mesh.triangles(t, 1)), mesh.points.row(mesh.triangles(t, 2))).point - p).norm());
        const auto found = tree.nearest_where(p, INFINITY, -1, accepts);
        CHECK(found.distance == doctest::Approx(least).epsilon(1e-12));
        CHECK(found.triangle % 7 == 3);
        for (const int hint : {0, 3, found.triangle, mesh.triangle_count() - 1}) {
            const auto again = tree.nearest_where(p, INFINITY, hint, accepts);
            CHECK(again.triangle == found.triangle);
            CHECK(again.point == found.point);
        }
        CHECK(tree.nearest_where(p, 0.99 * least, -1, accepts).triangle == -1);
        CHECK(tree.nearest_where(p, 1.01 * least, -1, accepts).triangle == found.triangle);
    }
}
