#include "lissom/match/skin_settling.h"

#include "lissom/match/distances.h"
#include "lissom/mesh/self_intersections.h"
#include "shapes.h"

#include <doctest/doctest.h>

using namespace lissom;

namespace {

TriangleMesh settled(TriangleMesh skin, const TriangleMesh& model, const SettlingOptions& options = {}) {
    const FitSurface surface(model);
    SkinSettling settling(skin, surface, options);
    int slices = 1;
    while (settling.step(skin)) ++slices;
    CHECK(slices == settling.slices());
    return skin;
}

} // namespace

TEST_CASE("a skin around a bumpy ball comes to lie on it, without crossings; one that lies there stays near") {
    const TriangleMesh model = shapes::bumpy_sphere(4);
    TriangleMesh around = shapes::icosphere(4);
    for (int v = 0; v < around.vertex_count(); ++v) around.points.row(v) *= model.points.row(v).norm() + 0.05;
    const TriangleMesh on = settled(around, model);
    const SurfaceDistances apart = surface_distances(on, model);
    CHECK(apart.mean_there < 0.001);
    CHECK(apart.mean_back < 0.001);
    CHECK(self_intersections(on).pairs == 0);
    const SurfaceDistances still = surface_distances(settled(model, model), model);
    CHECK(still.mean_there < 0.0005);
}

TEST_CASE("the same at another scale and place") {
    const TriangleMesh model = shapes::bumpy_sphere(3);
    TriangleMesh around = model;
    around.points *= 1.05;
    const Eigen::Affine3d map = Eigen::Translation3d(1e3, 0, 5) * Eigen::Scaling(1e3);
    const TriangleMesh here = settled(around, model), there = settled(shapes::moved(around, map), shapes::moved(model, map));
    CHECK((shapes::moved(here, map).points - there.points).cwiseAbs().maxCoeff() < 1e-7 * 1e3);
}
