#include "lissom/mesh/plane_section.h"

#include "shapes.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace lissom;
using Eigen::Vector3d;

TEST_CASE("the section of a cylinder is its circle, open or closed, tilted or straight") {
    const TriangleMesh mesh = shapes::cylinder(400, 40, 3);
    const TriangleTree tree(mesh);
    const auto straight = plane_section(mesh, tree, {0, 0, 1}, {0, 0, 1.01});
    REQUIRE(straight.size() == 1);
    CHECK(straight[0].closed);
    CHECK(straight[0].radius() == doctest::Approx(1).epsilon(1e-4));
    CHECK((straight[0].centroid - Vector3d(0, 0, 1.01)).norm() < 1e-9);
    CHECK(straight[0].length == doctest::Approx(2 * M_PI).epsilon(1e-4));
    const auto tilted = plane_section(mesh, tree, Vector3d(0, 0.6, 0.8), {0, 0, 1.5});
    REQUIRE(tilted.size() == 1);
    CHECK(tilted[0].area == doctest::Approx(M_PI / 0.8).epsilon(1e-3));
    const auto along = plane_section(mesh, tree, {1, 0.001, 0}, {0.3, 0, 0});
    CHECK(along.size() == 2);
    for (const SectionLine& line : along) {
        CHECK_FALSE(line.closed);
        CHECK(line.radius() == doctest::Approx(1.5).epsilon(1e-3));
    }
}

TEST_CASE("the line around a point is the smallest that encloses it, else the nearest") {
    const TriangleMesh mesh = shapes::torus(64, 32);
    const TriangleTree tree(mesh);
    const Eigen::RowVector3d sizes = mesh.points.colwise().maxCoeff() - mesh.points.colwise().minCoeff();
    Eigen::Index thin = 0;
    sizes.minCoeff(&thin);
    const Vector3d n = Vector3d::Unit(thin);
    const Vector3d flat = Vector3d::Unit((thin + 1) % 3);
    const auto rings = plane_section(mesh, tree, n, 1e-4 * n);
    REQUIRE(rings.size() == 2);
    const int inner = line_around(rings, n, Vector3d::Zero());
    CHECK(rings[inner].area < rings[1 - inner].area);
    CHECK(line_around(rings, n, flat * 1.0) == 1 - inner); // between the two: only the outer one encloses it
    const auto pair = plane_section(mesh, tree, flat, 1e-4 * flat);
    REQUIRE(pair.size() == 2);
    const int left = line_around(pair, flat, pair[0].centroid);
    CHECK(left == 0);
    CHECK(line_around(pair, flat, 3 * pair[1].centroid) == 1);
    CHECK(line_around({}, flat, flat) == -1);
}

TEST_CASE("one-sided and branching surfaces have sections, too") {
    const TriangleMesh moebius = shapes::moebius();
    const TriangleTree tree(moebius);
    for (const SectionLine& line : plane_section(moebius, tree, {1, 0.2, 0.1}, {0.1, 0, 0})) CHECK(line.length > 0);
    const TriangleMesh sheets = shapes::three_sheets();
    const TriangleTree other(sheets);
    const Vector3d middle = sheets.points.colwise().mean();
    double length = 0;
    for (const Vector3d& n : {Vector3d(1, 0.01, 0.02), Vector3d(0.01, 1, 0.02), Vector3d(0.02, 0.01, 1)})
        for (const SectionLine& line : plane_section(sheets, other, n, middle)) length += line.length;
    CHECK(length > 0);
}
