#include "lissom/wear/push_out.h"

#include "shapes.h"

#include <doctest/doctest.h>

#include <array>

using Eigen::Scaling;
using lissom::Body;
using lissom::TriangleMesh;

namespace {

/// A tube around a unit ball.
TriangleMesh belt(double radius) {
    return shapes::moved(shapes::cylinder(60, 30, 1.2), Eigen::Affine3d(Eigen::Translation3d(0, 0, -0.6) * Scaling(radius, radius, 1.0)));
}

} // namespace

TEST_CASE("what lies inside comes out with a margin, what lies outside stays") {
    const Body body(shapes::icosphere(4), 3.5);
    TriangleMesh narrow = belt(0.95), wide = belt(1.1);
    const std::array<const Body*, 1> bodies{&body};
    const lissom::PushedOut pushed = lissom::push_out(narrow, bodies, 0.01);
    CHECK(pushed.before.vertices > 300);
    CHECK(pushed.before.face_centres > 300);
    CHECK(pushed.after.none());
    CHECK(lissom::inside(narrow, bodies).none());
    CHECK(pushed.rounds <= 3);
    for (int v = 0; v < narrow.vertex_count(); ++v) CHECK(narrow.points.row(v).norm() > 0.995);
    const lissom::Points before = wide.points;
    const lissom::PushedOut left = lissom::push_out(wide, bodies, 0.01);
    CHECK(left.before.none());
    CHECK(left.rounds == 0);
    CHECK(wide.points == before);
}

TEST_CASE("of two bodies it comes out of both, and what is not freed is counted") {
    const Body ball(shapes::icosphere(4), 3.5), beside(shapes::moved(shapes::icosphere(4), Eigen::Affine3d(Eigen::Translation3d(0.05, 0, 0))), 3.5);
    TriangleMesh narrow = belt(0.97);
    const std::array<const Body*, 2> bodies{&ball, &beside};
    CHECK(lissom::push_out(narrow, bodies, 0.01).after.none());
    TriangleMesh again = belt(0.9);
    const lissom::PushedOut none = lissom::push_out(again, bodies, 0.01, 6, 0);
    CHECK(none.after.vertices == none.before.vertices);
    CHECK(!none.after.none());
}

TEST_CASE("a face whose corners are out but whose middle is in is pushed out too, and size changes nothing") {
    for (const double size : {1.0, 1e-5, 1e6}) {
        const Body body(shapes::moved(shapes::icosphere(4), Eigen::Affine3d(Scaling(size))), 3.5 * size);
        TriangleMesh one{lissom::Points(3, 3), lissom::Triangles(1, 3)};
        one.points << 1.05, 0, 0.8, -0.525, 0.91, 0.8, -0.525, -0.91, 0.8;
        one.points *= size;
        one.triangles << 0, 1, 2;
        const std::array<const Body*, 1> bodies{&body};
        const lissom::PushedOut pushed = lissom::push_out(one, bodies, 0.01 * size);
        CHECK(pushed.before.vertices == 0);
        CHECK(pushed.before.face_centres == 1);
        CHECK(pushed.after.none());
        CHECK(one.points.col(2).minCoeff() > 0.99 * size);
    }
}
