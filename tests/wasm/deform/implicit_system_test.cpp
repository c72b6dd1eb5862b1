#include "lissom/deform/implicit_system.h"

#include "handles.h"

#include <doctest/doctest.h>

using namespace handles;
using namespace lissom;

namespace {

Points displacements(const Affine3d& map, const Points& points) { return images(map, points) - points; }

/// u of every slot when all handles, and with them everything, move by one map.
Points moved_slots(const Held& held, const ImplicitSystem& system, const Affine3d& map) {
    Points rest(held.region.slots(), 3);
    for (int s = 0; s < held.region.slots(); ++s) rest.row(s) = system.gradients.rest.row(held.region.vertex_of_slot[s]);
    return displacements(map, rest);
}

} // namespace

TEST_CASE("the least energy of handles that move by one affine map is everything moved by it") {
    const Affine3d map = some_affine();
    for (const Named& model : models())
        for (const int ring : {1, 2}) {
            CAPTURE(model.name);
            const Held held(model.mesh, two_ends(model.mesh.points));
            const ImplicitSystem system = implicit_system(held.region, held.laplacian, held.areas, ring);
            const Points u = Held::solved(system.equations.A, -(system.equations.G * held.parameters({map, map})));
            CHECK(gap(u, moved_slots(held, system, map).topRows(held.region.unknowns)) < 1e-6);
        }
}

TEST_CASE("the gradient of a slot is read from displacements, a region handle's from its map") {
    const Affine3d map = some_affine();
    const Named model = models().front();
    const Held held(model.mesh, two_ends(model.mesh.points));
    const ImplicitSystem system = implicit_system(held.region, held.laplacian, held.areas, 1);
    const Points u = moved_slots(held, system, map);
    int own = 0;
    for (int s = 0; s < held.region.slots(); ++s) {
        const int v = held.region.vertex_of_slot[s];
        CHECK(system.gradient_handle[s] == (held.region.role[v] == Role::region ? held.region.handle[v] : -1));
        if (system.gradient_handle[s] >= 0) continue;
        ++own;
        Eigen::Matrix3d M = Eigen::Matrix3d::Identity();
        for (int e = system.offsets[s]; e < system.offsets[s + 1]; ++e) M += u.row(system.slots[e]).transpose() * system.coefficients.row(e);
        CHECK((M - map.linear()).norm() < 1e-7);
    }
    CHECK(own == held.region.unknowns);
}

TEST_CASE("slots that were displaced are named with how far") {
    const TriangleMesh flat = shapes::bar();
    const Held held(flat, two_ends(flat.points));
    const ImplicitSystem system = implicit_system(held.region, held.laplacian, held.areas, 1);
    REQUIRE(!system.displaced.empty());
    CHECK(std::is_sorted(system.displaced.begin(), system.displaced.end()));
    for (std::size_t k = 0; k < system.displaced.size(); ++k) {
        const int v = held.region.vertex_of_slot[system.displaced[k]];
        const auto by = system.displacement.row(static_cast<Eigen::Index>(k));
        CHECK(by.norm() > 0);
        CHECK((held.region.mesh.points.row(v) + by - system.gradients.rest.row(v)).norm() < 1e-15);
    }
}

TEST_CASE("the balance of the two energies does not depend on the unit of length") {
    const TriangleMesh mesh = shapes::bumpy_sphere(2);
    const Held held(mesh, two_ends(mesh.points));
    const SparseMatrix A = implicit_system(held.region, held.laplacian, held.areas, 1).equations.A;
    for (const double unit : {1e-3, 1e3}) {
        HeldRegion there = held.region;
        there.mesh.points *= unit;
        const SparseMatrix scaled = implicit_system(there, held.laplacian, unit * unit * held.areas, 1).equations.A;
        CHECK((unit * unit * scaled - A).norm() < 1e-9 * A.norm()); // energies have no unit, u has that of length
    }
}

TEST_CASE("a blended vertex is drawn nowhere by the detail it has, and by another one it is") {
    const TriangleMesh mesh = shapes::bumpy_sphere(2);
    const Held held(mesh, two_ends(mesh.points));
    const std::vector<int> blended{held.region.vertex_of_slot[3], held.region.vertex_of_slot[20]};
    const ImplicitSystem system = implicit_system(held.region, held.laplacian, held.areas, 1, blended, 0.1);
    const Points own = held.laplacian * system.gradients.rest;
    Points detail(2, 3);
    for (int b = 0; b < 2; ++b) detail.row(b) = own.row(blended[static_cast<std::size_t>(b)]);
    const auto pull = [&](const Points& d) { return Points(system.blends * Points(system.blend_scale.asDiagonal() * d - system.blend_rest)); };
    CHECK(pull(detail).norm() < 1e-12);
    detail.row(0) *= 2;
    const Points u = Held::solved(system.equations.A, pull(detail));
    CHECK(u.norm() > 0);
    // The solve lessens the energy that it was made for: the gradient of the detail's vertex follows the pull.
    CHECK(u.cwiseProduct(pull(detail)).sum() > 0);
}
