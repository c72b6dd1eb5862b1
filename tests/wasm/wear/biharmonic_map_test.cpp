#include "lissom/wear/biharmonic_map.h"

#include "refusal.h"
#include "shapes.h"

#include "lissom/mesh/errors.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>

#include <cmath>

using Eigen::Affine3d;
using Eigen::AngleAxisd;
using Eigen::Vector3d;
using lissom::BiharmonicMap;
using lissom::Points;

namespace {

Points bent(const Points& points) {
    Points moved = points;
    for (Eigen::Index i = 0; i < moved.rows(); ++i) moved(i, 0) += 0.3 * std::sin(2 * points(i, 1));
    return moved;
}

Points applied(const Affine3d& map, const Points& points) { return (points * map.linear().transpose()).rowwise() + map.translation().transpose(); }

} // namespace

TEST_CASE("a map of space goes through its places, and affine ones are found as they are") {
    const Points from = shapes::icosphere(2).points, to = bent(from);
    const BiharmonicMap map(from, to);
    for (int i = 0; i < from.rows(); i += 5) CHECK((map(from.row(i)) - to.row(i).transpose()).norm() < 1e-4);
    Affine3d shear = Affine3d::Identity();
    shear.linear() << 1, 0.4, 0, 0, 1.3, 0.1, 0.2, 0, 0.8;
    shear.translation() << 5, -2, 1;
    const Vector3d far(7, -3, 11);
    CHECK((BiharmonicMap(from, applied(shear, from))(far) - shear * far).norm() < 1e-8);
}

TEST_CASE("a motion or scale of either side of a map is carried along") {
    const Points from = shapes::icosphere(1).points, to = bent(from);
    const BiharmonicMap map(from, to);
    const Affine3d a(Eigen::Translation3d(3, 100, -2) * AngleAxisd(0.7, Vector3d(1, 2, 3).normalized()) * Eigen::Scaling(1e-3)),
        b(Eigen::Translation3d(-8, 0, 4) * AngleAxisd(-2, Vector3d::UnitY()) * Eigen::Scaling(1e4));
    const BiharmonicMap other(applied(a, from), applied(b, to));
    for (const Vector3d& x : {Vector3d(0.2, 0.1, 1.4), Vector3d(3, -2, 0)}) CHECK((other(a * x) - b * map(x)).norm() < 1e4 * 1e-7);
}

TEST_CASE("places that decide no map are refused, doubled ones are not") {
    const Points few = shapes::icosphere(0).points.topRows(3), flat = shapes::sheet(4, 4).points;
    CHECK(refusal([&] { BiharmonicMap(few, few); }) == "too-few-places");
    CHECK_THROWS_AS(BiharmonicMap(flat, flat), lissom::SolverFailure);
    const Points once = shapes::icosphere(1).points;
    Points twice(2 * once.rows(), 3);
    twice << once, once;
    CHECK((BiharmonicMap(twice, twice)(Vector3d(0.3, 0.3, 0.3)) - Vector3d(0.3, 0.3, 0.3)).norm() < 1e-6);
}
