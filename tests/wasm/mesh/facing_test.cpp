#include "lissom/mesh/facing.h"

#include "shapes.h"

#include <doctest/doctest.h>

using namespace lissom;
using Eigen::Affine3d;

TEST_CASE("closed and open surfaces face outward, turned inside out they face inward") {
    for (const TriangleMesh& mesh : {shapes::bumpy_sphere(2), shapes::torus(), shapes::box(2, 3, 4), shapes::cylinder()}) {
        CHECK(facing(mesh) == 1);
        CHECK(facing(shapes::turned_inside_out(mesh)) == -1);
    }
}

TEST_CASE("the unit, the place and the turn do not matter") {
    const TriangleMesh open = shapes::cylinder();
    for (const double scale : {1e-6, 1.0, 1e6})
        for (const double away : {0.0, 1e5}) {
            const Affine3d map = Eigen::Scaling(scale) * Eigen::Translation3d(away, -away, 2 * away) * Eigen::AngleAxisd(2, Eigen::Vector3d(1, 2, 3).normalized());
            CHECK(facing(shapes::moved(open, map)) == 1);
        }
}

TEST_CASE("what is flat does not tell") {
    CHECK(facing(shapes::sheet()) == 0);
    CHECK(facing(shapes::turned_inside_out(shapes::sheet())) == 0);
    CHECK(facing(shapes::moved(shapes::icosphere(2), Affine3d(Eigen::Scaling(1.0, 1e-4, 1.0)))) == 0);
}

TEST_CASE("of two pieces the larger decides") {
    const TriangleMesh small = shapes::moved(shapes::turned_inside_out(shapes::icosphere(2)), Affine3d(Eigen::Translation3d(5, 0, 0) * Eigen::Scaling(0.5)));
    CHECK(facing(shapes::joined({shapes::icosphere(2), small})) == 1);
}
