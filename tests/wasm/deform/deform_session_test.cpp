// Properties that hold exactly, whatever the mesh: common maps, rest, numbering, and indifference to units and origin.

#include "lissom/deform/deform_session.h"

#include "handles.h"
#include "lissom/mesh/operators.h"

#include <doctest/doctest.h>

using namespace handles;

TEST_CASE("handles moved by one affine map take the whole mesh with them") {
    const Affine3d map = some_affine();
    for (const Named& model : models())
        for (const int ring : {1, 2}) {
            CAPTURE(model.name);
            CAPTURE(ring);
            const Points moved = deform(model.mesh, two_ends(model.mesh.points), {map, map}, {.remove_shear = false, .coherence_ring = ring}).positions;
            CHECK(gap(moved, images(map, model.mesh.points)) < 1e-6 * lissom::diagonal(model.mesh.points));
        }
}

TEST_CASE("handles moved by one similarity take the whole mesh with them, shear removed and details scaled") {
    const Affine3d map = some_similarity();
    for (const Named& model : models())
        for (const auto method : {lissom::DeformMethod::implicit, lissom::DeformMethod::iterative}) {
            CAPTURE(model.name);
            const Points moved = deform(model.mesh, two_ends(model.mesh.points), {map, map},
                                        {.method = method, .scale_details = true, .iterations = 3}).positions;
            CHECK(gap(moved, images(map, model.mesh.points)) < 1e-6 * lissom::diagonal(model.mesh.points));
        }
}

TEST_CASE("handles moved by one rigid motion take the whole mesh with them, details unscaled") {
    const Affine3d map = Eigen::Translation3d(1, 2, 3) * turn(150, {0, 1, 1});
    for (const Named& model : models()) {
        CAPTURE(model.name);
        const Points moved = deform(model.mesh, two_ends(model.mesh.points), {map, map}).positions;
        CHECK(gap(moved, images(map, model.mesh.points)) < 1e-6 * lissom::diagonal(model.mesh.points));
    }
}

TEST_CASE("resting handles leave every bit of the mesh alone") {
    const Affine3d rest = Affine3d::Identity();
    for (const Named& model : models())
        for (const auto method : {lissom::DeformMethod::implicit, lissom::DeformMethod::iterative, lissom::DeformMethod::naive})
            for (const bool shear : {false, true}) {
                CAPTURE(model.name);
                const Points moved = deform(model.mesh, two_ends(model.mesh.points), {rest, rest}, {.method = method, .remove_shear = !shear}).positions;
                CHECK(moved == model.mesh.points);
            }
}

TEST_CASE("re-indexing the vertices permutes the result and changes nothing else") {
    const Affine3d rest = Affine3d::Identity(), pull = Eigen::Translation3d(0.3, 0.2, 0.1) * turn(60, {1, 0, 1});
    for (const Named& model : models()) {
        CAPTURE(model.name);
        const auto place = shapes::permutation(model.mesh.vertex_count(), 5);
        const auto ends = two_ends(model.mesh.points);
        auto renamed = ends;
        for (DeformHandle& handle : renamed)
            for (int& v : handle.vertices) v = place[v];
        const Points plain = deform(model.mesh, ends, {rest, pull}).positions;
        const Points other = deform(shapes::permuted(model.mesh, place), renamed, {rest, pull}).positions;
        Points back(plain.rows(), 3);
        for (int v = 0; v < back.rows(); ++v) back.row(v) = other.row(place[v]);
        CHECK(gap(plain, back) < 1e-6 * lissom::diagonal(model.mesh.points));
    }
}

TEST_CASE("neither the unit of length nor the origin matters") {
    const Affine3d rest = Affine3d::Identity(), pull = Eigen::Translation3d(0.3, 0.2, 0.1) * turn(60, {1, 0, 1});
    const Affine3d worlds[] = {Affine3d(Eigen::Scaling(100.0)), Affine3d(Eigen::Scaling(1e-6)),
                               Affine3d(Eigen::Translation3d(1e8, -1e8, 1e8))};
    for (const Named& model : models())
        for (const Affine3d& world : worlds) {
            CAPTURE(model.name);
            CAPTURE(world.matrix());
            const auto ends = two_ends(model.mesh.points);
            const Points plain = deform(model.mesh, ends, {rest, pull}).positions;
            const TriangleMesh there = shapes::moved(model.mesh, world);
            const Points moved = deform(there, ends, {rest, world * pull * world.inverse()}).positions;
            // At 1e8 an input digit is worth 1.5e-8; a ring's gradient may enlarge that a few hundred times.
            const double tolerance = world.translation().norm() > 0 ? 1e-4 : 1e-7;
            CHECK(gap(images(world.inverse(), moved), plain) < tolerance * lissom::diagonal(model.mesh.points));
        }
}

TEST_CASE("handle vertices end exactly where their map sends them") {
    const Affine3d pull = some_affine();
    for (const Named& model : models()) {
        CAPTURE(model.name);
        auto ends = two_ends(model.mesh.points);
        const Points moved = deform(model.mesh, ends, {Affine3d::Identity(), pull}).positions;
        for (const int v : ends[0].vertices) CHECK(moved.row(v) == model.mesh.points.row(v));
        for (const int v : ends[1].vertices) CHECK(moved.row(v).transpose() == pull * Vector3d(model.mesh.points.row(v)));
    }
}

TEST_CASE("a session gives the same answer whatever was asked before, and however its factoring was sliced") {
    const TriangleMesh mesh = shapes::bumpy_sphere(3);
    const auto ends = two_ends(mesh.points);
    const lissom::WorkingMesh working = shapes::working(mesh);
    DeformSession session(working, everything(mesh.points), ends);
    CHECK(session.fraction() == 0);
    factor(session);
    CHECK(session.fraction() == 1);
    const std::vector<Affine3d> first{Affine3d::Identity(), turn(90, {1, 0, 0})}, second{some_affine(), some_similarity()};
    const Points before = session.deform(first).positions;
    (void)session.deform(second);
    CHECK(session.deform(first).positions == before);
}
