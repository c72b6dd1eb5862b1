#include "lissom/wear/body_map.h"

#include "refusal.h"
#include "shapes.h"

#include <doctest/doctest.h>

#include <limits>
#include <vector>

using Eigen::Affine3d;
using Eigen::AngleAxisd;
using Eigen::Vector3d;
using lissom::Points;
using lissom::BodyMap;
using lissom::TriangleMesh;

namespace {

BodyMap between(const TriangleMesh& from, const Points& to) {
    BodyMap made(from.triangles, from.points, to);
    while (made.step()) {
    }
    return made;
}

/// A body that gets thicker and bends.
Points thicker(const TriangleMesh& mesh) {
    Points moved = mesh.points;
    for (Eigen::Index v = 0; v < moved.rows(); ++v) {
        moved.row(v) *= 1.1 + 0.1 * moved(v, 1);
        moved(v, 0) += 0.1 * moved(v, 1) * moved(v, 1);
    }
    return moved;
}

Points applied(const Affine3d& map, const Points& points) { return (points * map.linear().transpose()).rowwise() + map.translation().transpose(); }

const std::vector<Vector3d>& places() {
    static const std::vector<Vector3d> list{{1.02, 0.1, 0}, {0, 0.97, 0.3}, {0.2, -0.9, -0.6}, {1.5, 0.5, 0.5}, {-0.2, 2.5, 1}};
    return list;
}

} // namespace

TEST_CASE("onto the same skin nothing moves; onto one that is moved and turned all goes along") {
    const TriangleMesh ball = shapes::bumpy_sphere(3);
    const Affine3d map(Eigen::Translation3d(3, -1, 20) * AngleAxisd(2.2, Vector3d(1, 1, 0).normalized()) * Eigen::Scaling(1.2));
    const BodyMap same = between(ball, ball.points), moved = between(ball, applied(map, ball.points));
    for (const Vector3d& p : places()) {
        CHECK((same.carry(p).place - p).norm() < 1e-6);
        CHECK(same.carry(p).away.dot(p.normalized()) > 0.5);
    }
    // Far out the map of space decides; near the skin distances are kept while the body is a fifth larger.
    CHECK((moved.carry(places()[4]).place - map * places()[4]).norm() < 1e-6);
    const Vector3d on = ball.points.row(7), near = 1.001 * on;
    CHECK((moved.carry(on).place - map * on).norm() < 1e-6);
    CHECK((moved.carry(near).place - map * on).norm() == doctest::Approx((near - on).norm()).epsilon(0.2));
}

TEST_CASE("moved, turned and in another unit places are carried alike") {
    const TriangleMesh ball = shapes::bumpy_sphere(3);
    const Points to = thicker(ball);
    const BodyMap plain = between(ball, to);
    for (const double size : {1e-4, 1e5}) {
        const Affine3d map(Eigen::Translation3d(size * 30, 0, -size) * AngleAxisd(1.2, Vector3d(1, 5, 0).normalized()) * Eigen::Scaling(size));
        const BodyMap there = between(shapes::moved(ball, map), applied(map, to));
        for (const Vector3d& p : places()) {
            CHECK((there.carry(map * p).place - map * plain.carry(p).place).norm() < 1e-6 * size);
            CHECK((there.carry(map * p).away - map.linear() / size * plain.carry(p).away).norm() < 1e-5);
        }
    }
}

TEST_CASE("a place keeps to the skin that it was near, whatever the triangles") {
    const TriangleMesh coarse = shapes::icosphere(4), fine = shapes::icosphere(5);
    const BodyMap a = between(coarse, thicker(coarse)), b = between(fine, thicker(fine));
    for (const Vector3d& p : places()) CHECK((a.carry(p).place - b.carry(p).place).norm() < 0.01);
    // Near the skin it lies as far outside as it did.
    const lissom::TriangleTree tree(b.to());
    const Vector3d p = 1.02 * Vector3d(0.3, 0.2, 0.9).normalized();
    CHECK(tree.nearest(b.carry(p).place).distance == doctest::Approx(0.02).epsilon(0.1));
}

TEST_CASE("skins that do not fit or have no volume are refused") {
    const TriangleMesh ball = shapes::icosphere(1), sheet = shapes::sheet(8, 8);
    CHECK(refusal([&] { BodyMap(ball.triangles, ball.points, sheet.points); }) == "wrong-size");
    CHECK(refusal([&] { BodyMap(ball.triangles, ball.points.topRows(9), ball.points.topRows(9)); }) == "vertex-out-of-range");
    CHECK(refusal([&] { BodyMap(ball.triangles, 0 * ball.points, ball.points); }) == "flat-skin");
    CHECK(refusal([&] { between(sheet, sheet.points); }) == "flat-skin");
    Points torn = ball.points;
    torn(3, 1) = std::numeric_limits<double>::infinity();
    CHECK(refusal([&] { BodyMap(ball.triangles, ball.points, torn); }) == "non-finite-position");
}
