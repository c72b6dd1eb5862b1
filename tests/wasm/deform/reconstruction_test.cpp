#include "lissom/deform/reconstruction.h"

#include "handles.h"

#include <doctest/doctest.h>

using namespace handles;
using namespace lissom;

TEST_CASE("details turned and scaled by one similarity, and handles moved by it, give the surface moved by it") {
    const Affine3d map = some_similarity();
    for (const Named& model : models()) {
        CAPTURE(model.name);
        const Held held(model.mesh, two_ends(model.mesh.points));
        const HeldRegion& region = held.region;
        const Reconstruction second = reconstruction(region, held.laplacian, held.areas);
        const Points turned = second.delta * (map.linear() - Eigen::Matrix3d::Identity()).transpose();
        const Points right = second.T * turned - Points(second.equations.G * held.parameters({map, map}));
        const Points u = Held::solved(second.equations.A, right);
        for (int s = 0; s < region.unknowns; ++s) {
            const Vector3d v = region.mesh.points.row(region.vertex_of_slot[s]);
            CHECK((u.row(s).transpose() - (map * v - v)).norm() < 1e-6);
        }
    }
}

TEST_CASE("the detail of a slot is the Laplacian of its vertex") {
    const TriangleMesh mesh = shapes::bumpy_sphere(2);
    const Held held(mesh, two_ends(mesh.points));
    const Reconstruction second = reconstruction(held.region, held.laplacian, held.areas);
    const Points delta = held.laplacian * held.region.mesh.points;
    REQUIRE(second.delta.rows() == held.region.slots());
    for (int s = 0; s < held.region.slots(); ++s) CHECK(second.delta.row(s) == delta.row(held.region.vertex_of_slot[s]));
}

TEST_CASE("the unit of length does not matter: displacements grow with the mesh") {
    const TriangleMesh mesh = shapes::bumpy_sphere(2);
    const Held held(mesh, two_ends(mesh.points));
    const Affine3d pull = Eigen::Translation3d(0.1, 0.2, 0) * turn(40, {1, 0, 1});
    const auto solve = [&](double unit) {
        HeldRegion there = held.region;
        there.mesh.points *= unit;
        const Reconstruction second = reconstruction(there, held.laplacian, unit * unit * held.areas);
        const Affine3d scaled = Eigen::Scaling(unit) * pull * Eigen::Scaling(1 / unit);
        return Points(Held::solved(second.equations.A, -(second.equations.G * held.parameters({Affine3d::Identity(), scaled}))) / unit);
    };
    const Points here = solve(1);
    for (const double unit : {1e-3, 1e3}) CHECK(gap(solve(unit), here) < 1e-8);
}
