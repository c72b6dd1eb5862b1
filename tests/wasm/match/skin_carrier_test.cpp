#include "lissom/match/skin_carrier.h"

#include "lissom/mesh/operators.h"
#include "shapes.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace lissom;
using Eigen::RowVector3d;

namespace {

/// A ball at about unit size, with waves that a bend moves along.
TriangleMesh ball(double bend, int levels = 3) {
    TriangleMesh mesh = shapes::bumpy_sphere(levels);
    mesh.points *= 0.3;
    for (int v = 0; v < mesh.vertex_count(); ++v) {
        const RowVector3d p = mesh.points.row(v);
        mesh.points.row(v) += bend * RowVector3d(p.y() * p.y(), 0.5 * p.z(), p.x() * p.y());
    }
    return mesh;
}

struct Carried {
    Points points;
    int steps = 0;
};
Carried carried(const TriangleMesh& from, const TriangleMesh& to, int markers, int levels = 2) {
    const FitSurface surface(to);
    CarryGuides guides{{}, std::vector<char>(static_cast<std::size_t>(from.vertex_count()), 0), {}};
    for (int m = 0; m < markers; ++m) {
        guides.left_out[static_cast<std::size_t>(m)] = 1;
        guides.pulls.push_back(Pull::of_vertex(m, to.points.row(m).transpose(), 30));
    }
    const CarrySchedule schedule = carry_schedule(markers);
    GraphLevels graphs(from, schedule.radius, levels);
    SkinCarrier carrier(from.points, from.triangles, graphs, surface, guides, schedule);
    CHECK(carrier.fraction() == 0);
    Carried result;
    double before = 0;
    for (bool more = true; more; ++result.steps) {
        more = carrier.step();
        CHECK(carrier.fraction() > before);
        before = carrier.fraction();
    }
    CHECK(before == 1);
    CHECK_FALSE(carrier.step());
    result.points = carrier.points();
    return result;
}

} // namespace

TEST_CASE("a skin is carried to a bent ball, with markers and without, and one that lies there already stays") {
    const TriangleMesh from = ball(0), to = ball(0.5);
    const double apart = (from.points - to.points).rowwise().norm().mean();
    for (const int markers : {0, 12}) {
        CAPTURE(markers);
        const Carried result = carried(from, to, markers);
        const FitSurface surface(to);
        double sum = 0;
        for (int v = 0; v < from.vertex_count(); ++v) sum += surface.nearest(result.points.row(v), Eigen::Vector3d::Zero(), -1, INFINITY).distance;
        CHECK(sum / from.vertex_count() < 0.005);
        CHECK((result.points - to.points).rowwise().norm().mean() < (markers > 0 ? 0.2 : 1.0) * apart);
        CHECK((carried(from, from, markers).points - from.points).rowwise().norm().maxCoeff() < 1e-6);
    }
}

TEST_CASE("graphs get finer by halves, but no finer than is worth it, and stay where they are") {
    const TriangleMesh mesh = ball(0, 4);
    GraphLevels graphs(mesh, 0.1, 4);
    const NodeGraph& first = graphs[0];
    const int nodes = first.count();
    CHECK(graphs[2].radius() == doctest::Approx(0.025));
    CHECK(&graphs[0] == &first);
    CHECK(first.count() == nodes);
    CHECK(graphs[3].count() > graphs[2].count());
    GraphLevels fine(mesh, 1e-6, 1);
    CHECK(fine[0].count() < 4000);
    CHECK(fine[0].radius() > 1e-3);
}
