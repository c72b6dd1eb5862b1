#include "lissom/wear/body.h"

#include "shapes.h"

#include <doctest/doctest.h>

using Eigen::Vector3d;
using lissom::Body;

TEST_CASE("a closed surface has an inside, whichever way it faces") {
    for (const auto& mesh : {shapes::bumpy_sphere(3), shapes::turned_inside_out(shapes::bumpy_sphere(3))}) {
        const Body body(mesh, 3.5);
        CHECK(body.has_inside());
        CHECK(body.contains({0.2, 0.1, 0}));
        CHECK(!body.contains({2, 0, 0}));
        const Body::Place at = body.nearest({3, 0, 0});
        CHECK(at.normal.x() > 0.5);
        CHECK(at.distance == doctest::Approx((at.point - Vector3d(3, 0, 0)).norm()));
    }
}

TEST_CASE("openings of a limb are closed by fans") {
    const Body tube(shapes::cylinder(48, 24, 3), 4.3);
    CHECK(tube.has_inside());
    CHECK(tube.contains({0.5, 0.5, 0.1}));
    CHECK(!tube.contains({0, 0, -0.1}));
    CHECK(!tube.contains({0, 0, 3.1}));
}

TEST_CASE("a clean soup still has an inside; mixed up triangles and sheets have none") {
    CHECK(Body(shapes::soup(shapes::icosphere(3), 1e-4), 3.5).has_inside());
    CHECK(!Body(shapes::soup(shapes::with_mixed_orientation(shapes::icosphere(3), 2)), 3.5).has_inside());
    CHECK(!Body(shapes::three_sheets(6), 1).has_inside());
}
