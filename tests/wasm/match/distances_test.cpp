#include "lissom/match/distances.h"

#include "shapes.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>

#include <cmath>

using namespace lissom;

TEST_CASE("distances of two sheets are the height between them, and of what overhangs more, one way alone") {
    TriangleMesh upper = shapes::sheet();
    upper.points.col(2).array() += 0.1;
    const SurfaceDistances same = surface_distances(shapes::sheet(), upper, 2000);
    CHECK(same.mean_there == doctest::Approx(0.1));
    CHECK(same.mean_back == doctest::Approx(0.1));
    CHECK(same.most == doctest::Approx(0.1));
    TriangleMesh wide = upper;
    wide.points.col(0) *= 2;
    const SurfaceDistances other = surface_distances(shapes::sheet(), wide, 2000);
    CHECK(other.mean_there == doctest::Approx(0.1));
    CHECK(other.mean_back > 0.15);
    CHECK(other.most > 0.4);
    CHECK(surface_distances(wide, wide, 500).most == doctest::Approx(0).epsilon(1e-12));
    CHECK(std::isnan(surface_distances({Points(0, 3), Triangles(0, 3)}, wide, 500).mean_there));
}

TEST_CASE("the size is the diagonal of a ball's diameter and a line's length, however they are turned and cut") {
    CHECK(surface_size(shapes::icosphere(4)).size == doctest::Approx(2 * std::sqrt(3)).epsilon(0.01));
    CHECK(surface_size(shapes::uv_sphere(40, 80)).size == doctest::Approx(2 * std::sqrt(3)).epsilon(0.01));
    CHECK(surface_size(shapes::box(1, 1, 1, {1e-6, 1, 1e-6})).size == doctest::Approx(1).epsilon(1e-3));
    const TriangleMesh mesh = shapes::bumpy_sphere();
    const Eigen::Affine3d map = Eigen::Translation3d(1, 2, 3) * Eigen::AngleAxisd(1, Eigen::Vector3d(1, 2, 3).normalized()) * Eigen::Scaling(7.0);
    const SurfaceSize here = surface_size(mesh), there = surface_size(shapes::moved(mesh, map));
    CHECK(there.size == doctest::Approx(7 * here.size).epsilon(1e-12));
    CHECK((there.middle.transpose() - map * here.middle.transpose()).norm() < 1e-12);
    CHECK(surface_size({Points::Zero(3, 3), (Triangles(1, 3) << 0, 1, 2).finished()}).size == 0);
}
