#include "lissom/match/places.h"

#include "../refusal.h"
#include "shapes.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace lissom;
using Eigen::RowVector3d;
using Eigen::Vector3d;

namespace {

/// A body that no turn carries onto itself.
TriangleMesh pear() {
    TriangleMesh mesh = shapes::uv_sphere(24, 36);
    for (Eigen::Index i = 0; i < mesh.points.rows(); ++i) {
        const RowVector3d p = mesh.points.row(i);
        mesh.points.row(i) = RowVector3d(1.3 * p.x() * (1 + 0.3 * p.y()), 2 * p.y(), p.z() * (1 + 0.2 * p.x()));
    }
    return mesh;
}

} // namespace

TEST_CASE("a place on one skin is carried to the same place of the other, exactly where the skins are alike but for an affine map") {
    const TriangleMesh from = pear();
    Eigen::Affine3d map = Eigen::Affine3d::Identity();
    map.linear() << 1.2, 0.1, 0, -0.2, 0.9, 0.3, 0, 0.2, 1.4;
    map.translation() = Vector3d(3, -2, 5);
    const Points to = shapes::moved(from, map).points;
    Points places(40, 3), wanted(40, 3);
    for (int i = 0; i < 40; ++i) {
        const int t = 37 * i % from.triangle_count();
        places.row(i) = 0.5 * from.points.row(from.triangles(t, 0)) + 0.3 * from.points.row(from.triangles(t, 1)) + 0.2 * from.points.row(from.triangles(t, 2));
        wanted.row(i) = (map * Vector3d(places.row(i))).transpose();
    }
    CHECK((carried_places(from, to, places) - wanted).cwiseAbs().maxCoeff() < 1e-12);
}

TEST_CASE("skins that do not belong together are refused") {
    const TriangleMesh from = pear();
    CHECK(refusal([&] { (void)carried_places(from, Points::Zero(3, 3), Points::Zero(1, 3)); }) == "wrong-size");
    TriangleMesh broken = from;
    broken.triangles(0, 0) = broken.vertex_count();
    CHECK(refusal([&] { (void)carried_places(broken, from.points, Points::Zero(1, 3)); }) == "index-out-of-range");
}

TEST_CASE("a place is guessed where it is, on a moved and scaled copy, with three markers; and in place without") {
    const TriangleMesh mesh = pear();
    const Eigen::Affine3d map = Eigen::Translation3d(10, -4, 2) * Eigen::AngleAxisd(2.1, Vector3d(1, 2, -1).normalized()) * Eigen::Scaling(7.0);
    const TriangleMesh other = shapes::moved(mesh, map);
    const WorkingMesh from = shapes::working(mesh), to = shapes::working(other);
    Points marks(4, 3), partners(4, 3);
    for (int i = 0; i < 4; ++i) {
        const int v = 150 * i + 60;
        marks.row(i) = mesh.points.row(v);
        partners.row(i) = other.points.row(v);
    }
    for (const int v : {5, 77, 300, 512}) {
        const Points guess = guessed_place(from, to, marks, partners, mesh.points.row(v));
        CHECK((guess.row(0) - other.points.row(v)).norm() < 1e-9 * 7 * 4);
        // Three times as large about another place, but standing alike: no markers needed.
        const TriangleMesh alike = shapes::moved(mesh, Eigen::Affine3d(Eigen::Translation3d(3, 3, 3) * Eigen::Scaling(3.0)));
        const Points plain = guessed_place(from, shapes::working(alike), Points(0, 3), Points(0, 3), mesh.points.row(v));
        CHECK((plain.row(0) - alike.points.row(v)).norm() < 1e-9 * 3 * 4);
    }
}
