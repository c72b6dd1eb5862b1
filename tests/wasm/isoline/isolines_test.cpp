#include "lissom/isoline/isolines.h"

#include "shapes.h"

#include <doctest/doctest.h>

#include <numbers>
#include <set>

using namespace lissom;

TEST_CASE("the isoline of the height of a sphere is one loop, as long as its parallel") {
    const TriangleMesh mesh = shapes::icosphere(5);
    for (const double height : {-0.8, 0.0, 0.3}) {
        const Isoline line = isoline(mesh, mesh.points.col(1), height);
        REQUIRE(line.loops.size() == 1);
        CHECK(line.closed == 1);
        CHECK(line.loops[0].size() == line.segments.size());
        CHECK(line.length() == doctest::Approx(2 * std::numbers::pi * std::sqrt(1 - height * height)).epsilon(2e-3));
        for (const IsolineSegment& s : line.segments) CHECK(std::abs(s.from[1] - height) + std::abs(s.to[1] - height) < 1e-12);
    }
}

TEST_CASE("segments of a loop follow one another, larger values to the left") {
    const TriangleMesh mesh = shapes::torus();
    const Eigen::VectorXd field = mesh.points.col(0);
    const Isoline line = isoline(mesh, field, 0.13);
    CHECK(line.closed == 2); // a tube cut twice
    REQUIRE(line.loops.size() == 2);
    std::set<int> walked;
    for (const auto& loop : line.loops)
        for (std::size_t k = 0; k < loop.size(); ++k) {
            const IsolineSegment& here = line.segments[loop[k]];
            const IsolineSegment& next = line.segments[loop[(k + 1) % loop.size()]];
            CHECK((here.to - next.from).norm() < 1e-12);
            CHECK(walked.insert(loop[k]).second);
            const Eigen::Vector3d a = mesh.points.row(mesh.triangles(here.triangle, 0)), b = mesh.points.row(mesh.triangles(here.triangle, 1)),
                                  c = mesh.points.row(mesh.triangles(here.triangle, 2));
            CHECK((b - a).cross(c - a).cross(here.to - here.from).dot(Eigen::Vector3d::UnitX()) >= 0);
        }
    CHECK(walked.size() == line.segments.size());
}

TEST_CASE("on a surface with a boundary isolines end there") {
    const TriangleMesh sheet = shapes::sheet(8, 8);
    const Isoline line = isoline(sheet, sheet.points.col(0), sheet.points.col(0).mean() + 0.01);
    CHECK(line.closed == 0);
    CHECK(line.loops.size() == 1);
    CHECK(line.length() == doctest::Approx(1).epsilon(1e-9));
}

TEST_CASE("a value that vertices have is crossed once a triangle, without holes") {
    const TriangleMesh mesh = shapes::bar();
    const Isoline line = isoline(mesh, mesh.points.col(1), 4.0); // a row of vertices lies there
    CHECK(line.closed == 1);
    CHECK(line.loops.size() == 1);
    std::set<int> triangles;
    for (const IsolineSegment& s : line.segments) CHECK(triangles.insert(s.triangle).second);
    CHECK(line.length() == doctest::Approx(4).epsilon(1e-9));
}

TEST_CASE("a value that nothing has gives nothing") {
    const TriangleMesh mesh = shapes::icosphere(2);
    const Isoline line = isoline(mesh, mesh.points.col(0), 2);
    CHECK(line.segments.empty());
    CHECK(line.loops.empty());
    CHECK(line.length() == 0);
}
