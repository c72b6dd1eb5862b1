#include "lissom/wear/skin_pose.h"

#include "../isoline/figures.h"
#include "refusal.h"
#include "shapes.h"

#include "lissom/mesh/operators.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <string>

using Eigen::Affine3d;
using Eigen::AngleAxisd;
using Eigen::Matrix3d;
using Eigen::Scaling;
using Eigen::Translation3d;
using Eigen::Vector3d;
using lissom::Points;
using lissom::SkinPose;
using lissom::SkinPoseOptions;
using lissom::TriangleMesh;
using lissom::WorkingMesh;

namespace {

/// Two models and their skins.
struct Pair {
    WorkingMesh source, target;
    TriangleMesh from, to;
};

SkinPose ready(const Pair& pair) {
    SkinPose session(pair.source, pair.target, pair.from.triangles, pair.from.points, pair.to.points);
    while (session.step()) CHECK(session.fraction() <= 1);
    CHECK(session.fraction() == 1);
    return session;
}
Points given(const Pair& pair, const Points& pose, const SkinPoseOptions& options = {}) { return ready(pair).give(pose, options); }

Points applied(const Affine3d& map, const Points& points) { return (points * map.linear().transpose()).rowwise() + map.translation().transpose(); }
double farthest(const Points& a, const Points& b) { return (a - b).rowwise().norm().maxCoeff(); }

/// A bar bent around z: by `turns` radians a unit of y, from y = 1 on.
Points bent(const Points& points, double turns = 0.3) {
    Points moved = points;
    for (Eigen::Index v = 0; v < points.rows(); ++v) {
        const double along = points(v, 1) - 1, angle = turns * along, r = 1 / turns - points(v, 0);
        if (along > 0) moved.row(v) << 1 / turns - r * std::cos(angle), 1 + r * std::sin(angle), points(v, 2);
    }
    return moved;
}

Points stout(const Points& points) {
    Points moved = points;
    for (Eigen::Index v = 0; v < points.rows(); ++v) moved.row(v) << points(v, 0) * (1.3 + 0.1 * std::sin(points(v, 1))), 1.1 * points(v, 1), 1.5 * points(v, 2);
    return moved;
}

/// Bars cut in different ways, and skins cut in a third.
Pair bars() {
    const TriangleMesh skin = shapes::box(6, 30, 6, {1, 6, 1});
    return {shapes::working(shapes::box(8, 48, 8, {1, 6, 1})), shapes::working({stout(shapes::box(5, 40, 5, {1, 6, 1}).points), shapes::box(5, 40, 5, {1, 6, 1}).triangles}), skin,
            {stout(skin.points), skin.triangles}};
}

} // namespace

TEST_CASE("a model at rest leaves the other at rest, and so does a pose of no strength") {
    const Pair pair = bars();
    for (const bool keep_stretch : {false, true}) {
        CHECK(farthest(given(pair, pair.source.source, {.keep_stretch = keep_stretch}), pair.target.source) < 1e-9);
        CHECK(farthest(given(pair, bent(pair.source.source), {.strength = 0, .keep_stretch = keep_stretch}), pair.target.source) < 1e-9);
    }
}

TEST_CASE("a model that is moved as a whole moves the other by the same turn, as far in its own size") {
    const Pair pair = bars();
    const Affine3d motion(Translation3d(2, -1, 4) * AngleAxisd(2.1, Vector3d(1, 3, -2).normalized()));
    for (const bool keep_stretch : {false, true}) {
        const Points moved = given(pair, applied(motion, pair.source.source), {.keep_stretch = keep_stretch});
        const Points turned = pair.target.source * motion.linear().transpose();
        CHECK(farthest(moved.rowwise() - moved.colwise().mean(), turned.rowwise() - turned.colwise().mean()) < 1e-9);
        Pair small = pair;
        small.target = shapes::working({0.1 * pair.target.source, pair.target.mesh.triangles});
        small.to.points *= 0.1;
        CHECK(farthest(given(small, applied(motion, pair.source.source), {.keep_stretch = keep_stretch}), 0.1 * moved) < 1e-9);
    }
}

TEST_CASE("a model that is matched with itself has the pose that it has") {
    const TriangleMesh rest = shapes::box(8, 48, 8, {1, 6, 1});
    const Pair same{shapes::working(rest), shapes::working(rest), rest, rest};
    const Points pose = bent(rest.points);
    CHECK(farthest(given(same, pose, {.keep_stretch = true}), pose) < 1e-8);
    const double plain = farthest(given(same, pose), pose);
    MESSAGE("triangles that only turn: off by " << plain << " of a length of 6");
    CHECK(plain < 0.06);
    // Through a skin that is cut otherwise.
    const TriangleMesh skin = shapes::box(6, 60, 6, {1, 6, 1});
    const Pair resampled{shapes::working(rest), shapes::working(rest), skin, skin};
    const double through = farthest(given(resampled, pose, {.keep_stretch = true}), pose);
    MESSAGE("through another skin: off by " << through);
    CHECK(through < 0.06);
}

TEST_CASE("a pose of the skin itself is taken exactly") {
    const Pair pair = bars();
    const Pair skins{shapes::working(pair.from), shapes::working(pair.to), pair.from, pair.to};
    const Points pose = bent(pair.from.points), on_skin = given(skins, pose);
    const Pair mixed{shapes::working(pair.from), pair.target, pair.from, pair.to};
    CHECK(given(mixed, pose).allFinite());
    // The bar bends as far: its end looks where the other's end looks.
    const auto facing = [](const Points& points, const Points& rest) {
        Eigen::RowVector3d left = Eigen::RowVector3d::Zero(), right = left;
        const double top = rest.col(1).maxCoeff(), side = rest.col(0).maxCoeff() / 2;
        for (Eigen::Index v = 0; v < points.rows(); ++v)
            if (rest(v, 1) > top - 1e-6 && std::abs(rest(v, 0)) > side) (rest(v, 0) < 0 ? left : right) += points.row(v);
        return (right - left).normalized().eval();
    };
    CHECK(std::acos(facing(on_skin, pair.to.points).dot(facing(pose, pair.from.points))) < 0.05);
}

TEST_CASE("strength is how far it turns, and stretch is kept where it is asked for") {
    const Pair pair = bars();
    const Points pose = bent(pair.source.source);
    const auto lean = [&](const Points& points) { return points.col(0).maxCoeff() - pair.target.source.col(0).maxCoeff(); };
    const double half = lean(given(pair, pose, {.strength = 0.5})), whole = lean(given(pair, pose)), more = lean(given(pair, pose, {.strength = 1.2}));
    CHECK(half > 0.3 * whole);
    CHECK(half < 0.8 * whole);
    CHECK(more > whole);
    Points longer = pair.source.source;
    longer.col(1) *= 1.5;
    const auto length = [](const Points& points) { return points.col(1).maxCoeff() - points.col(1).minCoeff(); };
    CHECK(length(given(pair, longer, {.keep_stretch = true})) == doctest::Approx(1.5 * length(pair.target.source)).epsilon(0.01));
    CHECK(length(given(pair, longer, {.strength = 0.5, .keep_stretch = true})) == doctest::Approx(1.25 * length(pair.target.source)).epsilon(0.01));
    CHECK(length(given(pair, longer)) == doctest::Approx(length(pair.target.source)).epsilon(0.01));
}

TEST_CASE("moved, turned and in another unit a pose is given alike") {
    const Pair pair = bars();
    const Points pose = bent(pair.source.source);
    for (const bool keep_stretch : {false, true}) {
        const Points plain = given(pair, pose, {.keep_stretch = keep_stretch});
        for (const double size : {1e-4, 1e5}) {
            // Both in another space; then each in a unit of its own.
            const Affine3d space(Translation3d(size, -7 * size, 0) * AngleAxisd(1.9, Vector3d(2, 1, 1).normalized()) * Scaling(size));
            const auto there = [](const Affine3d& map, const WorkingMesh& mesh) { return shapes::working(shapes::moved({mesh.source, mesh.display}, map)); };
            const Pair both{there(space, pair.source), there(space, pair.target), shapes::moved(pair.from, space), shapes::moved(pair.to, space)};
            CHECK(farthest(given(both, applied(space, pose), {.keep_stretch = keep_stretch}), applied(space, plain)) < 1e-6 * size);
            const Affine3d unit(Scaling(size));
            const Pair one{pair.source, there(unit, pair.target), pair.from, shapes::moved(pair.to, unit)};
            CHECK(farthest(given(one, pose, {.keep_stretch = keep_stretch}), size * plain) < 1e-6 * size);
        }
    }
}

TEST_CASE("a model that stands another way up gets the pose in its own space") {
    const Pair pair = bars();
    const Affine3d up(AngleAxisd(std::acos(0.0), Vector3d::UnitX()));
    const Pair other{pair.source, shapes::working(shapes::moved({pair.target.source, pair.target.display}, up)), pair.from, shapes::moved(pair.to, up)};
    const Points pose = bent(pair.source.source);
    // But for how well a skin says which way it is up: these are of other builds.
    CHECK(farthest(given(other, pose), applied(up, given(pair, pose))) < 0.3);
}

TEST_CASE("a soup keeps together, stray vertices go along, those without a place stay, parts are placed one by one") {
    Pair pair = bars();
    const Points pose = bent(pair.source.source);
    const TriangleMesh whole{pair.target.source, pair.target.display}, torn = shapes::soup(whole);
    const Points together = given(pair, pose);
    pair.target = shapes::working(torn);
    const Points apart = given(pair, pose);
    for (int t = 0; t < whole.triangle_count(); t += 11)
        for (int k = 0; k < 3; ++k) CHECK((apart.row(torn.triangles(t, k)) - together.row(whole.triangles(t, k))).norm() < 1e-9);
    pair.target = shapes::working(shapes::with_unused_vertices(whole, 2));
    CHECK(given(pair, pose).allFinite());
    pair.target = shapes::working(shapes::with_nan_vertex(whole, 5));
    const Points gap = given(pair, pose);
    CHECK(!gap.row(5).allFinite());
    CHECK(farthest(gap.bottomRows(gap.rows() - 6), together.bottomRows(gap.rows() - 6)) < 1e-9);

    const TriangleMesh two = shapes::two_spheres();
    const Pair pieces{shapes::working(two), shapes::working(two), two, two};
    Points drifted = two.points;
    for (Eigen::Index v = 0; v < drifted.rows() / 2; ++v) drifted(v, 2) += 3;
    CHECK(farthest(given(pieces, drifted), drifted) < 1e-9);
}

TEST_CASE("what cannot be is refused") {
    const Pair pair = bars();
    const auto made = [&](const lissom::Triangles& triangles, const Points& from, const Points& to) { return refusal([&] { SkinPose(pair.source, pair.target, triangles, from, to); }); };
    const Points &from = pair.from.points, &to = pair.to.points;
    CHECK(made(pair.from.triangles, from, to.topRows(9)) == "wrong-size");
    CHECK(made(pair.from.triangles, from.topRows(9), to.topRows(9)) == "vertex-out-of-range");
    Points lost = to;
    lost(4, 1) = std::numeric_limits<double>::quiet_NaN();
    CHECK(made(pair.from.triangles, from, lost) == "non-finite-position");
    CHECK(made(pair.from.triangles, Points::Zero(from.rows(), 3), to) == "flat-skin");
    SkinPose session = ready(pair);
    Points pose = pair.source.source;
    CHECK(refusal([&] { (void)session.give(pose.topRows(3)); }) == "wrong-size");
    CHECK(refusal([&] { (void)session.give(pose, {.strength = std::numeric_limits<double>::quiet_NaN()}); }) == "bad-option");
    pose(7, 0) = std::numeric_limits<double>::infinity();
    CHECK(refusal([&] { (void)session.give(pose); }) == "non-finite-position");
}

TEST_CASE("poses of people fit other people through their skins") {
    for (const auto& [rest, pose_of, onto] : figures::poses_of_people()) {
        const TriangleMesh source = figures::shared(rest), pose = figures::shared(pose_of), target = figures::shared(onto);
        if (source.vertex_count() == 0 || pose.vertex_count() == 0 || target.vertex_count() == 0) return;
        const Pair there{shapes::working(source), shapes::working(target), source, target}, back{there.target, there.source, target, source}, same{there.source, there.source, source, source};
        for (const bool keep_stretch : {false, true}) {
            SkinPose session = ready(there);
            const Points result = session.give(pose.points, {.keep_stretch = keep_stretch});
            const auto apart = [&](const Points& points) { return 100 * (points - pose.points).rowwise().norm().mean(); };
            const double returned = apart(given(back, result, {.keep_stretch = keep_stretch})), own = apart(given(same, pose.points, {.keep_stretch = keep_stretch}));
            const double volume = lissom::signed_volume({result, target.triangles}) / lissom::signed_volume(target), truth = lissom::signed_volume(pose) / lissom::signed_volume(source);
            const double stretch = figures::stretch_rms(target, result), source_stretch = figures::stretch_rms(source, pose.points);
            MESSAGE(pose_of << " on " << onto << std::string(keep_stretch ? ", stretch kept" : "") << ": and back " << returned << " cm, on itself " << own << " cm (at rest " << apart(source.points) << "), volume " << volume
                            << " (the pose's " << truth << "), stretch " << stretch << " (the pose's " << source_stretch << "), lowest " << 100 * (result.col(1).minCoeff() - target.points.col(1).minCoeff())
                            << " cm (the pose's " << 100 * (pose.points.col(1).minCoeff() - source.points.col(1).minCoeff()) << "), prepared in " << session.seconds().prepare << " s, given in " << session.seconds().solve << " s");
            CHECK(returned < 1.5);
            CHECK(own < (keep_stretch ? 1e-6 : 1.5));
            // Who stood on the ground stands there.
            CHECK(std::abs(result.col(1).minCoeff() - target.points.col(1).minCoeff()) < 0.015);
            CHECK(volume == doctest::Approx(truth).epsilon(0.05));
        }
    }
}
