#include "lissom/merge/part.h"

#include "lissom/mesh/operators.h"
#include "lissom/mesh/topology.h"
#include "refusal.h"
#include "tubes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <numeric>
#include <set>

using namespace lissom;
using tubes::first;
using tubes::within;

namespace {

Eigen::RowVector3d place_of(const Origin& origin, const Points& points) {
    Eigen::RowVector3d out = Eigen::RowVector3d::Zero();
    for (std::size_t k = 0; k < 3; ++k) out += origin.weight[k] * points.row(origin.vertex[k]);
    return out;
}

Part cut(const TriangleMesh& mesh, const std::vector<BoundaryLoop>& loops) { return cut_part(mesh, loops, "source"); }

/// The ring of vertices around a ball's upper cap.
struct Ball {
    TriangleMesh mesh = shapes::bumpy_sphere(4);
    std::vector<int> cap = within(mesh, 0.4, 2);
    std::vector<int> loop = loops_around(mesh, cap).at(0);
};

} // namespace

TEST_CASE("a place between two places has their weights, on one edge as on a whole triangle") {
    Points points(3, 3);
    points << 0, 0, 0, 1, 0, 0, 0, 2, 5;
    const Origin a = Origin::of(0), b = Origin::of(1), c = Origin::of(2);
    const Origin edge = between(a, b, 0.25), inside = between(edge, c, 0.5);
    CHECK((place_of(edge, points) - Eigen::RowVector3d(0.25, 0, 0)).norm() < 1e-15);
    CHECK((place_of(inside, points) - Eigen::RowVector3d(0.125, 1, 2.5)).norm() < 1e-15);
    CHECK((place_of(between(edge, b, 0.5), points) - Eigen::RowVector3d(0.625, 0, 0)).norm() < 1e-15);
    for (const Origin& o : {edge, inside}) CHECK(std::accumulate(o.weight.begin(), o.weight.end(), 0.0) == doctest::Approx(1));
    CHECK(a.is_vertex());
    CHECK(!edge.is_vertex());
    CHECK(between(a, b, 0).is_vertex());
    CHECK(between(a, b, 1).vertex[0] == 1);
}

TEST_CASE("the loops around a painted region part it from the rest, the region to their left") {
    const Ball ball;
    const Part inside = cut(ball.mesh, {{ball.loop, {}}});
    const std::set<int> cap(ball.cap.begin(), ball.cap.end());
    for (const Origin& o : inside.origin) CHECK(cap.contains(o.vertex[0]));
    CHECK(euler_characteristic(inside.mesh) == 1);
    CHECK(loops_around(ball.mesh, {}).empty());
    CHECK(loops_around(ball.mesh, within(ball.mesh, -0.3, 0.3)).size() == 2);
    CHECK(loops_around(ball.mesh, within(ball.mesh, -2, 2)).empty());
    // The mesh's own boundary is no way around: it is there already.
    const TriangleMesh tube = shapes::cylinder(24, 12, 3);
    std::vector<int> low(24 * 4);
    std::iota(low.begin(), low.end(), 0);
    CHECK(loops_around(tube, low).size() == 1);
}

TEST_CASE("cutting keeps one side whole, the other side is the rest, and both know where they came from") {
    const Ball ball;
    const std::vector<int> low = within(ball.mesh, -2, 0);
    const Part upper = cut(ball.mesh, {{ball.loop, ball.cap}}), lower = cut(ball.mesh, {{ball.loop, low}});
    CHECK(upper.mesh.triangle_count() + lower.mesh.triangle_count() == ball.mesh.triangle_count());
    CHECK(triangle_areas(upper.mesh).sum() + triangle_areas(lower.mesh).sum() == doctest::Approx(triangle_areas(ball.mesh).sum()));
    for (const Part* part : {&upper, &lower}) {
        REQUIRE(part->loops.size() == 1);
        CHECK(boundary_loops(part->mesh).size() == 1);
        CHECK(part->loops[0].size() == ball.loop.size());
        CHECK(part->origin[part->loops[0][0]].vertex[0] == ball.loop[0]); // the first vertex stays first
        for (int v = 0; v < part->mesh.vertex_count(); ++v) CHECK(part->mesh.points.row(v) == ball.mesh.points.row(part->origin[v].vertex[0]));
        for (int t = 0; t < part->mesh.triangle_count(); ++t) {
            CHECK(part->is_whole[t]);
            for (int c = 0; c < 3; ++c) CHECK(part->origin[part->mesh.triangles(t, c)].vertex[0] == ball.mesh.triangles(part->triangle_origin[t], c));
        }
        std::vector<int> surface_left = boundary_loops(part->mesh)[0], own = part->loops[0];
        std::rotate(own.begin(), std::find(own.begin(), own.end(), surface_left[0]), own.end());
        CHECK(own == surface_left);
    }
}

TEST_CASE("the direction of a loop does not matter where it says what to keep, or lies on an opening") {
    const Ball ball;
    std::vector<int> back(ball.loop.rbegin(), ball.loop.rend());
    CHECK(cut(ball.mesh, {{back, ball.cap}}).mesh.triangle_count() == cut(ball.mesh, {{ball.loop, ball.cap}}).mesh.triangle_count());
    const TriangleMesh tube = tubes::tube(12, 20, tubes::dome);
    std::vector<int> rim = first(20);
    CHECK(cut(tube, {{rim, {}}}).mesh.triangle_count() == tube.triangle_count());
    std::reverse(rim.begin(), rim.end());
    CHECK(cut(tube, {{rim, {}}}).mesh.triangle_count() == tube.triangle_count());
}

TEST_CASE("two loops cut a belt out, and a piece that no path reaches is kept") {
    const TriangleMesh ball = shapes::bumpy_sphere(4), mesh = shapes::joined({ball, shapes::moved(shapes::icosphere(1), Eigen::Affine3d(Eigen::Translation3d(9, 0, 0)))});
    const auto loops = loops_around(ball, within(ball, -0.3, 0.3));
    REQUIRE(loops.size() == 2);
    const Part belt = cut(mesh, {{loops[0], {}}, {loops[1], {}}});
    CHECK(belt.loops.size() == 2);
    CHECK(components(vertex_rings(belt.mesh)).count == 2);
    CHECK(euler_characteristic(belt.mesh) == 0 + 2);
}

TEST_CASE("loops that cannot be cut along are refused with what is wrong") {
    const TriangleMesh tube = tubes::tube(24, 20, tubes::dome), ring = shapes::torus(40, 20);
    const auto code = [](const TriangleMesh& mesh, const std::vector<BoundaryLoop>& loops) { return refusal([&] { (void)cut(mesh, loops); }); };
    CHECK(code(tube, {{first(20), {}}}) == "none");
    CHECK(code(tube, {{{0, 1, 9999}, {}}}) == "vertex-out-of-range");
    CHECK(code(tube, {{first(20), {-1}}}) == "vertex-out-of-range");
    CHECK(code(tube, {{{0, 1}, {}}}) == "loop-too-short");
    CHECK(code(tube, {{{0, 1, 2, 22, 21, 1, 20}, {}}}) == "loop-touches-itself");
    CHECK(code(tube, {{first(20), {}}, {{19, 39, 38}, {}}}) == "loops-touch");
    CHECK(code(tube, {{{0, 5, 10}, {}}}) == "loop-not-connected");
    CHECK(code(ring, {{first(20), {}}}) == "loop-not-separating"); // a meridian of the torus
    CHECK(code(tube, {{{40, 41, 61, 60}, {}}}) == "none");          // a quad of the side, cut out
    const Ball ball;
    std::vector<int> both = within(ball.mesh, 0.5, 2), low = within(ball.mesh, -2, 0.2);
    both.insert(both.end(), low.begin(), low.end());
    CHECK(code(ball.mesh, {{ball.loop, both}}) == "keep-side-unclear");
    // An edge of three: the loop may not run along it.
    TriangleMesh fin = shapes::with_fin(tube);
    const Edge three = [&] {
        for (const Edge& e : edges(fin))
            if (e.forward + e.backward == 3) return e;
        return Edge{};
    }();
    const int apex = [&] {
        for (int t = 0; t < tube.triangle_count(); ++t)
            for (int c = 0; c < 3; ++c)
                if (std::pair<int, int>(std::minmax(tube.triangles(t, c), tube.triangles(t, (c + 1) % 3))) == std::pair(three.a, three.b)) return tube.triangles(t, (c + 2) % 3);
        return -1;
    }();
    CHECK(code(fin, {{{three.a, three.b, apex}, {}}}) == "loop-non-manifold");
}
