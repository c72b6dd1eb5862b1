#include "lissom/match/radial_map.h"

#include "shapes.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>

#include <cmath>

using namespace lissom;
using Eigen::RowVector3d;
using Eigen::Vector3d;

namespace {

/// Some places on a bumpy ball, none like another.
Points places(int count = 12) {
    const Points all = shapes::bumpy_sphere(2).points;
    Points some(count, 3);
    for (int k = 0; k < count; ++k) some.row(k) = all.row(7 * k);
    return some;
}
Points bent(Points points) {
    for (Eigen::Index v = 0; v < points.rows(); ++v)
        points.row(v) += 0.2 * RowVector3d(std::sin(3 * points(v, 1)), std::cos(2 * points(v, 2)), points(v, 0) * points(v, 1));
    return points;
}

} // namespace

TEST_CASE("a radial map carries every place where it should go, from every unit to every unit") {
    for (const double from : {1e-6, 1.0, 1e6})
        for (const double to : {1e-6, 1.0, 1e6}) {
            const Points a = from * places(), b = to * bent(places());
            const auto map = RadialMap::between(a, b);
            REQUIRE(map);
            CHECK(((*map)(a)-b).rowwise().norm().maxCoeff() < 1e-12 * to);
        }
}

TEST_CASE("what an affine map does to the places it does to all of space") {
    Eigen::Affine3d affine = Eigen::Translation3d(3, -1, 2) * Eigen::AngleAxisd(0.7, Vector3d(1, 2, 3).normalized()) * Eigen::Scaling(1.0, 2.0, 0.5);
    const auto map = RadialMap::between(places(), shapes::moved({places(), Triangles(0, 3)}, affine).points);
    REQUIRE(map);
    for (const Vector3d& x : {Vector3d(0, 0, 0), Vector3d(0.3, 5, -2), Vector3d(10, 1, 1)}) CHECK(((*map)(x) - affine * x).norm() < 1e-10);
}

TEST_CASE("turning, moving and scaling either side goes along") {
    const Points a = places(), b = bent(places());
    const Eigen::Affine3d f = Eigen::Translation3d(5, 1, 0) * Eigen::AngleAxisd(1.1, Vector3d(1, -1, 2).normalized()) * Eigen::Scaling(3.0),
                          g = Eigen::Translation3d(0, -4, 1) * Eigen::AngleAxisd(2.1, Vector3d(0, 1, 2).normalized()) * Eigen::Scaling(0.2);
    const auto moved = [](const Points& points, const Eigen::Affine3d& map) { return shapes::moved({points, Triangles(0, 3)}, map).points; };
    const auto here = RadialMap::between(a, b), there = RadialMap::between(moved(a, f), moved(b, g));
    REQUIRE((here && there));
    for (const Vector3d& x : {Vector3d(0, 0, 0), Vector3d(0.3, 0.5, -0.2), Vector3d(1, 1, 1)}) CHECK(((*there)(f * x) - g * (*here)(x)).norm() < 1e-10);
}

TEST_CASE("places that decide no map give none: too few, in one plane, twice the same, not finite") {
    const Points b = bent(places());
    CHECK_FALSE(RadialMap::between(places(3), b.topRows(3)));
    Points flat = places();
    flat.col(2).setZero();
    CHECK_FALSE(RadialMap::between(flat, b));
    Points twice = places();
    twice.row(3) = twice.row(8);
    CHECK_FALSE(RadialMap::between(twice, b));
    Points none = places();
    none(0, 0) = std::nan("");
    CHECK_FALSE(RadialMap::between(none, b));
    CHECK_FALSE(RadialMap::between(Points::Zero(8, 3), b.topRows(8)));
}

TEST_CASE("how far the map through the others ends from each place is known without making those maps") {
    const Points a = places(), b = bent(places());
    const auto G = RadialMap::leave_one_out(a);
    REQUIRE(G);
    const Points left = *G * b;
    for (Eigen::Index i = 0; i < a.rows(); ++i) {
        Points others(a.rows() - 1, 3), images = others;
        others << a.topRows(i), a.bottomRows(a.rows() - 1 - i);
        images << b.topRows(i), b.bottomRows(a.rows() - 1 - i);
        const auto map = RadialMap::between(others, images);
        REQUIRE(map);
        CHECK((left.row(i).transpose() / (*G)(i, i) - (b.row(i).transpose() - (*map)(Vector3d(a.row(i))))).norm() < 1e-9);
    }
    CHECK_FALSE(RadialMap::leave_one_out(places(4))); // three are left
}
