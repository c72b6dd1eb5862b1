#include "lissom/match/pairwise_match.h"

#include "../refusal.h"
#include "armed.h"
#include "shapes.h"

#include "lissom/mesh/operators.h"
#include "lissom/mesh/triangle_tree.h"

#include <doctest/doctest.h>

#include <algorithm>
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
}
