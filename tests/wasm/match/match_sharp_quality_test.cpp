// Sharp edges of real parts on skins that are shared with others; each figure is printed.

#include "../isoline/figures.h"
#include "pairs.h"
#include "ring_markers.h"
#include "shapes.h"

#include <doctest/doctest.h>

#include <cmath>
#include <string>

using Eigen::RowVector3d;
using figures::shared;
using lissom::Points;
using lissom::TriangleMesh;

namespace {

std::string sharp_figures(const lissom::MatchReport& report) {
    std::string line;
    for (const lissom::SkinReport& skin : report.skins)
        line += "; " + std::to_string(skin.sharp_curves) + " curves, " + std::to_string(skin.sharp_failed) + " failed, off by " + std::to_string(100 * skin.sharp_error) + " %, crossings " + std::to_string(skin.crossings);
    return line + "; sharp stage " + std::to_string(report.seconds.sharp) + " s";
}

void check_sharp(const lissom::MatchReport& report) {
    for (const lissom::SkinReport& skin : report.skins) {
        CHECK(skin.sharp_failed == 0);
        CHECK(skin.sharp_error < 0.0005);
        CHECK(skin.crossings == 0);
    }
    CHECK(report.marker_error < 1e-12);
}

} // namespace

TEST_CASE("a ring becomes a nut and a nut a ring: every sharp edge on edges of the skin within 0.05 %") {
    const TriangleMesh torus = shared("generated/out/torus"), nut = shared("generated/out/nut");
    if (torus.vertex_count() == 0 || nut.vertex_count() == 0) return;
    const Points round = rings::on_torus(torus), hexagonal = rings::on_nut(nut);
    for (const bool back : {false, true}) {
        const pairs::Matched matched = back ? pairs::run(nut, torus, hexagonal, round, {.sharp_angle = 35}) : pairs::run(torus, nut, round, hexagonal, {.sharp_angle = 35});
        MESSAGE((back ? "nut -> torus: " : "torus -> nut: ") << pairs::figures(matched) << sharp_figures(matched.result.report));
        check_sharp(matched.result.report);
        CHECK(matched.result.report.skins[1].distances.mean_there < 2e-4);
        CHECK(matched.result.report.skins[1].distances.mean_back < 2e-4);
    }
}

TEST_CASE("parts and what a designer makes of them: all sharp edges of both on edges of one connectivity") {
    for (const char* name : {"generated/out/bracket", "generated/out/gear"}) {
        const TriangleMesh part = shared(name);
        if (part.vertex_count() == 0) continue;
        TriangleMesh other = part;
        for (int v = 0; v < other.vertex_count(); ++v) {
            const RowVector3d p = part.points.row(v);
            other.points.row(v) << 1.1 * p.x() + 0.1 * p.y(), 1.3 * p.y(), 0.9 * p.z() + 0.05 * p.x() * p.x();
        }
        std::vector<int> marked;
        for (int k = 0; k < 24; ++k) marked.push_back(k * (part.vertex_count() / 24));
        const pairs::Matched matched = pairs::run(part, other, pairs::places(part, marked), pairs::places(other, marked), {.sharp_angle = 35});
        MESSAGE(std::string(name) << ": " << pairs::figures(matched) << sharp_figures(matched.result.report));
        check_sharp(matched.result.report);
    }
}
