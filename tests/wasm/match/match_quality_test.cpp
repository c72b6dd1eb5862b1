// How good matches are on real pairs of which the truth is known; each figure is printed.

#include "../isoline/figures.h"
#include "pairs.h"
#include "shapes.h"

#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

using figures::shared;
using lissom::Points;
using lissom::TriangleMesh;

namespace {

/// A ball with relief of many sizes, of as many vertices as a scan: 163,842.
TriangleMesh scan() {
    TriangleMesh mesh = shapes::icosphere(7);
    for (int v = 0; v < mesh.vertex_count(); ++v) {
        const Eigen::RowVector3d d = mesh.points.row(v).normalized();
        double relief = 0, height = 0.16;
        for (double wave = 2; wave < 40; wave *= 1.7, height *= 0.52)
            relief += height * std::sin(wave * d.x() + 1.3 * wave) * std::sin(wave * d.y() + 0.4 * wave) * std::cos(wave * d.z() + 2.1 * wave);
        mesh.points.row(v) = (1 + relief) * Eigen::RowVector3d(0.8 * d.x(), 1.1 * d.y(), 0.9 * d.z());
    }
    return mesh;
}

} // namespace

TEST_CASE("a calf becomes a cow by thirteen markers") {
    const TriangleMesh calf = shared("registry/spot_pp3d"), cow = shared("creatures/cow");
    if (calf.vertex_count() == 0 || cow.vertex_count() == 0) return;
    Points from(13, 3), to(13, 3); // the calf looks to −z, the cow to +z
    from << 0, 0.30, -0.65, /* nose */ 0.192, 0.949, -0.288, -0.192, 0.949, -0.288, /* horns */ 0.432, 0.746, -0.258, -0.432, 0.746, -0.258, /* ears */
        0.289, -0.705, -0.033, -0.289, -0.705, -0.033, 0.201, -0.687, 0.899, -0.201, -0.687, 0.899, /* feet */ 0, -0.081, 1.049, /* tail */
        0, 0.284, 0.357, /* back */ 0, -0.534, 0.416, /* belly */ 0, 0.801, -0.415; /* crown */
    to << 0, 1.11, 1.46, -0.296, 1.675, 1.028, 0.296, 1.675, 1.028, -0.143, 1.516, 0.934, 0.143, 1.516, 0.934, -0.205, 0.007, 0.831, 0.205, 0.007, 0.831, -0.206, 0.002, -0.733, 0.206, 0.002,
        -0.733, 0, 0.246, -1.27, 0, 1.274, 0.038, 0, 0.623, -0.031, 0, 1.449, 1.025;
    const pairs::Matched matched = pairs::run(calf, cow, from, to);
    MESSAGE("calf -> cow: " << pairs::figures(matched));
    const lissom::MatchReport& report = matched.result.report;
    CHECK(report.skins[1].distances.mean_there < 0.0008);
    CHECK(report.skins[1].distances.mean_back < 0.0008);
    CHECK(report.skins[1].distances.most < 0.01);
    CHECK(report.marker_error < 1e-12);
    CHECK(report.skins[1].crossings == 0);
}

TEST_CASE("a face becomes another: what corresponds lies within 1.4 % in the mean") {
    const TriangleMesh source = shared("pairs/head_female_remesh"), target = shared("pairs/head_troll_remesh"), from = shared("human/head_female"), to = shared("human/head_troll");
    const auto marks = pairs::landmarks("human/head_regions");
    if (source.vertex_count() == 0 || target.vertex_count() == 0 || from.vertex_count() == 0 || to.vertex_count() == 0 || marks.empty()) return;
    std::vector<int> vertices;
    for (const auto& [name, v] : marks) vertices.push_back(v);
    for (const bool connectivity : {true, false}) {
        const pairs::Matched matched = pairs::run(source, target, pairs::places(from, vertices), pairs::places(to, vertices), {.connectivity = connectivity});
        const pairs::Error error = pairs::error(matched.result.skins, from, to);
        MESSAGE("head, female -> troll, " << vertices.size() << " markers" << std::string(connectivity ? ": " : ", edges as they are: ") << 100 * error.mean << " % (most " << 100 * error.most
                                          << " %), " << pairs::figures(matched));
        CHECK(error.mean < 0.014);
        CHECK(matched.result.report.skins[1].distances.mean_there < 0.0005);
        CHECK(matched.result.report.skins[1].distances.mean_back < 0.0005);
        CHECK(matched.result.report.marker_error < 1e-12);
        CHECK(matched.result.report.skins[1].crossings == 0);
    }
}

TEST_CASE("a body becomes another: what corresponds lies within 1 % in the mean") {
    const TriangleMesh source = shared("pairs/body_female_remesh"), target = shared("pairs/body_heavy_remesh"), from = shared("human/body_female"), to = shared("human/body_heavy");
    const auto marks = pairs::landmarks("human/body_regions");
    if (source.vertex_count() == 0 || target.vertex_count() == 0 || from.vertex_count() == 0 || to.vertex_count() == 0 || marks.empty()) return;
    std::vector<int> vertices;
    for (const std::string name : {"crown", "nose_tip", "chin", "nape", "navel", "crotch"}) vertices.push_back(marks.at(name));
    for (const std::string name : {"finger3", "toe3", "heel", "knee", "elbow", "shoulder", "hip"})
        for (const std::string side : {"_l", "_r"}) vertices.push_back(marks.at(name + side));
    REQUIRE(vertices.size() == 20);
    for (const bool connectivity : {true, false}) {
        const pairs::Matched matched = pairs::run(source, target, pairs::places(from, vertices), pairs::places(to, vertices), {.connectivity = connectivity});
        const pairs::Error error = pairs::error(matched.result.skins, from, to);
        MESSAGE("body, female -> heavy, 20 markers" << std::string(connectivity ? ": " : ", edges as they are: ") << 100 * error.mean << " % (most " << 100 * error.most << " %), "
                                                    << pairs::figures(matched));
        CHECK(error.mean < 0.01);
        CHECK(matched.result.report.skins[1].distances.mean_there < 0.0005);
        CHECK(matched.result.report.skins[1].distances.mean_back < 0.0005);
        CHECK(matched.result.report.skins[1].distances.most < 0.003);
        CHECK(matched.result.report.marker_error < 1e-12);
        CHECK(matched.result.report.skins[1].crossings == 0);
    }
}

TEST_CASE("a ball of ten thousand vertices becomes a scan of more than a hundred thousand without markers") {
    const TriangleMesh ball = shapes::icosphere(5);
    REQUIRE(ball.vertex_count() == 10242);
    const pairs::Matched matched = pairs::run(ball, scan(), Points(0, 3), Points(0, 3), {.connectivity = false});
    MESSAGE("ball -> scan: " << pairs::figures(matched));
    const lissom::MatchReport& report = matched.result.report;
    CHECK(report.skins[1].distances.mean_there < 0.0005);
    CHECK(report.skins[1].distances.mean_back < 0.0005);
    CHECK(report.skins[1].distances.most < 0.003);
    CHECK(report.skins[1].crossings == 0);
}
