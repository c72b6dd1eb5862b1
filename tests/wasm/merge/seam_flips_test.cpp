#include "lissom/merge/seam_flips.h"

#include "lissom/merge/seam.h"
#include "lissom/mesh/operators.h"
#include "tubes.h"

#include <doctest/doctest.h>

#include <set>

using namespace lissom;

namespace {

std::set<std::pair<int, int>> edges_of(const TriangleMesh& mesh) {
    std::set<std::pair<int, int>> out;
    for (int t = 0; t < mesh.triangle_count(); ++t)
        for (int c = 0; c < 3; ++c) out.emplace(mesh.triangles(t, c), mesh.triangles(t, (c + 1) % 3));
    return out;
}

} // namespace

TEST_CASE("flips make the thinnest triangle wider, and thin ones are there to begin with") {
    bool improved = false;
    for (const auto& [n, m] : {std::pair{20, 31}, {24, 90}, {90, 24}, {12, 120}}) {
        CAPTURE(n);
        tubes::Stitched s = tubes::stitched(n, m);
        const double before = seam_figures(s.joined).least_angle;
        flip_thin_triangles(s.joined, s.target, s.source);
        const double after = seam_figures(s.joined).least_angle;
        CHECK(after >= before - 1e-9);
        improved = improved || after > before + 0.5;
    }
    CHECK(improved);
}

TEST_CASE("the surface stays closed, its vertices where they were, its seam in place") {
    for (const auto& [n, m] : {std::pair{24, 90}, {90, 24}}) {
        tubes::Stitched s = tubes::stitched(n, m);
        const JoinedMesh before = s.joined;
        flip_thin_triangles(s.joined, s.target, s.source);
        tubes::check_closed(s.joined.mesh, 2);
        CHECK(s.joined.mesh.points == before.mesh.points);
        CHECK(s.joined.from_source == before.from_source);
        const auto edges = edges_of(s.joined.mesh);
        const std::vector<int>& seam = s.joined.seams[0];
        for (std::size_t k = 0; k < seam.size(); ++k) CHECK(edges.contains({seam[k], seam[(k + 1) % seam.size()]}));
        CHECK(triangle_areas(s.joined.mesh).sum() == doctest::Approx(triangle_areas(before.mesh).sum()).epsilon(0.01));
    }
}

TEST_CASE("a triangle that was flipped is new, and its corners know where they lie") {
    tubes::Stitched s = tubes::stitched(24, 90);
    const Triangles before = s.joined.mesh.triangles;
    flip_thin_triangles(s.joined, s.target, s.source);
    for (int t = 0; t < s.joined.mesh.triangle_count(); ++t) {
        if (s.joined.mesh.triangles.row(t) == before.row(t)) continue;
        CHECK(s.joined.is_new[t]);
        REQUIRE(s.joined.made[t] >= 0);
        if (s.joined.from_source[t]) continue;
        for (int c = 0; c < 3; ++c) {
            const Origin& origin = s.joined.made_corners[s.joined.made[t]][static_cast<std::size_t>(c)];
            Eigen::RowVector3d place = Eigen::RowVector3d::Zero();
            for (std::size_t k = 0; k < 3; ++k) place += origin.weight[k] * s.target.mesh.points.row(origin.vertex[k]);
            CHECK((place - s.joined.mesh.points.row(s.joined.mesh.triangles(t, c))).norm() < 1e-12);
        }
    }
}

TEST_CASE("where no triangle is thin nothing is flipped") {
    tubes::Stitched s = tubes::stitched(24, 24);
    const Triangles before = s.joined.mesh.triangles;
    REQUIRE(seam_figures(s.joined).least_angle > 8);
    flip_thin_triangles(s.joined, s.target, s.source);
    CHECK(s.joined.mesh.triangles == before);
}
