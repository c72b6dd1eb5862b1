#include "lissom/isoline/reduced_solver.h"

#include "sessions.h"

#include <doctest/doctest.h>

#include <numbers>

using namespace lissom;
using namespace sessions;
using Eigen::Affine3d;

namespace {

struct Solved {
    Fielded f;
    std::vector<HandleEnd> ends;
    std::optional<ReducedSolver> solver;
    ControlSets sets;

    Solved(const TriangleMesh& mesh, int handles, ReducedSolver::Options options = {}, bool isolines = false, int patches = 60)
        : f(mesh, axis_caps(mesh.points, handles)), ends(static_cast<std::size_t>(handles)), sets{FieldBasis(BasisKind::quadratic, 10), handles} {
        Carriers carriers = isolines ? isoline_carriers(f.mesh, f.fields, sets, ends, 600) : patch_carriers(f.mesh, f.fields, f.handle, ends, {.count = patches});
        ReducedEnergy energy = reduced_energy(f.mesh, f.laplacian, f.areas, f.fields, sets, carriers.details, ends, 0.03);
        solver.emplace(f.mesh, f.laplacian, f.areas, f.fields, sets, std::move(carriers), std::move(energy), ends, options);
    }
    Solved(const Solved&) = delete;

    [[nodiscard]] Points positions() const {
        Points moved = f.mesh.points;
        std::vector<ControlSets::Entry> entries;
        for (int v = 0; v < f.mesh.vertex_count(); ++v) {
            sets.entries_at({f.fields.data() + v * f.fields.cols(), static_cast<std::size_t>(f.fields.cols())}, entries);
            moved.row(v) = blended(f.mesh.points.row(v), entries, solver->controls()).transpose();
        }
        return moved;
    }
};

Affine3d turned(double degrees) { return handles::turn(degrees, {0.3, 1, 0.2}, {0.1, 0, 0}); }

} // namespace

TEST_CASE("rotation vectors and rotations are each other's inverse") {
    for (const double angle : {0.0, 1e-9, 0.5, 3.1}) {
        const Eigen::Vector3d v = angle * Eigen::Vector3d(1, 2, -2) / 3;
        CHECK((rotation_vector(rotation_of(v)) - v).norm() < 1e-9);
    }
}

TEST_CASE("a common rigid motion is found by the first solve, in every mode") {
    const Affine3d map = turned(130) * Eigen::Translation3d(0.4, -1, 0.2);
    for (const bool isolines : {false, true}) {
        Solved s(shapes::bumpy_sphere(3), 3, {}, isolines);
        const ReducedStep step = s.solver->frame({std::vector<Affine3d>(3, map)}, 1);
        CHECK(step.solves == 1);
        CHECK(handles::gap(s.positions(), handles::images(map, s.f.mesh.points)) < 1e-9);
    }
    Solved positions(shapes::bumpy_sphere(3), 3, {.positions_only = true});
    (void)positions.solver->frame({std::vector<Affine3d>(3, map)}, 3);
    CHECK(handles::gap(positions.positions(), handles::images(map, positions.f.mesh.points)) < 1e-9);
}

TEST_CASE("handles at rest move nothing, to the last bit") {
    Solved s(shapes::bumpy_sphere(3), 3);
    (void)s.solver->frame({std::vector<Affine3d>(3, Affine3d::Identity())}, 5);
    CHECK(s.solver->controls().cwiseAbs().maxCoeff() == 0);
}

TEST_CASE("acceleration ends where the plain iteration does, sooner") {
    const std::vector<Affine3d> targets{Affine3d::Identity(), turned(100)};
    Solved fast(shapes::bumpy_sphere(3), 2, {.tolerance = 1e-7}), plain(shapes::bumpy_sphere(3), 2, {.memory = 0, .tolerance = 1e-7});
    const int quick = fast.solver->frame({targets}, 400).solves, slow = plain.solver->frame({targets}, 400).solves;
    CHECK(quick < 0.7 * slow);
    CHECK(handles::gap(fast.positions(), plain.positions()) < 2e-5);
}

TEST_CASE("a drag in small steps ends where the same target from rest does, and returns to rest") {
    Solved dragged(shapes::bumpy_sphere(3), 2, {.tolerance = 1e-7}), once(shapes::bumpy_sphere(3), 2, {.tolerance = 1e-7});
    for (int k = 1; k <= 20; ++k) (void)dragged.solver->frame({{Affine3d::Identity(), turned(6.0 * k)}}, 8);
    (void)dragged.solver->frame({{Affine3d::Identity(), turned(120)}}, 200);
    (void)once.solver->frame({{Affine3d::Identity(), turned(120)}}, 200);
    CHECK(handles::gap(dragged.positions(), once.positions()) < 1e-4);
    for (int k = 19; k >= 0; --k) (void)dragged.solver->frame({{Affine3d::Identity(), turned(6.0 * k)}}, 8);
    (void)dragged.solver->frame({{Affine3d::Identity(), Affine3d::Identity()}}, 200);
    CHECK(handles::gap(dragged.positions(), dragged.f.mesh.points) < 1e-5);
}

TEST_CASE("a turn that is dragged past half a turn goes on, and can be forgotten") {
    const auto spin = [](double degrees) { return handles::turn(degrees, {1, 0, 0}); };
    Solved s(shapes::box(48, 10, 10, {4, 1, 1}), 2, {}, false, 150);
    for (int k = 1; k <= 30; ++k) (void)s.solver->frame({{spin(9.0 * k), Affine3d::Identity()}}, 8);
    (void)s.solver->frame({{spin(270), Affine3d::Identity()}}, 100);
    // Half way along it has turned by half of 270 degrees, not of −90.
    const auto half_turn = [&] {
        const Points moved = s.positions();
        int v = 0;
        (s.f.mesh.points.rowwise() - Eigen::RowVector3d(0, s.f.mesh.points.col(1).maxCoeff(), 0)).rowwise().norm().minCoeff(&v);
        return std::atan2(moved(v, 2), moved(v, 1)) * 180 / std::numbers::pi;
    };
    CHECK(half_turn() == doctest::Approx(135).epsilon(0.05));
    (void)s.solver->frame({{spin(270), Affine3d::Identity()}}, 60, true);
    CHECK(half_turn() == doctest::Approx(-45).epsilon(0.1));
}

TEST_CASE("a common similarity is exact where details take the scale, and not where they do not") {
    const Affine3d map = turned(80) * Eigen::Scaling(1.8);
    Solved scaled(shapes::bumpy_sphere(3), 3, {.scale_details = true}), kept(shapes::bumpy_sphere(3), 3);
    (void)scaled.solver->frame({std::vector<Affine3d>(3, map)}, 1);
    (void)kept.solver->frame({std::vector<Affine3d>(3, map)}, 20);
    CHECK(handles::gap(scaled.positions(), handles::images(map, scaled.f.mesh.points)) < 1e-9);
    CHECK(handles::gap(kept.positions(), handles::images(map, kept.f.mesh.points)) > 1e-3);
}

TEST_CASE("flat sides and round ones alike: Eq 9 has no inverse on a bar, and still nothing breaks") {
    Solved bar(shapes::box(24, 6, 6, {4, 1, 1}), 2, {}, true);
    const ReducedStep step = bar.solver->frame({{handles::turn(90, {1, 0, 0}), Affine3d::Identity()}}, 40);
    CHECK(step.solves > 1);
    CHECK(handles::volume_ratio(bar.f.mesh, bar.positions()) > 0.9);
}
