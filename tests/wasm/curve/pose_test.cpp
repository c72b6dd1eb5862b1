#include "lissom/curve/pose.h"

#include "posing.h"
#include "refusal.h"

#include "lissom/mesh/operators.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <random>

using namespace posing;
using Eigen::Affine3d;
using Eigen::AngleAxisd;
using Eigen::Quaterniond;
using Eigen::Vector3d;

namespace {

CurveSpec on_axis(int controls = 5) { return {.rest = axis(controls), .anchor = lissom::CurveEnd::start}; }

CurvePosture moved_by(const Points& rest, const Affine3d& map) { return {.points = mapped(rest, map), .base = Quaterniond(map.linear())}; }

Affine3d some_motion() { return Eigen::Translation3d(3, -2, 5) * AngleAxisd(2.1, Vector3d(1, 2, -0.5).normalized()); }

/// A trunk with two branches on it: three linked curves.
struct Tree {
    TriangleMesh mesh = shapes::box(8, 40, 8, {1, 10, 1});
    std::vector<CurveSpec> curves{on_axis(), {.rest = line({0, 5, 0}, {0, 7.5, 0}, 3)}, {.rest = line({0, 7.5, 0}, {0, 10, 0}, 3)}};
    std::vector<lissom::CurveLink> links{{1, 0, 0.5}, {2, 1, 1}};
};

} // namespace

TEST_CASE("at rest nothing moves, whatever the encoding, blending and unit") {
    for (const double unit : {1e-6, 1.0, 1e6})
        for (const auto encoding : {lissom::CurveEncoding::kernel, lissom::CurveEncoding::slabs})
            for (const auto blending : {lissom::CurveBlending::ownership, lissom::CurveBlending::geodesic, lissom::CurveBlending::gaussian}) {
                Tree tree;
                const Affine3d scaled(Eigen::Scaling(unit));
                tree.mesh = shapes::moved(tree.mesh, scaled);
                for (CurveSpec& curve : tree.curves) curve.rest *= unit;
                const CurveSession made = session(tree.mesh, tree.curves, tree.links, {.blending = blending, .encoding = encoding});
                const std::vector<CurvePosture> resting(3);
                CHECK(gap(made.positions(resting), tree.mesh.points) < 1e-12 * 10 * unit);
            }
}

TEST_CASE("a curve moved rigidly moves its model rigidly, with its roll") {
    const TriangleMesh mesh = bar(6);
    const Points bent = row_list({{0, 0, 0}, {0.1, 2.5, 0}, {0, 5, 0.1}, {-0.1, 7.5, 0}, {0, 10, 0}});
    for (const Points& rest : {axis(5), bent}) {
        const CurveSession made = session(mesh, {{.rest = rest}});
        for (const Affine3d& map : {some_motion(), Affine3d(AngleAxisd(1.0, Vector3d::UnitY()))}) {
            const CurvePosture posture = moved_by(rest, map);
            CHECK(gap(made.positions({&posture, 1}), mapped(mesh.points, map)) < 1e-9 * 10);
        }
    }
    // The same of linked curves: the root's motion is everyone's.
    const Tree tree;
    const CurveSession made = session(tree.mesh, tree.curves, tree.links);
    std::vector<CurvePosture> postures(3);
    postures[0] = moved_by(tree.curves[0].rest, some_motion());
    CHECK(gap(made.positions(postures), mapped(tree.mesh.points, some_motion())) < 1e-9 * 10);
}

TEST_CASE("a straight stretch is one of the model, but beyond the ends") {
    const TriangleMesh mesh = bar(6);
    CurveSpec spec{.rest = line({0, 1, 0}, {0, 9, 0}, 5), .anchor = lissom::CurveEnd::start};
    const CurveSession made = session(mesh, {spec});
    const CurvePosture stretched{.points = line({0, 1, 0}, {0, 1 + 8 * 1.7, 0}, 5)};
    const Points moved = made.positions({&stretched, 1});
    double inside = 0, beyond = 0;
    for (int v = 0; v < mesh.vertex_count(); ++v) {
        const Vector3d x = mesh.points.row(v);
        Vector3d wanted = x;
        wanted.y() = x.y() < 1 ? x.y() : x.y() > 9 ? x.y() + 8 * 0.7 : 1 + (x.y() - 1) * 1.7;
        double& worst = x.y() < 1 || x.y() > 9 ? beyond : inside;
        worst = std::max(worst, (moved.row(v).transpose() - wanted).norm());
    }
    MESSAGE("stretched 1.7 times: error inside " << inside / 8 << " of the length, beyond the ends " << beyond / 8);
    CHECK(inside < 1e-6 * 8);
    CHECK(beyond < 1e-9 * 8);
}

TEST_CASE("the anchored end stays still while the other is dragged, at either end") {
    const TriangleMesh mesh = bar(6);
    for (const auto end : {lissom::CurveEnd::start, lissom::CurveEnd::end}) {
        const bool at_start = end == lissom::CurveEnd::start;
        CurveSpec spec{.rest = line({0, 3, 0}, {0, 7, 0}, 4), .anchor = end};
        const CurveSession made = session(mesh, {spec});
        CurvePosture dragged{.points = spec.rest, .twist = {40, 30, 20, 10}, .scale = {{1.2, 1.1}, {1.2, 1.1}, {1.2, 1.1}, {1.2, 1.1}}};
        dragged.points.row(at_start ? 3 : 0) += Eigen::RowVector3d(2, 0, 1);
        dragged.points.row(at_start ? 2 : 1) += Eigen::RowVector3d(1, 0, 0);
        const Points moved = made.positions({&dragged, 1});
        double still = 0, other = 0;
        for (int v = 0; v < mesh.vertex_count(); ++v) {
            const double y = mesh.points(v, 1), away = (moved.row(v) - mesh.points.row(v)).norm();
            if (at_start ? y < 3 : y > 7) still = std::max(still, away);
            if (at_start ? y > 7 : y < 3) other = std::max(other, away);
        }
        CHECK(still < 1e-12);
        CHECK(other > 1);
    }
}

TEST_CASE("twist turns and scale widens, about the curve") {
    const TriangleMesh mesh = bar(6);
    const CurveSession made = session(mesh, {on_axis()});
    CurvePosture posture{.points = axis(5), .twist = {0, 30, 60, 90, 90}, .scale = {{1, 1}, {1, 1}, {2, 0.5}, {2, 0.5}, {2, 0.5}}};
    const Points moved = made.positions({&posture, 1});
    for (int v = 0; v < mesh.vertex_count(); ++v) {
        const Vector3d x = mesh.points.row(v), y = moved.row(v);
        CHECK(y.y() == doctest::Approx(x.y()).epsilon(1e-9)); // nothing moves along
        if (std::abs(x.y() - 10) > 1e-9) continue;
        // A quarter turn, the axes 2 and ½ times as long: the frame's v and w lie along x and z here.
        CHECK(std::abs(y.x() * y.z()) == doctest::Approx(std::abs(x.x() * x.z())).epsilon(1e-6));
        CHECK(Eigen::Vector2d(y.x(), y.z()).norm() <= 2 * Eigen::Vector2d(x.x(), x.z()).norm() + 1e-9);
    }
}

TEST_CASE("a child takes over what its parent does, and its own pose comes on top") {
    const Tree tree;
    const CurveSession made = session(tree.mesh, tree.curves, tree.links);
    std::vector<CurvePosture> postures(3);
    postures[0].points = arc(60, 5);
    const auto motions = made.parent_motions(postures);
    CHECK(motions[0].isApprox(Affine3d::Identity()));
    CHECK(motions[1].linear().determinant() == doctest::Approx(1));
    const lissom::SplineCurve trunk(arc(60, 5));
    CHECK((motions[1] * Vector3d(0, 5, 0) - trunk.point(0.5)).norm() < 1e-9); // the link is where the parent is
    CHECK((motions[2] * Vector3d(0, 7.5, 0) - motions[1] * Vector3d(0, 7.5, 0)).norm() < 1e-9);
    postures[1].points = row_list({{0, 5, 0}, {1, 6, 0}, {2, 6.5, 0}});
    CHECK(made.parent_motions(postures)[1].isApprox(motions[1]));
    CHECK_FALSE(made.parent_motions(postures)[2].isApprox(motions[2]));
}

TEST_CASE("limbs that share a model have regions apart, each along its own curve") {
    const TriangleMesh mesh = bar(8);
    const CurveSession made = session(mesh, {{.rest = line({0, 0.5, 0}, {0, 5, 0}, 3)}, {.rest = line({0, 5, 0}, {0, 9.5, 0}, 3)}}, {{1, 0, 1}});
    std::vector<int> taken(static_cast<std::size_t>(mesh.vertex_count()), 0);
    for (int c = 0; c < made.curve_count(); ++c) {
        CHECK_FALSE(made.region(c).empty());
        for (const int v : made.region(c)) ++taken[static_cast<std::size_t>(v)];
    }
    CHECK(*std::max_element(taken.begin(), taken.end()) == 1);
}

TEST_CASE("what touches both ends of a curve is blended between them, not torn") {
    const TriangleMesh ring = shapes::torus(48, 16);
    std::vector<Vector3d> half; // along one half of the ring
    for (int i = 0; i <= 8; ++i) half.push_back(Vector3d(std::cos(std::numbers::pi * i / 8), 0, 0) + std::sin(std::numbers::pi * i / 8) * Vector3d(0, 1, 0));
    const bool flat_in_xy = ring.points.col(2).cwiseAbs().maxCoeff() < 0.5;
    if (!flat_in_xy)
        for (Vector3d& p : half) std::swap(p[1], p[2]);
    const Points rest = row_list(half);
    const CurveSession made = session(ring, {{.rest = rest}});
    CurvePosture pulled{.points = rest};
    for (int i = 0; i <= 8; ++i) pulled.points(i, flat_in_xy ? 2 : 1) += 0.6 * i / 8.0;
    const double stretch = edge_stretch(ring, made.positions({&pulled, 1}));
    MESSAGE("a ring pulled apart by 0.3 of its width: largest edge stretch " << stretch);
    CHECK(stretch < 4);
}

TEST_CASE("a contour pulls the surface around it and turns nothing") {
    TriangleMesh mesh = shapes::sheet(60, 60);
    const double middle = mesh.points.col(1).mean(), low = mesh.points.col(0).minCoeff(), wide = mesh.points.col(0).maxCoeff() - low;
    const Points rest = line({low + 0.4 * wide, middle, 0}, {low + 0.6 * wide, middle, 0}, 4);
    CurveSpec spec{.rest = rest, .role = lissom::CurveRole::contour};
    const CurveSession made = session(mesh, {spec});
    const CurvePosture resting{};
    CHECK(gap(made.positions({&resting, 1}), mesh.points) < 1e-14);
    CurvePosture lifted{.points = rest};
    lifted.points.col(2).array() += 0.05;
    const Points moved = made.positions({&lifted, 1});
    double most = 0;
    for (int v = 0; v < mesh.vertex_count(); ++v) {
        const Vector3d x = mesh.points.row(v), away = moved.row(v).transpose() - x;
        CHECK(away.head<2>().norm() < 1e-12); // moved, not turned
        CHECK(away.z() >= -1e-12);
        CHECK(away.z() <= 0.05 + 1e-9);
        most = std::max(most, away.z());
        if (x.x() < low + 0.1 * wide) CHECK(moved.row(v) == mesh.points.row(v));
    }
    CHECK(most > 0.04);
}

TEST_CASE("a contour's pull ends at its reach, and leaves a held line where it is, whatever the size") {
    for (const double size : {1.0, 1e-3, 1e4}) {
        TriangleMesh mesh = shapes::sheet(60, 60);
        mesh.points *= size;
        const double middle = mesh.points.col(1).mean(), low = mesh.points.col(0).minCoeff(), wide = mesh.points.col(0).maxCoeff() - low;
        const auto across = [&](double y) { return line({low + 0.3 * wide, y, 0}, {low + 0.7 * wide, y, 0}, 4); };
        CurveSpec spec{.rest = across(middle), .role = lissom::CurveRole::contour};
        spec.reach = 0.1 * wide;
        spec.held = {across(middle + 0.05 * wide)};
        const CurveSession made = session(mesh, {spec});
        CurvePosture lifted{.points = spec.rest};
        lifted.points.col(2).array() += 0.05 * wide;
        const Points moved = made.positions({&lifted, 1});
        double on = 0, below = 0;
        for (int v = 0; v < mesh.vertex_count(); ++v) {
            const double y = mesh.points(v, 1) - middle, x = mesh.points(v, 0) - low, height = moved(v, 2);
            if (std::abs(y) > 0.1 * wide || x < 0.2 * wide - 1e-9 * wide || x > 0.8 * wide + 1e-9 * wide) CHECK(height == 0);
            if (x < 0.35 * wide || x > 0.65 * wide) continue;
            if (std::abs(y - 0.05 * wide) < 1e-3 * wide) on = std::max(on, height);
            if (y < -0.05 * wide) below = std::max(below, height);
        }
        CHECK(below > 0.01 * wide);
        CHECK(on < 0.01 * below); // the held line stays
    }
    CurveSpec wrong{.rest = line({0, 0, 0}, {1, 0, 0}, 3), .role = lissom::CurveRole::contour};
    wrong.reach = -1;
    CHECK(refusal([&] { (void)session(shapes::sheet(4, 4), {wrong}); }) == "line-radius");
}

TEST_CASE("what the shader draws is what the core computes") {
    const Tree tree;
    const CurveSession made = session(tree.mesh, tree.curves, tree.links);
    std::vector<CurvePosture> postures(3);
    postures[0].points = arc(70, 5);
    postures[0].twist = {0, 20, 40, 60, 80};
    postures[1].points = row_list({{0, 5, 0}, {0.5, 6, 0.3}, {1, 7, 0.5}});
    postures[2].scale = {{1, 1}, {1.5, 1}, {2, 1.2}};
    CHECK(gap(drawn(made, postures, tree.mesh.points), made.positions(postures)) < 1e-5 * 10); // in single precision
    const auto attributes = made.attributes();
    for (int v = 0; v < tree.mesh.vertex_count(); ++v) {
        double sum = 0;
        for (int k = 0; k < 4; ++k) sum += attributes.weights[4 * static_cast<std::size_t>(v) + static_cast<std::size_t>(k)];
        CHECK(sum == doctest::Approx(1).epsilon(1e-6));
    }
}

TEST_CASE("normals of a pose are those of the posed surface") {
    const TriangleMesh mesh = shapes::cylinder(48, 120, 10);
    const Points rest = line({0, 0, 0.5}, {0, 0, 9.5}, 7);
    const CurveSession made = session(mesh, {{.rest = rest, .anchor = lissom::CurveEnd::start}});
    CurvePosture posture{.points = rest, .twist = {0, 10, 20, 30, 40, 50, 60}};
    for (int i = 0; i < 7; ++i) posture.points(i, 0) += 0.08 * i * i;
    posture.scale.assign(7, {1, 1});
    posture.scale[3] = {1.4, 0.8};
    const Points moved = made.positions({&posture, 1});
    const Points computed = made.normals({&posture, 1}, lissom::vertex_normals(mesh)), measured = lissom::vertex_normals({moved, mesh.triangles});
    double sum = 0, worst = 0;
    int count = 0;
    for (int v = 0; v < mesh.vertex_count(); ++v) {
        if (mesh.points(v, 2) < 0.8 || mesh.points(v, 2) > 9.2) continue;
        const double angle = std::acos(std::clamp(computed.row(v).dot(measured.row(v)), -1.0, 1.0)) * 180 / std::numbers::pi;
        sum += angle;
        worst = std::max(worst, angle);
        ++count;
    }
    MESSAGE("normals beside those of the posed mesh: mean " << sum / count << ", most " << worst << " degrees");
    CHECK(sum / count < 0.5);
    CHECK(worst < 3);
}

TEST_CASE("points without faces pose as their surface does") {
    const TriangleMesh mesh = bar(6);
    const CurveSession surface = session(mesh, {on_axis()});
    CurveSession cloud(mesh.points, {on_axis()});
    while (cloud.step()) {}
    const CurvePosture posture{.points = arc(60, 5), .twist = {0, 10, 20, 30, 40}};
    CHECK(gap(cloud.positions({&posture, 1}), surface.positions({&posture, 1})) < 0.05);
    const CurvePosture resting{};
    CHECK(gap(cloud.positions({&resting, 1}), mesh.points) < 1e-11);
    Points broken = mesh.points;
    broken(5, 1) = std::nan("");
    CurveSession some(broken, {on_axis()});
    while (some.step()) {}
    const Points moved = some.positions({&posture, 1});
    for (int v = 0; v < moved.rows(); ++v) CHECK(moved.row(v).allFinite() == (v != 5));
}

TEST_CASE("vertices that no curve reaches stay as they are, bit for bit") {
    const TriangleMesh near = bar(4);
    const TriangleMesh mesh = shapes::joined({near, shapes::moved(shapes::icosphere(2), Affine3d(Eigen::Translation3d(30, 5, 0)))});
    const CurveSession made = session(mesh, {on_axis()});
    const CurvePosture posture{.points = arc(60, 5)};
    const Points moved = made.positions({&posture, 1});
    for (int v = near.vertex_count(); v < mesh.vertex_count(); ++v) CHECK(moved.row(v) == mesh.points.row(v));
}

TEST_CASE("a curve off the model moves nothing and says so") {
    const TriangleMesh mesh = bar(4);
    const CurveSession made = session(mesh, {{.rest = line({100, 0, 0}, {100, 10, 0}, 3)}});
    REQUIRE(made.warnings().size() == 1);
    CHECK(made.warnings()[0].code == "empty-region");
    CHECK(made.warnings()[0].examples == std::vector<int>{0});
    const CurvePosture posture{.points = line({100, 0, 0}, {105, 10, 0}, 3)};
    CHECK(made.positions({&posture, 1}).allFinite());
}

TEST_CASE("sixty curves, and two on one limb, pose without trouble") {
    const TriangleMesh mesh = bar(4);
    std::vector<CurveSpec> many;
    for (int i = 0; i < 60; ++i) many.push_back({.rest = line({0.1, 0.16 * i, 0}, {0.1, 0.16 * i + 0.3, 0}, 2)});
    const CurveSession made = session(mesh, many);
    std::vector<CurvePosture> postures(60);
    CHECK(gap(made.positions(postures), mesh.points) < 1e-11);
    postures[30].points = line({0.3, 4.8, 0}, {0.6, 5.1, 0}, 2);
    CHECK(made.positions(postures).allFinite());
    const CurveSession twice = session(mesh, {on_axis(), on_axis()});
    const std::vector<CurvePosture> both{{.points = arc(60, 5)}, {}};
    CHECK(twice.positions(both).allFinite());
}

TEST_CASE("what cannot be posed is refused by name") {
    const TriangleMesh mesh = bar(2);
    const auto with = [&](std::vector<CurveSpec> curves, std::vector<lissom::CurveLink> links = {}) { return refusal([&] { (void)session(mesh, curves, links); }); };
    CHECK(with({}) == "no-curve");
    CHECK(with({{.rest = Points(1, 3)}}) == "curve-points");
    CHECK(with({{.rest = Points::Zero(3, 3)}}) == "curve-without-length");
    CHECK(with({{.rest = axis(3), .rigid = {2}}}) == "rigid-span");
    CHECK(with({{.rest = axis(3), .region = std::vector<int>{99999}}}) == "vertex-out-of-range");
    CHECK(with({on_axis(), on_axis()}, {{0, 1, 0}, {1, 0, 0}}) == "link-ring");
    const CurveSession made = session(mesh, {on_axis()});
    const auto posed = [&](CurvePosture posture) { return refusal([&] { (void)made.positions({&posture, 1}); }); };
    CHECK(posed({.points = axis(3)}) == "posed-points");
    CHECK(posed({.points = axis(5), .twist = {1}}) == "curve-twist");
    CHECK(posed({.points = axis(5), .scale = {{1, 1}}}) == "curve-scale");
    CHECK(refusal([&] { (void)made.positions({}); }) == "curve-count");
}
