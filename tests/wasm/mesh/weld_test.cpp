#include "lissom/mesh/weld.h"

#include "shapes.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numeric>
#include <set>

using namespace lissom;

namespace {

std::vector<int> all_of(const Points& points) {
    std::vector<int> all(static_cast<std::size_t>(points.rows()));
    std::iota(all.begin(), all.end(), 0);
    return all;
}

/// Vertex of the mesh that each corner of its soup came from.
int origin_of(const TriangleMesh& mesh, int corner) { return mesh.triangles(corner / 3, corner % 3); }

} // namespace

TEST_CASE("corners of a soup find the first at their place") {
    const TriangleMesh mesh = shapes::bumpy_sphere(2), soup = shapes::soup(mesh);
    const std::vector<int> twin = exact_twins(soup.points, std::vector<bool>(static_cast<std::size_t>(soup.vertex_count()), true));
    std::vector<int> first(static_cast<std::size_t>(mesh.vertex_count()), -1);
    for (int c = 0; c < soup.vertex_count(); ++c) {
        int& leader = first[origin_of(mesh, c)];
        if (leader < 0) leader = c;
        CHECK(twin[c] == leader);
    }
}

TEST_CASE("negative zero is zero, the next number is another place, and who is not used has no twin") {
    Points points(5, 3);
    points << 0.0, 1, 2, //
        -0.0, 1, 2,      //
        0, std::nextafter(1.0, 2.0), 2, //
        0, 1, 2,         //
        0, 1, 2;
    CHECK(exact_twins(points, {true, true, true, false, true}) == std::vector<int>{0, 0, 2, -1, 0});
    CHECK(exact_twins(points, {false, true, true, true, true}) == std::vector<int>{-1, 1, 2, 1, 1});
}

TEST_CASE("points scattered around one place come together, whatever their order and the unit of length (seeds 1 to 4)") {
    const TriangleMesh mesh = shapes::bumpy_sphere(2);
    const double jitter = 1e-4; // edges are about 0.15
    const Points soup = shapes::soup(mesh, jitter).points;
    for (const double unit : {1.0, 1e-6, 1e6})
        for (std::uint64_t seed = 1; seed <= 4; ++seed) {
            CAPTURE(unit);
            CAPTURE(seed);
            const std::vector<int> place = shapes::permutation(static_cast<int>(soup.rows()), seed);
            Points mixed(soup.rows(), 3);
            std::vector<int> origin(place.size());
            for (int c = 0; c < soup.rows(); ++c) {
                mixed.row(place[c]) = unit * soup.row(c);
                origin[place[c]] = origin_of(mesh, c);
            }
            const std::vector<int> group = near_twins(mixed, all_of(mixed), 4 * jitter * unit);
            CHECK(std::set<int>(group.begin(), group.end()).size() == static_cast<std::size_t>(mesh.vertex_count()));
            for (std::size_t c = 0; c < group.size(); ++c) {
                CHECK(origin[group[c]] == origin[c]);
                CHECK(group[c] <= static_cast<int>(c));
            }
        }
}

TEST_CASE("only candidates are joined, and only within the tolerance") {
    Points points(4, 3);
    points << 0, 0, 0, 0.9, 0, 0, 0.5, 0, 0, 3, 0, 0;
    CHECK(near_twins(points, std::vector<int>{0, 2, 3}, 0.6) == std::vector<int>{0, 0, 3});
    CHECK(near_twins(points, std::vector<int>{0, 1, 2, 3}, 0.6) == std::vector<int>{0, 0, 0, 3}); // the third is near two leaders
    CHECK(near_twins(points, std::vector<int>{0, 1}, 0.6) == std::vector<int>{0, 1});
    CHECK(near_twins(points, std::vector<int>{}, 0.6).empty());
}

TEST_CASE("a triangle is repeated by the same three vertices in any order") {
    Triangles triangles(6, 3);
    triangles << 0, 1, 2, //
        1, 2, 0,          //
        2, 1, 0,          //
        0, 1, 3,          //
        0, 2, 2,          //
        3, 1, 0;
    CHECK(repeated_triangles(triangles) == std::vector<bool>{false, true, true, false, false, true});
    CHECK(repeated_triangles(Triangles(0, 3)).empty());
}
