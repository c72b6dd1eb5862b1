#include "lissom/merge/seam.h"

#include "tubes.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>

#include <set>

using namespace lissom;

namespace {

/// Two squares of two triangles each that meet in an edge at an angle; the seam is that edge.
JoinedMesh book(double degrees) {
    JoinedMesh joined;
    const double a = degrees * 3.14159265358979323846 / 180;
    joined.mesh.points.resize(6, 3);
    joined.mesh.points << -1, 0, 0, -1, 1, 0, 0, 0, 0, 0, 1, 0, std::cos(a), 0, std::sin(a), std::cos(a), 1, std::sin(a);
    joined.mesh.triangles.resize(4, 3);
    joined.mesh.triangles << 0, 2, 3, 0, 3, 1, 2, 4, 5, 2, 5, 3;
    joined.from_source = {0, 0, 1, 1};
    joined.is_new = {0, 0, 1, 1};
    joined.seams = {{2, 3}};
    return joined;
}

} // namespace

TEST_CASE("the angle across a seam is that between its two sides") {
    for (const double degrees : {0.0, 30.0, 90.0}) {
        const SeamFigures figures = seam_figures(book(degrees));
        CHECK(figures.vertices == 2);
        CHECK(figures.median_dihedral == doctest::Approx(degrees));
        CHECK(figures.max_dihedral == doctest::Approx(degrees));
        CHECK(figures.own_high_dihedral < 1e-9);
        CHECK(figures.least_angle == doctest::Approx(45)); // of the triangles that are new
    }
}

TEST_CASE("without a seam there is nothing to measure") {
    JoinedMesh joined = book(40);
    joined.seams.clear();
    joined.from_source = joined.is_new = {0, 0, 0, 0};
    const SeamFigures figures = seam_figures(joined);
    CHECK(figures.vertices == 0);
    CHECK(figures.max_dihedral == 0);
    CHECK(figures.own_high_dihedral == doctest::Approx(40));
    CHECK(figures.least_angle == 180);
}

TEST_CASE("figures are angles: neither pose nor unit matters") {
    tubes::Stitched s = tubes::stitched(20, 31);
    const SeamFigures here = seam_figures(s.joined);
    CHECK(here.vertices == static_cast<int>(s.joined.seams[0].size()));
    CHECK(here.median_dihedral <= here.high_dihedral);
    CHECK(here.high_dihedral <= here.max_dihedral);
    s.joined.mesh = shapes::moved(s.joined.mesh, Eigen::Affine3d(Eigen::Translation3d(1, 2, 3) * Eigen::AngleAxisd(1, Eigen::Vector3d::UnitX()) * Eigen::Scaling(1e-3)));
    const SeamFigures there = seam_figures(s.joined);
    CHECK(there.median_dihedral == doctest::Approx(here.median_dihedral).epsilon(1e-6));
    CHECK(there.max_dihedral == doctest::Approx(here.max_dihedral).epsilon(1e-6));
    CHECK(there.least_angle == doctest::Approx(here.least_angle).epsilon(1e-6));
}

TEST_CASE("smoothing moves the seam's vertices and no others, and makes a jagged one flatter") {
    tubes::Stitched s = tubes::stitched(24, 30);
    for (std::size_t k = 0; k < s.joined.seams[0].size(); ++k) s.joined.mesh.points.row(s.joined.seams[0][k]) *= k % 2 ? 1.06 : 0.94;
    const JoinedMesh before = s.joined;
    smooth_seam(s.joined, 0);
    CHECK(s.joined.mesh.points == before.mesh.points);
    smooth_seam(s.joined, 4);
    const std::set<int> seam(before.seams[0].begin(), before.seams[0].end());
    int moved = 0;
    for (int v = 0; v < before.mesh.vertex_count(); ++v) {
        const bool same = s.joined.mesh.points.row(v) == before.mesh.points.row(v);
        moved += !same;
        if (!seam.contains(v)) CHECK(same);
    }
    CHECK(moved > 20);
    CHECK(seam_figures(s.joined).median_dihedral < seam_figures(before).median_dihedral);
}

TEST_CASE("a flat surface stays flat when its seam is smoothed") {
    JoinedMesh flat = book(0);
    smooth_seam(flat, 3);
    CHECK(flat.mesh.points.col(2).norm() < 1e-15);
}
