#include "lissom/mesh/self_intersections.h"

#include "shapes.h"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

using namespace lissom;
using Eigen::Vector3d;
using Corners = std::array<Vector3d, 3>;

TEST_CASE("triangles that cross, touch, overlap in a plane, or miss") {
    const Corners flat{Vector3d(0, 0, 0), Vector3d(2, 0, 0), Vector3d(0, 2, 0)};
    const auto meets = [&](Corners other) {
        const bool one = triangles_meet(flat, other), two = triangles_meet(other, flat);
        CHECK(one == two);
        return one;
    };
    CHECK(meets({Vector3d(0.5, 0.5, -1), Vector3d(0.5, 0.5, 1), Vector3d(3, 3, 0)}));
    CHECK_FALSE(meets({Vector3d(0.5, 0.5, 0.1), Vector3d(0.5, 0.5, 1), Vector3d(3, 3, 1)}));
    CHECK(meets({Vector3d(0.5, 0.5, 0), Vector3d(0.5, 0.5, 1), Vector3d(3, 3, 1)})); // a corner touches
    CHECK_FALSE(meets({Vector3d(1.5, 1.5, -1), Vector3d(1.5, 1.5, 1), Vector3d(3, 3, 0)}));
    CHECK(meets({Vector3d(0.1, 0.1, 0), Vector3d(0.2, 0.1, 0), Vector3d(0.1, 0.2, 0)})); // inside, in its plane
    CHECK(meets({Vector3d(-1, 0.5, 0), Vector3d(3, 0.5, 0), Vector3d(-1, 0.6, 0)}));
    CHECK_FALSE(meets({Vector3d(2, 2, 0), Vector3d(3, 2, 0), Vector3d(2, 3, 0)}));
    CHECK(meets({Vector3d(-1, 0.5, 0), Vector3d(3, 0.5, 0), Vector3d(0, 0.5, 5)})); // an edge lies in it
    CHECK_FALSE(meets({Vector3d(-1, 5, 0), Vector3d(3, 5, 0), Vector3d(0, 5, 5)}));
}

TEST_CASE("every pair is found that looking at all of them finds") {
    std::mt19937 draw(3);
    std::uniform_real_distribution<double> uniform(0, 1);
    TriangleMesh mesh{Points(300, 3), Triangles(100, 3)};
    for (int t = 0; t < 100; ++t) {
        const Vector3d at(uniform(draw), uniform(draw), uniform(draw));
        for (int k = 0; k < 3; ++k) {
            mesh.points.row(3 * t + k) = (at + 0.3 * Vector3d(uniform(draw), uniform(draw), uniform(draw))).transpose();
            mesh.triangles(t, k) = 3 * t + k;
        }
    }
    int pairs = 0;
    const auto corners = [&](int t) { return Corners{Vector3d(mesh.points.row(3 * t)), Vector3d(mesh.points.row(3 * t + 1)), Vector3d(mesh.points.row(3 * t + 2))}; };
    for (int s = 0; s < 100; ++s)
        for (int t = s + 1; t < 100; ++t) pairs += triangles_meet(corners(s), corners(t));
    CHECK(pairs > 10);
    CHECK(self_intersections(mesh).pairs == pairs);
}

TEST_CASE("what crosses itself is told, in any unit; what does not is clean") {
    for (const TriangleMesh& mesh : {shapes::box(6, 20, 6, {1, 4, 1}), shapes::icosphere(3), shapes::torus(), shapes::moebius(), shapes::three_sheets()})
        CHECK(self_intersections(mesh).pairs == 0);
    const TriangleMesh apart = shapes::two_spheres(2);
    CHECK(self_intersections(apart).pairs == 0);
    TriangleMesh near = shapes::joined({shapes::icosphere(2), shapes::moved(shapes::icosphere(2), Eigen::Affine3d(Eigen::Translation3d(1.1, 0.03, 0.07)))});
    const SelfIntersections found = self_intersections(near);
    CHECK(found.pairs > 20);
    CHECK(found.triangles.size() > 20);
    for (const double unit : {1e-6, 1e6}) CHECK(self_intersections(shapes::moved(near, Eigen::Affine3d(Eigen::Scaling(unit)))).pairs == doctest::Approx(found.pairs).epsilon(0.02));
    CHECK(self_intersections(shapes::klein_bottle()).pairs > 0);
    near.points(0, 0) = std::nan("");
    CHECK(self_intersections(near).pairs <= found.pairs);
    CHECK(self_intersections({Points(0, 3), Triangles(0, 3)}).pairs == 0);
}

TEST_CASE("a finder follows a surface as it moves, and asked about some triangles finds their pairs alone") {
    const TriangleMesh still = shapes::joined({shapes::bumpy_sphere(2), shapes::icosphere(2)});
    IntersectionFinder finder({still.points, still.triangles});
    for (const double by : {4.0, 1.1, 0.3, 2.5}) {
        TriangleMesh mesh = still;
        mesh.points.bottomRows(mesh.vertex_count() / 2).rowwise() += Eigen::RowVector3d(by, 0.03, 0.07);
        const SelfIntersections all = self_intersections(mesh), found = finder.find(mesh.points);
        CHECK(found.pairs == all.pairs);
        CHECK(found.triangles == all.triangles);
        std::vector<int> half;
        for (int t = 0; t < mesh.triangle_count() / 2; ++t) half.push_back(t);
        CHECK(finder.find(mesh.points, half).pairs == all.pairs); // one of each pair lies in the first sphere
        CHECK(finder.find(mesh.points, std::vector<int>{}).pairs == 0);
        if (all.pairs > 0) {
            const int one = all.triangles.front();
            const SelfIntersections of_one = finder.find(mesh.points, std::vector<int>{one});
            CHECK(of_one.pairs == std::ssize(of_one.triangles) - 1);
            CHECK(of_one.triangles.front() == one);
        }
    }
}

TEST_CASE("triangles around one vertex are looked at where that is asked for") {
    // Two triangles with the corner 0; the side opposite it of the second goes up through the first, or past it.
    TriangleMesh mesh{Points(5, 3), Triangles(2, 3)};
    mesh.points << 0, 0, 0, 2, 0, 0, 0, 2, 0, 0.5, 0.5, -1, 0.5, 0.5, 1;
    mesh.triangles << 0, 1, 2, 0, 3, 4;
    using Neighbours = IntersectionFinder::Neighbours;
    CHECK(IntersectionFinder(mesh).find(mesh.points).pairs == 0);
    CHECK(IntersectionFinder(mesh, Neighbours::looked_at).find(mesh.points).pairs == 1);
    mesh.points.row(3) << -0.5, 0.5, -1;
    mesh.points.row(4) << -0.5, 0.5, 1;
    CHECK(IntersectionFinder(mesh, Neighbours::looked_at).find(mesh.points).pairs == 0);
    for (const TriangleMesh& clean : {shapes::box(6, 20, 6, {1, 4, 1}), shapes::icosphere(3), shapes::torus(), shapes::sheet()})
        CHECK(IntersectionFinder(clean, Neighbours::looked_at).find(clean.points).pairs == 0);
}
