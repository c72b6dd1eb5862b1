#include "lissom/isoline/full_pass.h"

#include "sessions.h"

#include "lissom/isoline/taubin.h"
#include "lissom/mesh/operators.h"

#include <doctest/doctest.h>

using namespace lissom;
using namespace sessions;
using Eigen::Affine3d;

namespace {

FullPass ready(const WorkingMesh& working, const std::vector<DeformHandle>& held) {
    FullPass pass(working, handles::everything(working.source), held);
    while (pass.step()) {
    }
    return pass;
}

} // namespace

TEST_CASE("a surface that is where its handles want it stays there") {
    const Affine3d map = handles::turn(140, {1, 2, 0}) * Eigen::Translation3d(3, 1, 0);
    for (const handles::Named& model : handles::models()) {
        CAPTURE(model.name);
        const WorkingMesh working = shapes::working(model.mesh);
        const FullPass pass = ready(working, handles::two_ends(model.mesh.points));
        const Points there = handles::images(map, model.mesh.points);
        CHECK(handles::gap(pass.apply(there, std::vector{map, map}), there) < 1e-6 * diagonal(model.mesh.points));
    }
}

TEST_CASE("one pass brings a reduced result nearer to the limit of the full method, handles exact") {
    const TriangleMesh mesh = shapes::box(6, 40, 6, {1, 6, 1});
    const auto ends = handles::two_ends(mesh.points, 0.05);
    const std::vector<Affine3d> targets{Affine3d::Identity(), handles::turn(-100, {0, 0, 1}, {2, 3, 0})};
    const Points reduced = drag(mesh, ends, targets).positions;
    const WorkingMesh working = shapes::working(mesh);
    const FullPass pass = ready(working, ends);
    const Points once = pass.apply(reduced, targets), limit = pass.apply(reduced, targets, 60);
    const auto distance = [&](const Points& p) { return (p - limit).rowwise().norm().mean() / diagonal(mesh.points); };
    MESSAGE("mean distance to the limit: reduced " << distance(reduced) << ", after one pass " << distance(once));
    CHECK(distance(once) < 0.8 * distance(reduced));
    for (const int v : ends[1].vertices)
        CHECK((once.row(v).transpose() - targets[1] * Eigen::Vector3d(mesh.points.row(v))).norm() < 1e-12 * diagonal(mesh.points));
}

TEST_CASE("details turn with the surface under them") {
    TriangleMesh sheet = shapes::sheet(40, 40); // flat, with a spike on every seventh vertex
    Points base = sheet.points;
    for (int v = 0; v < sheet.vertex_count(); v += 7) sheet.points(v, 2) += 0.02;
    Points moved_base = base; // rolled onto a cylinder
    for (Eigen::Index v = 0; v < base.rows(); ++v) moved_base.row(v) << std::sin(base(v, 0)), base(v, 1), std::cos(base(v, 0)) - 1;
    Points translated = sheet.points + (moved_base - base); // what a blend without rotation makes of the spikes
    const Points turned = with_turned_details(sheet, translated, base, moved_base, std::vector<bool>(static_cast<std::size_t>(sheet.vertex_count()), false));
    for (int v = 0; v < sheet.vertex_count(); v += 7) {
        const Eigen::RowVector3d normal(std::sin(base(v, 0)), 0, std::cos(base(v, 0)));
        CHECK((turned.row(v) - moved_base.row(v) - 0.02 * normal).norm() < 0.02 * 0.05);
    }
    CHECK(with_turned_details(sheet, translated, base, moved_base, std::vector<bool>(static_cast<std::size_t>(sheet.vertex_count()), true)) == translated);
}
