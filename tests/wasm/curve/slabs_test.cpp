#include "lissom/curve/slabs.h"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

using namespace lissom;
using Eigen::Affine3d;
using Eigen::AngleAxisd;
using Eigen::Vector3d;

namespace {

Points bent() {
    Points points(5, 3);
    points << 0, 0, 0, 0.3, 1, 0, 0.2, 2, 0.3, -0.2, 3, 0.1, 0, 4, 0;
    return points;
}

EncodedCurve curve() {
    EncodedCurveOptions options;
    options.radius.assign(5, 0.4);
    return {bent(), options};
}

} // namespace

TEST_CASE("slabs give the rest pose back, and move rigidly with a rigidly moved curve") {
    const EncodedCurve at = curve();
    const SlabTable table(at);
    const Affine3d map = Eigen::Translation3d(1, 2, 3) * AngleAxisd(1.9, Vector3d(1, 0.3, -2).normalized());
    CurvePosture moved{.points = bent(), .base = Eigen::Quaterniond(map.linear())};
    for (int i = 0; i < 5; ++i) moved.points.row(i) = (map * Vector3d(bent().row(i).transpose())).transpose();
    const auto rest = table.posed(at, at.at_rest()), turned = table.posed(at, moved);
    std::mt19937 draw(4);
    std::uniform_real_distribution<double> uniform(-0.4, 0.4);
    for (int k = 0; k < 200; ++k) {
        const Vector3d x(uniform(draw), 2 + 6 * uniform(draw), uniform(draw));
        const SlabPlace place = table.place(x, at.curve().nearest(x).t);
        CHECK((SlabTable::position(rest, place) - x).norm() < 1e-12);
        CHECK((SlabTable::position(turned, place) - map * x).norm() < 1e-9);
    }
}

TEST_CASE("places beyond the ends keep their distance, those between keep their share") {
    const EncodedCurve at = curve();
    const SlabTable table(at);
    CHECK(table.place({0, -1, 0}, 0).slab == -1);
    CHECK(table.place({0, 5, 0}, 1).slab == SlabTable::k_planes - 1);
    const Vector3d x = at.curve().point(0.5025) + Vector3d(0.1, 0, 0);
    const SlabPlace place = table.place(x, 0.5025);
    CHECK(place.slab == 99);
    CHECK(place.ratio >= -0.5);
    CHECK(place.ratio <= 1.5);
}
