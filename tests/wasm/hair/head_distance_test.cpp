#include "lissom/hair/head_distance.h"

#include "lissom/mesh/errors.h"
#include "shapes.h"

#include <doctest/doctest.h>

using namespace lissom;
using Eigen::Vector3d;

namespace {

Grid around(const TriangleMesh& mesh, int nodes) {
    const Vector3d low = mesh.points.colwise().minCoeff(), high = mesh.points.colwise().maxCoeff();
    const double side = (high - low).maxCoeff() * 1.5;
    const Vector3d centre = (low + high) / 2;
    return {centre.array() - side / 2, side / (nodes - 1), Eigen::Vector3i::Constant(nodes)};
}

} // namespace

TEST_CASE("the distance to a sphere is the distance to a sphere, with its sign") {
    const TriangleMesh sphere = shapes::uv_sphere(64, 128);
    const HeadDistance distance(sphere, around(sphere, 64));
    for (const double r : {0.2, 0.6, 0.9, 0.99, 1.0, 1.02, 1.1, 1.3})
        for (const Vector3d& way : {Vector3d(1, 0, 0), Vector3d(1, 2, -1).normalized().eval(), Vector3d(-1, -1, 3).normalized().eval()}) {
            const bool near = std::abs(r - 1) < 0.08;
            CHECK(distance.at(r * way) == doctest::Approx(r - 1).scale(1).epsilon(near ? 2e-3 : 0.03));
            if (r > 0.5) CHECK(distance.gradient(r * way).dot(way) == doctest::Approx(1).epsilon(0.05));
        }
}

TEST_CASE("an open neck is closed before inside is asked for") {
    TriangleMesh bowl = shapes::uv_sphere(32, 64);
    Triangles kept(bowl.triangles.rows(), 3);
    Eigen::Index count = 0;
    for (Eigen::Index t = 0; t < bowl.triangles.rows(); ++t) {
        bool below = false;
        for (int k = 0; k < 3; ++k) below = below || bowl.points(bowl.triangles(t, k), 1) < -0.7;
        if (!below) kept.row(count++) = bowl.triangles.row(t);
    }
    bowl.triangles = kept.topRows(count);
    const HeadDistance distance(bowl, around(bowl, 48));
    CHECK(distance.at(Vector3d(0, 0, 0)) < -0.5);
    CHECK(distance.at(Vector3d(0, -0.95, 0)) > 0.1);
    CHECK(distance.at(Vector3d(0, 1.2, 0)) > 0.15);
}

TEST_CASE("a head without area is refused") {
    TriangleMesh flat;
    flat.points = Points::Zero(3, 3);
    flat.triangles.resize(1, 3);
    flat.triangles << 0, 1, 2;
    CHECK_THROWS_AS(HeadDistance(flat, Grid{{0, 0, 0}, 1, {4, 4, 4}}), InvalidInput);
}
