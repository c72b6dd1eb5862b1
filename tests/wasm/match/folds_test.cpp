#include "lissom/match/folds.h"

#include "shapes.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace lissom;
using Eigen::RowVector3d;

namespace {

std::vector<char> none(const TriangleMesh& mesh) { return std::vector<char>(static_cast<std::size_t>(mesh.vertex_count()), 0); }
int crossings(const TriangleMesh& mesh) { return static_cast<int>(self_intersections(mesh).triangles.size()); }

/// A ball with a dent pushed through its far side.
TriangleMesh pierced() {
    TriangleMesh mesh = shapes::icosphere(4);
    for (int v = 0; v < mesh.vertex_count(); ++v)
        if (mesh.points(v, 2) > 0.93) mesh.points(v, 2) -= 2.1 * std::min(1.0, (mesh.points(v, 2) - 0.93) / 0.04);
    return mesh;
}

} // namespace

TEST_CASE("folds are counted by the angle of their triangles") {
    TriangleMesh roof{Points(4, 3), Triangles(2, 3)};
    roof.triangles << 0, 1, 2, 1, 0, 3;
    for (const double degrees : {0.0, 60.0, 95.0, 150.0, 179.0}) {
        const double a = degrees * M_PI / 180;
        roof.points << 0, 0, 0, 1, 0, 0, 0.5, 1, 0, 0.5, -std::cos(a), -std::sin(a);
        const TrianglePairs pairs = neighbouring_triangles(roof);
        REQUIRE(pairs.size() == 1);
        CHECK(count_folds(roof, pairs) == (degrees > 102));
        CHECK(count_folds(roof, pairs, k_sharp_fold) == (degrees > 135));
    }
    CHECK(neighbouring_triangles(shapes::icosphere(1)).size() == 120);
    CHECK(neighbouring_triangles(shapes::with_fin(shapes::icosphere(1))).size() == 119); // the fin's edge has three
    CHECK(neighbouring_triangles(shapes::with_flipped_face(shapes::icosphere(1))).size() == 117);
}

TEST_CASE("what is tangled is untangled, and no more is moved than that takes") {
    TriangleMesh mesh = pierced();
    REQUIRE(crossings(mesh) > 10);
    const TriangleMesh before = mesh;
    std::vector<char> locked = none(mesh);
    int bottom = 0;
    mesh.points.col(2).minCoeff(&bottom);
    const Tangle left = untangle(mesh, locked);
    CHECK(left.triangles.empty());
    CHECK(crossings(mesh) == 0);
    CHECK(count_folds(mesh, neighbouring_triangles(mesh), k_sharp_fold) == 0);
    CHECK(mesh.points.allFinite());
    TriangleMesh clean = shapes::bumpy_sphere();
    (void)untangle(clean, none(clean));
    CHECK(clean.points == shapes::bumpy_sphere().points);
    TriangleMesh held = before;
    locked[10] = 1;
    (void)untangle(held, locked);
    CHECK(held.points.row(10) == before.points.row(10));
}

TEST_CASE("a guarded step goes as far as it may: a clean surface stays clean whatever it is asked") {
    for (const double strength : {0.05, 0.5, 2.0}) {
        CAPTURE(strength);
        TriangleMesh mesh = shapes::bumpy_sphere(4);
        GuardedStep guard(mesh);
        for (int k = 0; k < 3; ++k) {
            Points moves(mesh.vertex_count(), 3);
            for (int v = 0; v < mesh.vertex_count(); ++v) // waves through the middle
                moves.row(v) = -strength * mesh.points.row(v) * std::max(0.0, std::sin(4 * mesh.points(v, 0) + k) * std::cos(5 * mesh.points(v, 1)));
            const TriangleMesh before = mesh;
            const GuardedStep::Taken taken = guard.take(mesh, moves);
            CHECK(taken.crossings == 0);
            CHECK(crossings(mesh) == 0);
            CHECK(count_folds(mesh, neighbouring_triangles(mesh), k_sharp_fold) == 0);
            CHECK((taken.refused || (mesh.points - before.points).norm() > 0));
            if (strength > 1) CHECK((taken.shortened > 0 || taken.refused));
        }
    }
}

TEST_CASE("a step that does no harm is taken whole; of one that does only what is around it is shortened") {
    TriangleMesh mesh = shapes::bumpy_sphere(4);
    const TriangleMesh before = mesh;
    GuardedStep guard(mesh);
    Points moves = Points::Constant(mesh.vertex_count(), 3, 0.3);
    CHECK(guard.take(mesh, moves).shortened == 0);
    CHECK((mesh.points - before.points - moves).norm() < 1e-12);
    moves.setZero();
    int top = 0;
    mesh.points.col(2).maxCoeff(&top);
    moves.row(top) << 0, 0, -3; // through everything
    moves.row((top + 57) % mesh.vertex_count()) << 1e-4, 0, 0;
    const Points from = mesh.points;
    const GuardedStep::Taken taken = guard.take(mesh, moves);
    CHECK(taken.crossings == 0);
    CHECK_FALSE(taken.refused);
    CHECK(taken.shortened > 0);
    CHECK((mesh.points - from).row((top + 57) % mesh.vertex_count()).norm() == doctest::Approx(1e-4));
}

TEST_CASE("a surface that was tangled may be moved, and is not tangled further") {
    TriangleMesh mesh = pierced();
    const int before = crossings(mesh);
    GuardedStep guard(mesh);
    Points moves = Points::Zero(mesh.vertex_count(), 3);
    for (int v = 0; v < mesh.vertex_count(); ++v) moves.row(v) = 0.05 * RowVector3d(std::sin(3 * mesh.points(v, 1)), 0, 0.2);
    (void)guard.take(mesh, moves);
    CHECK(crossings(mesh) <= 1.3 * before);
    CHECK(mesh.points.allFinite());
}
