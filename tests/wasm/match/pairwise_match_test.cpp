#include "lissom/match/pairwise_match.h"

#include "../refusal.h"
#include "armed.h"
#include "shapes.h"

#include "lissom/mesh/operators.h"
#include "lissom/mesh/triangle_tree.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <vector>

using namespace lissom;
using armed::figure;
using armed::some;

namespace {

struct Three {
    std::vector<TriangleMesh> meshes{figure(0, 3), figure(0.5, 3), figure(-0.5, 3)};
    std::vector<WorkingMesh> working;
    std::vector<MatchModel> models;

    explicit Three(int count = 3) {
        for (int k = 0; k < count; ++k) working.push_back(shapes::working(meshes[static_cast<std::size_t>(k)]));
        for (int k = 0; k < count; ++k) models.push_back({&working[static_cast<std::size_t>(k)], some(meshes[static_cast<std::size_t>(k)])});
    }
};

template <class Match>
MatchResult finished(Match match) {
    double before = 0;
    while (match.step()) {
        CHECK(match.fraction() >= before);
        before = match.fraction();
    }
    CHECK(match.fraction() == 1);
    return match.result();
}

bool has(const MatchReport& report, const std::string& code) {
    return std::any_of(report.warnings.begin(), report.warnings.end(), [&](const MatchWarning& warning) { return warning.code == code; });
}

/// Mean distance of a skin's vertices from the images of what they are on the source.
double apart(const MatchResult& result, const Three& three, int model) {
    const TriangleMesh& source = three.meshes.front();
    const TriangleMesh& target = three.meshes[static_cast<std::size_t>(model)];
    const TriangleTree tree(source);
    double sum = 0;
    for (int v = 0; v < result.skins.vertex_count(); ++v) {
        const auto at = tree.nearest(result.skins.points[0].row(v));
        Eigen::Matrix3d corners;
        for (int k = 0; k < 3; ++k) corners.col(k) = source.points.row(source.triangles(at.triangle, k)).transpose();
        const Eigen::Vector3d weights = corners.fullPivLu().solve(at.point);
        Eigen::RowVector3d image = Eigen::RowVector3d::Zero();
        for (int k = 0; k < 3; ++k) image += weights[k] * target.points.row(target.triangles(at.triangle, k));
        sum += (result.skins.points[static_cast<std::size_t>(model)].row(v) - image).norm();
    }
    return sum / result.skins.vertex_count() / diagonal(target.points);
}

} // namespace

TEST_CASE("three models matched in pairs: one connectivity, near to each, markers met, about as right as all at once") {
    const Three three;
    const MatchResult paired = finished(PairwiseMatch(three.models)), joint = finished(MatchSession(three.models));
    REQUIRE(paired.skins.count() == 3);
    for (int k = 0; k < 3; ++k) {
        CAPTURE(k);
        const SkinReport& skin = paired.report.skins[static_cast<std::size_t>(k)];
        CHECK(paired.skins.points[static_cast<std::size_t>(k)].rows() == paired.skins.vertex_count());
        CHECK(skin.distances.mean_there < 0.002);
        CHECK(skin.distances.mean_back < 0.003);
        CHECK(skin.crossings == 0);
        const Points places = some(three.meshes[static_cast<std::size_t>(k)]);
        for (Eigen::Index m = 0; m < places.rows(); ++m)
            CHECK((paired.skins.points[static_cast<std::size_t>(k)].row(paired.marker_vertices[static_cast<std::size_t>(m)]) - places.row(m)).norm() < 1e-9);
    }
    const double by_pairs = apart(paired, three, 2), at_once = apart(joint, three, 2);
    MESSAGE("third model, by pairs " << 100 * by_pairs << " %, at once " << 100 * at_once << " %");
    CHECK(by_pairs < 2 * at_once + 0.002);
}

TEST_CASE("two guarded projections undo what composing adds: nearer to the model, no farther from the truth, markers and connectivity as they were") {
    const Three three;
    PairwiseMatch match(three.models);
    bool all_composed = false;
    while (!all_composed && match.step()) all_composed = match.positions(2).rows() > 0 && match.fraction() > 0.95;
    REQUIRE(all_composed);
    const MatchResult before = match.result();
    CHECK(has(before.report, "stopped-early"));
    while (match.step()) {
    }
    const MatchResult after = match.result();
    CHECK_FALSE(has(after.report, "stopped-early"));
    CHECK(after.skins.triangles == before.skins.triangles);
    CHECK(after.skins.points[0] == before.skins.points[0]);
    CHECK(after.skins.points[1] == before.skins.points[1]);
    const SkinReport &composed = before.report.skins[2], &projected = after.report.skins[2];
    MESSAGE("third skin from its model " << composed.distances.mean_there << ", back " << composed.distances.mean_back << ", projected " << projected.distances.mean_there << ", " << projected.distances.mean_back
                                         << "; from the truth " << 100 * apart(before, three, 2) << " %, " << 100 * apart(after, three, 2) << " %");
    // The skin of its own pair is as near as a skin of so few vertices comes: what is above that is what composing added.
    const double alone = finished(MatchSession({three.models[0], three.models[2]})).report.skins[1].distances.mean_there;
    MESSAGE("in its own pair " << alone);
    REQUIRE(composed.distances.mean_there > alone);
    CHECK(projected.distances.mean_there - alone < 0.25 * (composed.distances.mean_there - alone));
    CHECK(projected.distances.mean_back < composed.distances.mean_back);
    CHECK(apart(after, three, 2) <= apart(before, three, 2) + 1e-5);
    CHECK(projected.crossings <= composed.crossings);
    CHECK(projected.folds <= composed.folds);
    for (const int v : after.marker_vertices) CHECK(after.skins.points[2].row(v) == before.skins.points[2].row(v));
}

TEST_CASE("sharp edges of the source and of the first target are kept, of the others it is told that they are lost; all at once none is") {
    std::vector<TriangleMesh> meshes(3, shapes::box(8, 8, 8));
    for (int k = 1; k < 3; ++k)
        for (auto p : meshes[static_cast<std::size_t>(k)].points.rowwise()) p += 0.15 * k * Eigen::RowVector3d(p.y(), p.z() * p.z(), -p.x());
    const int marked[] = {0, 8, 40, 60, 100, 150, 200, 250, 300, 350, 380};
    std::vector<WorkingMesh> working;
    for (const TriangleMesh& mesh : meshes) working.push_back(shapes::working(mesh));
    std::vector<MatchModel> models;
    for (std::size_t k = 0; k < 3; ++k) {
        Points places(std::ssize(marked), 3);
        for (Eigen::Index m = 0; m < places.rows(); ++m) places.row(m) = meshes[k].points.row(marked[m]);
        models.push_back({&working[k], places});
    }
    const MatchOptions options{.sharp_angle = 35};
    const MatchReport paired = finished(PairwiseMatch(models, options)).report, joint = finished(MatchSession(models, options)).report;
    for (const std::size_t k : {0u, 1u}) {
        CAPTURE(k);
        MESSAGE(paired.skins[k].sharp_curves << " curves, " << paired.skins[k].sharp_failed << " failed, off by " << 100 * paired.skins[k].sharp_error << " %");
        CHECK(paired.skins[k].sharp_curves == 12);
        CHECK(paired.skins[k].sharp_failed == 0);
        CHECK(paired.skins[k].sharp_error < 0.0005);
    }
    CHECK(paired.skins[2].sharp_curves == 0);
    REQUIRE(has(paired, "sharp-lost"));
    for (const MatchWarning& warning : paired.warnings)
        if (warning.code == "sharp-lost") {
            CHECK(warning.model == 2);
            CHECK(warning.count == 12);
        }
    CHECK_FALSE(has(joint, "sharp-lost"));
    CHECK(joint.skins[2].sharp_curves == 12);
    CHECK(joint.skins[2].sharp_failed == 0);
}

TEST_CASE("what is ignored stays ignored: the mask of a third model draws nothing, and what comes from the source's is left to its pair") {
    // A cap over one arm that only the third figure has.
    Three three;
    std::vector<int> cap;
    for (int v = 0; v < three.meshes[2].vertex_count(); ++v)
        if (three.meshes[0].points.row(v).normalized().dot(Eigen::RowVector3d(-0.3, 0.1, -1).normalized()) > 0.9) cap.push_back(v);
    REQUIRE(cap.size() > 5);
    three.models[2].ignored = cap;
    const MatchResult target = finished(PairwiseMatch(three.models));
    CHECK(target.report.skins[2].distances.mean_there < 0.002);
    three.models[2].ignored.clear();
    three.models[0].ignored = cap;
    PairwiseMatch match(three.models);
    while (match.step() && !(match.positions(2).rows() > 0 && match.fraction() > 0.95)) {
    }
    const MatchResult before = match.result();
    while (match.step()) {
    }
    const Points after = match.positions(2);
    const TriangleTree tree(three.meshes[0]);
    std::vector<char> capped(static_cast<std::size_t>(three.meshes[0].vertex_count()), 0);
    for (const int v : cap) capped[static_cast<std::size_t>(v)] = 1;
    int held = 0, moved = 0;
    for (int v = 0; v < before.skins.vertex_count(); ++v) {
        const auto at = tree.nearest(before.skins.points[0].row(v));
        const auto corners = three.meshes[0].triangles.row(at.triangle);
        if (std::all_of(corners.begin(), corners.end(), [&](int w) { return capped[static_cast<std::size_t>(w)]; })) {
            ++held;
            CHECK(after.row(v) == before.skins.points[2].row(v));
        } else moved += after.row(v) != before.skins.points[2].row(v);
    }
    CHECK(held > 5);
    CHECK(moved > held);
}

TEST_CASE("two models are the one pair, exactly") {
    const Three two(2);
    const MatchResult paired = finished(PairwiseMatch(two.models)), joint = finished(MatchSession(two.models));
    CHECK(paired.skins.triangles == joint.skins.triangles);
    CHECK(paired.skins.points[1] == joint.skins.points[1]);
    CHECK(paired.report.warnings.size() == joint.report.warnings.size());
}

TEST_CASE("it may be looked at on the way, and has a result only once all pairs are matched") {
    const Three three;
    PairwiseMatch match(three.models);
    CHECK(refusal([&] { (void)match.result(); }) == "not-begun");
    bool second_seen = false;
    while (match.step()) {
        const int vertices = match.triangles().size() > 0 ? match.triangles().maxCoeff() + 1 : 0;
        for (int k = 0; k < 3; ++k) {
            const Eigen::Index rows = match.positions(k).rows();
            CHECK((rows == 0 || rows >= vertices));
        }
        second_seen = second_seen || match.positions(2).rows() > 0;
    }
    CHECK(second_seen);
    CHECK(match.result().skins.count() == 3);
}

TEST_CASE("what a session refuses is refused") {
    const Three three;
    CHECK(refusal([&] { PairwiseMatch match({three.models.front()}); }) == "model-count");
    CHECK(refusal([&] { PairwiseMatch match(three.models, {.levels = 9}); }) == "bad-option");
    // Before any pair is matched, though it is the last model that is wrong.
    Three wrong;
    wrong.models[2].ignored = {99999};
    CHECK(refusal([&] { PairwiseMatch match(wrong.models); }) == "bad-mask");
    wrong.models[2].ignored.clear();
    wrong.models[2].markers.conservativeResize(5, 3);
    CHECK(refusal([&] { PairwiseMatch match(wrong.models); }) == "marker-count");
}
