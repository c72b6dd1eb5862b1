// Affine equivariance to 1e-6 of the diagonal, also where edges are ten thousand times shorter than the mean beside needles.

#include "handles.h"

#include "lissom/deform/deform_session.h"
#include "lissom/mesh/operators.h"

#include <doctest/doctest.h>

#include <cmath>
#include <string>

using namespace lissom;
using namespace handles;

namespace {

/// Some triangles get a vertex 1e-4 of the mean edge from a corner: an edge as short, and two needles beside it.
TriangleMesh with_short_edges(TriangleMesh mesh, int count) {
    const double short_edge = 1e-4 * mean_edge_length(mesh);
    const int n = mesh.vertex_count(), m = mesh.triangle_count();
    mesh.points.conservativeResize(n + count, 3);
    mesh.triangles.conservativeResize(m + 2 * count, 3);
    for (int k = 0; k < count; ++k) {
        const int t = static_cast<int>(static_cast<long long>(k) * m / count), v = n + k;
        const int a = mesh.triangles(t, 0), b = mesh.triangles(t, 1), c = mesh.triangles(t, 2);
        const Eigen::RowVector3d inward = (0.5 * (mesh.points.row(b) + mesh.points.row(c)) - mesh.points.row(a)).normalized();
        mesh.points.row(v) = mesh.points.row(a) + short_edge * inward;
        mesh.triangles.row(t) << a, b, v;
        mesh.triangles.row(m + 2 * k) << b, c, v;
        mesh.triangles.row(m + 2 * k + 1) << c, a, v;
    }
    return mesh;
}

/// Four maps without a reflection, by formula.
Affine3d affine(int seed, double size) {
    Affine3d map = Affine3d::Identity();
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 4; ++j) map.matrix()(i, j) = (i == j ? 1.6 : 0) + 0.5 * std::sin(7.0 * seed + 3 * i + 11 * j) * (j == 3 ? size : 1);
    return map;
}
Affine3d similarity(int seed, double size) {
    return Eigen::Translation3d(affine(seed, size).translation()) * turn(100 * std::sin(seed + 1.0), {1, std::cos(seed), 0.4}) * Eigen::Scaling(1.3 + 0.4 * std::sin(seed));
}

struct Exactness {
    double affine = 0, similarity = 0; ///< largest distance, in diagonals
    bool corrects = false;
};

Exactness exactness(const TriangleMesh& mesh) {
    Exactness found;
    const WorkingMesh working = shapes::working(mesh);
    const double size = diagonal(mesh.points);
    const std::vector<DeformHandle> ends = two_ends(mesh.points, 0.08);
    for (const bool remove_shear : {false, true}) {
        DeformSession session(working, everything(mesh.points), ends, {.remove_shear = remove_shear, .scale_details = true});
        factor(session);
        found.corrects = found.corrects || session.corrects();
        for (int seed = 0; seed < 4; ++seed) {
            const Affine3d map = remove_shear ? similarity(seed, size) : affine(seed, size);
            const std::vector<Affine3d> targets(ends.size(), map);
            const DeformResult result = session.deform(targets);
            CHECK(result.positions == session.deform(targets).positions);
            double& worst = remove_shear ? found.similarity : found.affine;
            worst = std::max(worst, gap(result.positions, images(map, mesh.points)) / size);
        }
    }
    return found;
}

} // namespace

TEST_CASE("edges of 1e-4 of the mean beside needles cost no digits, whatever the unit") {
    for (const double unit : {1e-3, 1.0, 1e3}) {
        TriangleMesh mesh = with_short_edges(shapes::bumpy_sphere(4), 40);
        mesh.points *= unit;
        const Exactness found = exactness(mesh);
        MESSAGE("affine " << found.affine << ", similarity " << found.similarity << " of the diagonal");
        CHECK(found.corrects);
        CHECK(found.affine < 1e-6);
        CHECK(found.similarity < 1e-6);
    }
}

TEST_CASE("where the numbers suffice nothing is corrected") {
    for (const TriangleMesh& mesh : {shapes::bumpy_sphere(3), shapes::torus(), shapes::bar()}) {
        const Exactness found = exactness(mesh);
        CHECK_FALSE(found.corrects);
        CHECK(found.affine < 1e-6);
        CHECK(found.similarity < 1e-6);
    }
}

TEST_CASE("real models come out exact too") {
    for (const std::string name : {"human/body_female.ply", "human/body_male.ply", "pairs/body_male_walk_remesh.ply", "registry/anny_notoes.ply", "generated/out/degenerate.ply"}) {
        const TriangleMesh mesh = shared_model(name);
        if (mesh.vertex_count() == 0) {
            MESSAGE("skipped: there is no shared/data/" << name << " here");
            continue;
        }
        CAPTURE(name);
        const Exactness found = exactness(mesh);
        MESSAGE(name << ": affine " << found.affine << ", similarity " << found.similarity << " of the diagonal" << std::string(found.corrects ? ", corrected" : ""));
        CHECK(found.affine < 1e-6);
        CHECK(found.similarity < 1e-6);
    }
}
