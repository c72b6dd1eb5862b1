#include "lissom/match/first_skin.h"

#include "lissom/match/distances.h"
#include "lissom/match/skin_settling.h"
#include "lissom/mesh/operators.h"
#include "lissom/mesh/topology.h"
#include "refusal.h"
#include "shapes.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace lissom;

namespace {

bool is_closed(const TriangleMesh& mesh) {
    for (const Edge& e : edges(mesh))
        if (e.forward != 1 || e.backward != 1) return false;
    return non_manifold_vertices(mesh).empty() && components(vertex_rings(mesh)).count == 1;
}

} // namespace

TEST_CASE("box and sphere are closed around the model, of even edges") {
    const TriangleMesh model = shapes::bumpy_sphere(3);
    for (const double L : {0.05, 0.1, 0.3}) {
        const TriangleMesh box = box_around(model, L), sphere = sphere_around(model, L);
        for (const TriangleMesh* mesh : {&box, &sphere}) {
            CHECK(is_closed(*mesh));
            CHECK(euler_characteristic(*mesh) == 2);
            CHECK(signed_volume(*mesh) > signed_volume(model));
            const double mean = mean_edge_length(*mesh) / L;
            CHECK(mean > 0.8);
            CHECK(mean < 1.3);
        }
        CHECK((box.points.colwise().minCoeff().array() < model.points.colwise().minCoeff().array()).all());
        CHECK((box.points.colwise().maxCoeff().array() > model.points.colwise().maxCoeff().array()).all());
        const Eigen::RowVector3d middle = (model.points.colwise().minCoeff() + model.points.colwise().maxCoeff()) / 2;
        const Eigen::VectorXd radii = (sphere.points.rowwise() - middle).rowwise().norm();
        CHECK(radii.maxCoeff() - radii.minCoeff() < 1e-12);
        CHECK(radii[0] > (model.points.rowwise() - middle).rowwise().norm().maxCoeff());
    }
}

TEST_CASE("a torus goes through the hole of the model, however that lies, and says where there is none") {
    const Eigen::Affine3d map = Eigen::Translation3d(1, 2, 3) * Eigen::AngleAxisd(1, Eigen::Vector3d(1, 2, 3).normalized()) * Eigen::Scaling(10.0);
    for (const TriangleMesh& model : {shapes::torus(), shapes::moved(shapes::torus(), map)}) {
        const double L = 0.05 * diagonal(model.points);
        const TorusAround out = torus_around(model, L);
        CHECK(out.through);
        CHECK(is_closed(out.mesh));
        CHECK(euler_characteristic(out.mesh) == 0);
        CHECK(signed_volume(out.mesh) > signed_volume(model));
        CHECK(mean_edge_length(out.mesh) > 0.7 * L);
        CHECK(mean_edge_length(out.mesh) < 1.4 * L);
        const SurfaceDistances apart = surface_distances(out.mesh, model);
        CHECK(apart.mean_there < 0.1 * diagonal(model.points));
    }
    CHECK_FALSE(torus_around(shapes::icosphere(2), 0.2).through);
}

TEST_CASE("on a convex model a box settles into its shape") {
    TriangleMesh egg = shapes::icosphere(4);
    egg.points.col(0) *= 1.5;
    TriangleMesh skin = box_around(egg, 0.12);
    const FitSurface surface(egg);
    SkinSettling settling(skin, surface, {.reach = 1});
    while (settling.step(skin)) {
    }
    const SurfaceDistances apart = surface_distances(skin, egg);
    CHECK(apart.mean_there < 0.005 * diagonal(egg.points));
    CHECK(apart.mean_back < 0.005 * diagonal(egg.points));
}

TEST_CASE("what cannot be is refused") {
    const TriangleMesh model = shapes::icosphere(2);
    CHECK(refusal([&] { (void)box_around(model, 0); }) == "bad-option");
    CHECK(refusal([&] { (void)sphere_around(model, 1e-5); }) == "bad-option");
    CHECK(refusal([&] { (void)torus_around(shapes::torus(), 1e-5); }) == "bad-option");
    CHECK(refusal([] { (void)box_around({Points::Zero(3, 3), Triangles::Zero(1, 3)}, 1); }) == "flat-model");
}
