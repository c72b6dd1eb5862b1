#include "lissom/merge/refine.h"

#include "lissom/mesh/operators.h"
#include "lissom/mesh/polyline.h"
#include "lissom/mesh/topology.h"
#include "tubes.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

using namespace lissom;

namespace {

/// A tube whose open loop is its only one.
Part part_of(int rows, int around, double unit = 1) {
    const std::vector<BoundaryLoop> loops{{tubes::first(around), {}}};
    TriangleMesh mesh = tubes::tube(rows, around, tubes::dome);
    mesh.points *= unit;
    return cut_part(mesh, loops, "source");
}

double longest_edge(const Part& part) {
    const std::vector<int>& loop = part.loops[0];
    double longest = 0;
    for (std::size_t i = 0; i < loop.size(); ++i)
        longest = std::max(longest, (part.mesh.points.row(loop[(i + 1) % loop.size()]) - part.mesh.points.row(loop[i])).norm());
    return longest;
}

double least_angle(const TriangleMesh& mesh) {
    double least = 10;
    for (int t = 0; t < mesh.triangle_count(); ++t)
        for (int c = 0; c < 3; ++c) {
            const Eigen::Vector3d p = mesh.points.row(mesh.triangles(t, c)), a = mesh.points.row(mesh.triangles(t, (c + 1) % 3)), b = mesh.points.row(mesh.triangles(t, (c + 2) % 3));
            least = std::min(least, std::atan2((a - p).cross(b - p).norm(), (a - p).dot(b - p)));
        }
    return least;
}

} // namespace

TEST_CASE("a loop refined has no edge longer than asked for, on the same surface") {
    for (const double share : {0.7, 0.3, 0.05}) {
        CAPTURE(share);
        const Part before = part_of(10, 12);
        Part after = before;
        const double wanted = share * longest_edge(before);
        const int added = refine_loop(after, 0, wanted);
        CHECK(added > 0);
        CHECK(added == after.mesh.vertex_count() - before.mesh.vertex_count());
        CHECK(longest_edge(after) <= wanted * (1 + 1e-6));
        CHECK(triangle_areas(after.mesh).sum() == doctest::Approx(triangle_areas(before.mesh).sum()));
        CHECK(loop_length(after.mesh.points, after.loops[0]) == doctest::Approx(loop_length(before.mesh.points, before.loops[0])));
        CHECK(euler_characteristic(after.mesh) == euler_characteristic(before.mesh));
        CHECK(boundary_loops(after.mesh).size() == 1);
        CHECK(least_angle(after.mesh) >= 0.5 * least_angle(before.mesh));
    }
}

TEST_CASE("vertices keep their numbers, new ones come last and know where they lie, pieces know their triangle") {
    const Part before = part_of(10, 12);
    Part after = before;
    (void)refine_loop(after, 0, 0.2 * longest_edge(before));
    CHECK(after.mesh.points.topRows(before.mesh.vertex_count()) == before.mesh.points);
    REQUIRE(static_cast<int>(after.origin.size()) == after.mesh.vertex_count());
    for (int v = 0; v < after.mesh.vertex_count(); ++v) {
        Eigen::RowVector3d place = Eigen::RowVector3d::Zero();
        for (std::size_t k = 0; k < 3; ++k) place += after.origin[v].weight[k] * before.mesh.points.row(after.origin[v].vertex[k]);
        CHECK((place - after.mesh.points.row(v)).norm() < 1e-12);
    }
    Eigen::VectorXd area = Eigen::VectorXd::Zero(before.mesh.triangle_count());
    for (int t = 0; t < after.mesh.triangle_count(); ++t) area[after.triangle_origin[t]] += triangle_areas(after.mesh)[t];
    CHECK((area - triangle_areas(before.mesh)).norm() < 1e-12);
    for (int t = 0; t < after.mesh.triangle_count(); ++t)
        if (after.is_whole[t]) CHECK(after.mesh.triangles.row(t) == before.mesh.triangles.row(after.triangle_origin[t]));
    std::vector<int> kept = after.loops[0];
    std::erase_if(kept, [&](int v) { return v >= before.mesh.vertex_count(); });
    CHECK(kept == before.loops[0]);
}

TEST_CASE("refining goes inward no farther than it must") {
    const Part before = part_of(40, 12);
    Part after = before;
    (void)refine_loop(after, 0, 0.2 * longest_edge(before));
    const int far = 30 * 12; // from this row on
    int whole = 0, all = 0;
    for (int t = 0; t < before.mesh.triangle_count(); ++t) all += before.mesh.triangles.row(t).minCoeff() >= far;
    for (int t = 0; t < after.mesh.triangle_count(); ++t) whole += after.is_whole[t] && after.mesh.triangles.row(t).minCoeff() >= far;
    CHECK(all > 0);
    CHECK(whole == all);
}

TEST_CASE("a loop that is fine enough is left alone, and the unit does not matter") {
    Part part = part_of(10, 12);
    const Triangles before = part.mesh.triangles;
    CHECK(refine_loop(part, 0, longest_edge(part)) == 0);
    CHECK(part.mesh.triangles == before);
    for (const double unit : {1e-4, 1e4}) {
        Part here = part_of(10, 12), there = part_of(10, 12, unit);
        CHECK(refine_loop(here, 0, 0.1) == refine_loop(there, 0, 0.1 * unit));
        CHECK(here.mesh.triangles == there.mesh.triangles);
    }
}

TEST_CASE("an edge between neighbouring numbers has no middle, and refining ends there") {
    Part part = part_of(6, 12);
    part.mesh.points.row(1) = part.mesh.points.row(0);
    part.mesh.points(1, 0) = std::nextafter(part.mesh.points(0, 0), 2.0);
    const double length = (part.mesh.points.row(1) - part.mesh.points.row(0)).norm();
    part.mesh.points.row(2) = part.mesh.points.row(1);
    CHECK(refine_loop(part, 0, 0.5) > 0);
    Part tiny = part;
    tiny.loops[0].resize(12);
    const TriangleMesh before = tiny.mesh;
    for (int v = 3; v < tiny.mesh.vertex_count(); ++v) tiny.mesh.points.row(v) = tiny.mesh.points.row(0); // one place but for one digit
    CHECK(refine_loop(tiny, 0, 0.3 * length) == 0);
}
