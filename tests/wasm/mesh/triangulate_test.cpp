#include "lissom/mesh/triangulate.h"

#include "lissom/mesh/operators.h"
#include "lissom/mesh/topology.h"
#include "shapes.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <numeric>
#include <string>

using namespace lissom;

namespace {

Points flat(const std::vector<std::pair<double, double>>& corners) {
    Points points(static_cast<int>(corners.size()), 3);
    for (std::size_t i = 0; i < corners.size(); ++i)
        points.row(static_cast<int>(i)) << corners[i].first, corners[i].second, 0;
    return points;
}

std::vector<int> all_of(const Points& points) {
    std::vector<int> corners(points.rows());
    std::iota(corners.begin(), corners.end(), 0);
    return corners;
}

/// k − 2 triangles that cover the polygon once, all facing up.
void check_covers(const Points& points, double area) {
    const Triangulation cut = triangulate(shapes::polygons(points, {all_of(points)}));
    REQUIRE(cut.triangles.rows() == points.rows() - 2);
    const TriangleMesh mesh{points, cut.triangles};
    CHECK(triangle_areas(mesh).sum() == doctest::Approx(area).epsilon(1e-9));
    CHECK(euler_characteristic(mesh) == 1);
    for (const Edge& e : edges(mesh))
        CHECK((e.forward <= 1 && e.backward <= 1));
}

/// Twice the signed area by the shoelace formula, halved.
double area_of(const Points& p) {
    double sum = 0;
    for (int i = 0; i < p.rows(); ++i) {
        const int j = (i + 1) % static_cast<int>(p.rows());
        sum += p(i, 0) * p(j, 1) - p(j, 0) * p(i, 1);
    }
    return 0.5 * sum;
}

Points star(int spikes, double inner) {
    Points points(2 * spikes, 3);
    for (int i = 0; i < 2 * spikes; ++i) {
        const double t = std::numbers::pi * i / spikes, r = i % 2 ? inner : 1;
        points.row(i) << r * std::cos(t), r * std::sin(t), 0;
    }
    return points;
}

} // namespace

TEST_CASE("polygons of every kind are covered once by k − 2 triangles") {
    const std::vector<Points> outlines{
        flat({{0, 0}, {1, 0}, {1, 1}, {0, 1}}),
        flat({{0, 0}, {4, 0}, {1, 1}, {0, 4}}),                                  // a concave quad
        flat({{1, 1}, {0, 4}, {0, 0}, {4, 0}}),                                  // the same from another corner
        flat({{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}}),                  // an L
        flat({{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}}),  // straight corners
        flat({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {0, 1}}),                          // three in a row
        star(5, 0.3), star(40, 0.05), star(500, 0.9), star(50, 1)};
    for (const Points& outline : outlines) {
        CAPTURE(outline.rows());
        check_covers(outline, area_of(outline));
        const Eigen::Affine3d map = Eigen::Translation3d(9, 8, 7) * Eigen::AngleAxisd(2, Eigen::Vector3d(1, 2, 2).normalized())
                                    * Eigen::Scaling(1e-3);
        check_covers(shapes::moved({outline, Triangles(0, 3)}, map).points, 1e-6 * area_of(outline));
    }
}

TEST_CASE("ragged outlines are covered once (seeds 1 to 40)") {
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        CAPTURE(seed);
        const std::vector<int> radii = shapes::permutation(60, seed);
        Points outline(30, 3);
        for (int i = 0; i < 30; ++i) {
            const double t = 2 * std::numbers::pi * (i + 0.01 * radii[30 + i]) / 30, r = 0.05 + radii[i];
            outline.row(i) << r * std::cos(t), r * std::sin(t), 0;
        }
        check_covers(outline, area_of(outline));
    }
}

TEST_CASE("a spiral of many corners is covered once") {
    Points spiral(2000, 3);
    for (int i = 0; i < 1000; ++i) {
        const double t = 40.0 * i / 1000;
        spiral.row(i) << (1 + t) * std::cos(t), (1 + t) * std::sin(t), 0;
        spiral.row(1999 - i) << (2 + t) * std::cos(t), (2 + t) * std::sin(t), 0;
    }
    const double area = area_of(spiral);
    check_covers(area > 0 ? spiral : Points(spiral.colwise().reverse()), std::abs(area));
}

TEST_CASE("a quad is cut along its shorter diagonal inside it, a square along the one from its first corner") {
    const auto first_cut = [](const Points& p) { return triangulate(shapes::polygons(p, {{0, 1, 2, 3}})).triangles; };
    Triangles along_02(2, 3), along_13(2, 3);
    along_02 << 0, 1, 2, 0, 2, 3;
    along_13 << 0, 1, 3, 1, 2, 3;
    CHECK(first_cut(flat({{0, 0}, {1, 0}, {1, 1}, {0, 1}})) == along_02);
    CHECK(first_cut(flat({{0, 0}, {3, -1}, {4, 0}, {3, 1}})) == along_13);
    // In a dart the shorter diagonal may run outside.
    CHECK(first_cut(flat({{-1, 0}, {0, 0.1}, {1, 0}, {0, 3}})) == along_13);
    CHECK(first_cut(flat({{0, 0.1}, {1, 0}, {0, 3}, {-1, 0}})) == along_02);
    CHECK(first_cut(flat({{0, -1}, {3, 0}, {0, 1}, {-3, 0}})) == along_02);
}

TEST_CASE("polygons that touch or cross themselves end, with no fewer than k − 2 triangles") {
    const Points eight = flat({{0, 0}, {1, 1}, {1, 0}, {0, 1}});
    CHECK(triangulate(shapes::polygons(eight, {{0, 1, 2, 3}})).triangles.rows() == 2);
    Points pentagram(5, 3), crooked(30, 3), line(6, 3);
    for (int i = 0; i < 5; ++i)
        pentagram.row(i) << std::cos(0.8 * std::numbers::pi * i), std::sin(0.8 * std::numbers::pi * i), 0;
    for (int i = 0; i < 30; ++i)
        crooked.row(i) << std::sin(7.3 * i), std::cos(5.1 * i * i), std::sin(3.7 * i + 1);
    for (int i = 0; i < 6; ++i)
        line.row(i) << i, 2 * i, 0;
    for (const Points& p : {pentagram, crooked, line})
        CHECK(triangulate(shapes::polygons(p, {all_of(p)})).triangles.rows() == p.rows() - 2);
    // A square with a square hole, reached along one edge and left along the same.
    const Points ring = flat({{0, 0}, {3, 0}, {3, 3}, {0, 3}, {1, 1}, {1, 2}, {2, 2}, {2, 1}});
    const PolygonMesh bridged = shapes::polygons(ring, {{0, 1, 2, 3, 0, 4, 5, 6, 7, 4}});
    const TriangleMesh cut{ring, triangulate(bridged).triangles};
    CHECK(cut.triangles.rows() == 8);
    CHECK(triangle_areas(cut).sum() == doctest::Approx(8));
    CHECK(euler_characteristic(cut) == 0);
}

TEST_CASE("repeated corners cost nothing but themselves") {
    const Points square = flat({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
    for (const std::vector<int>& face : std::vector<std::vector<int>>{{0, 0, 1, 2, 3}, {0, 1, 1, 2, 2, 3, 3, 0}, {0, 1, 2, 1, 2, 3}}) {
        const Triangulation cut = triangulate(shapes::polygons(square, {face}));
        CHECK(cut.triangles.rows() >= 2);
        for (int t = 0; t < cut.triangles.rows(); ++t)
            CHECK((cut.triangles(t, 0) != cut.triangles(t, 1) && cut.triangles(t, 1) != cut.triangles(t, 2)
                   && cut.triangles(t, 2) != cut.triangles(t, 0)));
    }
    CHECK(triangulate(shapes::polygons(square, {{0, 1, 0, 2}})).triangles.rows() == 1);
    CHECK(triangulate(shapes::polygons(square, {{0, 1, 0, 1}})).triangles.rows() == 0);
}

TEST_CASE("triangles know their polygon, in file order") {
    const Points p = star(4, 0.5);
    const Triangulation cut = triangulate(shapes::polygons(p, {{0, 1, 2}, {0, 1}, {0, 1, 2, 3, 4}, {2, 3, 99}, {4, 5, 6, 7}}));
    CHECK(cut.polygon_of_triangle == std::vector<int>{0, 2, 2, 2, 4, 4});
}
