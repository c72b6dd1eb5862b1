// Broken inputs: none may end in anything but a finite, sensible edit, with the user's vertices in their order.

#include "handles.h"

#include "lissom/mesh/operators.h"
#include "lissom/mesh/topology.h"

#include <doctest/doctest.h>

#include <algorithm>

using namespace handles;

namespace {

/// The edit used here bends by 60 degrees: no vertex may go farther than its handles do.
const Affine3d k_pull = Eigen::Translation3d(0.3, 0.1, 0.2) * turn(60, {0, 1, 1});

void check_sensible(const TriangleMesh& mesh, const std::vector<DeformHandle>& ends, const DeformOptions& options) {
    const Points moved = deform(mesh, ends, {Affine3d::Identity(), k_pull}, options).positions;
    REQUIRE(moved.rows() == mesh.points.rows());
    double farthest = 0, allowed = 0;
    for (int v = 0; v < moved.rows(); ++v) {
        if (!mesh.points.row(v).allFinite()) continue;
        REQUIRE(moved.row(v).allFinite());
        farthest = std::max(farthest, (moved.row(v) - mesh.points.row(v)).norm());
        allowed = std::max(allowed, (k_pull * Vector3d(mesh.points.row(v)) - Vector3d(mesh.points.row(v))).norm());
    }
    CHECK(farthest < 1.3 * allowed);
    for (const int v : ends[1].vertices)
        if (mesh.points.row(v).allFinite()) CHECK((moved.row(v).transpose() - k_pull * Vector3d(mesh.points.row(v))).norm() < 1e-9);
}

/// Per vertex of the file: it is a handle's, or joined by faces to one that is.
std::vector<bool> held_vertices(const lissom::WorkingMesh& working, const std::vector<DeformHandle>& handles) {
    const lissom::Components pieces = lissom::components(lissom::vertex_rings(working.mesh));
    std::vector<bool> has_handle(static_cast<std::size_t>(pieces.count), false), held(working.working_of_source.size(), false);
    for (const DeformHandle& handle : handles)
        for (const int v : handle.vertices) {
            held[static_cast<std::size_t>(v)] = true;
            if (const int w = working.working_of_source[v]; w >= 0) has_handle[static_cast<std::size_t>(pieces.of_vertex[w])] = true;
        }
    for (std::size_t v = 0; v < held.size(); ++v)
        if (const int w = working.working_of_source[v]; w >= 0 && has_handle[static_cast<std::size_t>(pieces.of_vertex[w])]) held[v] = true;
    return held;
}

} // namespace

TEST_CASE("the eight inputs that defeat other libraries end in a finite, sensible edit") {
    for (const TriangleMesh& sound : {shapes::bumpy_sphere(3), shapes::box(4, 20, 4, {1, 5, 1}), shapes::bumpy_sheet(20, 14)})
        for (const shapes::Broken& broken : shapes::eight_broken(sound))
            for (const auto method : {lissom::DeformMethod::implicit, lissom::DeformMethod::iterative, lissom::DeformMethod::naive}) {
                CAPTURE(std::string(broken.name));
                CAPTURE(sound.vertex_count());
                check_sensible(broken.mesh, two_ends(broken.mesh.points), {.method = method, .iterations = 3});
            }
}

TEST_CASE("other awkward inputs are carried too") {
    const TriangleMesh sphere = shapes::bumpy_sphere(2);
    const std::vector<Named> awkward = {{"Moebius strip", shapes::moebius()}, {"Klein bottle", shapes::klein_bottle()},
                                        {"three sheets on a line", shapes::three_sheets()}, {"bow tie", shapes::bow_tie()},
                                        {"flat sheet", shapes::sheet(12, 9)}, {"doubled faces", shapes::with_duplicate_faces(sphere)},
                                        {"mixed orientation", shapes::with_mixed_orientation(sphere)},
                                        {"a vertex that is not a number", shapes::with_nan_vertex(sphere)},
                                        {"inside out", shapes::turned_inside_out(sphere)}, {"coarse box", shapes::box(1, 3, 1)}};
    for (const Named& model : awkward) {
        CAPTURE(std::string(model.name));
        check_sensible(model.mesh, two_ends(model.mesh.points), {});
        check_sensible(model.mesh, two_ends(model.mesh.points), {.coherence_ring = 2});
    }
}

TEST_CASE("common affine and rigid maps are followed exactly on broken meshes as well") {
    const Affine3d affine = some_affine(), rigid = turn(100, {1, 1, 0});
    const TriangleMesh sound = shapes::bumpy_sphere(3);
    for (const shapes::Broken& broken : shapes::eight_broken(sound)) {
        CAPTURE(std::string(broken.name));
        const auto ends = two_ends(broken.mesh.points);
        const lissom::WorkingMesh working = shapes::working(broken.mesh);
        const std::vector<bool> held = held_vertices(working, ends);
        CHECK(std::count(held.begin(), held.end(), true) >= sound.vertex_count());
        for (const bool shear : {false, true}) {
            const Affine3d& map = shear ? affine : rigid;
            DeformSession session(working, everything(broken.mesh.points), ends, {.remove_shear = !shear});
            factor(session);
            const Points moved = session.deform(std::vector{map, map}).positions, expected = images(map, broken.mesh.points);
            for (int v = 0; v < moved.rows(); ++v) {
                if (held[static_cast<std::size_t>(v)]) CHECK((moved.row(v) - expected.row(v)).norm() < 1e-6 * lissom::diagonal(broken.mesh.points));
                else CHECK(moved.row(v) == broken.mesh.points.row(v));
            }
        }
    }
}

TEST_CASE("one triangle, two triangles and a fan can be bent") {
    TriangleMesh one;
    one.points.resize(3, 3);
    one.points << 0, 0, 0, 1, 0, 0, 0, 1, 0;
    one.triangles.resize(1, 3);
    one.triangles << 0, 1, 2;
    const std::vector<DeformHandle> corner{{.is_point = false, .vertices = {0}}};
    const Affine3d map = some_affine();
    CHECK(gap(deform(one, corner, {map}, {.remove_shear = false}).positions, images(map, one.points)) < 1e-9);
    const Affine3d rigid = turn(120, {1, 2, 3});
    CHECK(gap(deform(one, corner, {rigid}).positions, images(rigid, one.points)) < 1e-9);
    const std::vector<DeformHandle> pin{{.is_point = true, .vertices = {0}}};
    const Affine3d move(Eigen::Translation3d(1, 2, 3));
    CHECK(gap(deform(one, pin, {move}).positions, images(move, one.points)) < 1e-9);

    const TriangleMesh pair = shapes::sheet(1, 1);
    CHECK(gap(deform(pair, corner, {map}, {.remove_shear = false}).positions, images(map, pair.points)) < 1e-9);
}
