#include "lissom/deform/measure.h"

#include "lissom/mesh/errors.h"
#include "shapes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

using namespace lissom;

namespace {

Measures measure_map(const TriangleMesh& mesh, const Eigen::Affine3d& map) {
    return measure(shapes::working(mesh), shapes::moved(mesh, map).points);
}

const Eigen::Affine3d k_rigid = Eigen::Translation3d(1, 2, 3) * Eigen::AngleAxisd(2.5, Eigen::Vector3d(1, 1, 2).normalized());

} // namespace

TEST_CASE("a rigid motion changes no measure") {
    for (const TriangleMesh& mesh : {shapes::bar(), shapes::bumpy_sheet(), shapes::moebius(), shapes::two_spheres()}) {
        const Measures same = measure_map(mesh, k_rigid);
        CHECK(same.volume_ratio == doctest::Approx(1));
        CHECK(same.edge_rms < 1e-12);
        CHECK(same.worst_stretch == doctest::Approx(1));
        CHECK(same.flipped_triangles == 0);
        CHECK(same.vertex_stretch.size() == static_cast<std::size_t>(mesh.vertex_count()));
    }
}

TEST_CASE("doubling the size makes eight times the volume, open or closed") {
    for (const TriangleMesh& mesh : {shapes::bumpy_sphere(2), shapes::bumpy_sheet()}) {
        const Measures twice = measure_map(mesh, k_rigid * Eigen::Scaling(2.0));
        CHECK(twice.volume_ratio == doctest::Approx(8));
        CHECK(twice.edge_rms == doctest::Approx(1));
        CHECK(twice.worst_stretch == doctest::Approx(2));
        CHECK(twice.flipped_triangles == 0);
        for (const float s : twice.vertex_stretch)
            CHECK(s == doctest::Approx(1));
    }
}

TEST_CASE("the volume of a stretched box is its determinant's, wherever the box is") {
    const Eigen::Affine3d far(Eigen::Translation3d(1e5, -1e5, 1e5));
    const Eigen::Affine3d stretch = far * Eigen::Scaling(1.0, 0.25, 2.0) * far.inverse();
    const Measures squeezed = measure_map(shapes::moved(shapes::box(3, 3, 3), far), stretch);
    CHECK(squeezed.volume_ratio == doctest::Approx(0.5).epsilon(1e-6));
    CHECK(squeezed.worst_stretch == doctest::Approx(0.25).epsilon(1e-6)); // farther from 1 than 2 is, by its logarithm
}

TEST_CASE("a vertex pulled through the surface turns triangles over") {
    const TriangleMesh mesh = shapes::sheet(8, 8);
    const int middle = 4 * 9 + 4;
    Points positions = mesh.points;
    positions(middle, 0) += 2.5 / 8; // past two columns of neighbours
    CHECK(measure(shapes::working(mesh), positions).flipped_triangles > 0);
    positions(middle, 0) = mesh.points(middle, 0) + 0.5 / 8;
    CHECK(measure(shapes::working(mesh), positions).flipped_triangles == 0);
}

TEST_CASE("bending a bar by half a turn turns no triangle over") {
    const TriangleMesh mesh = shapes::box(4, 40, 4, {1, 10, 1});
    Points positions = mesh.points;
    for (int v = 0; v < mesh.vertex_count(); ++v) {
        const double angle = std::numbers::pi * mesh.points(v, 1) / 10, radius = 10 / std::numbers::pi - mesh.points(v, 0);
        positions.row(v) << -radius * std::cos(angle), radius * std::sin(angle), mesh.points(v, 2);
    }
    const Measures bent = measure(shapes::working(mesh), positions);
    CHECK(bent.flipped_triangles == 0);
    CHECK(bent.volume_ratio == doctest::Approx(1).epsilon(0.01));
}

TEST_CASE("copies of a vertex report one stretch, unused vertices none") {
    const TriangleMesh base = shapes::bumpy_sphere(1);
    const TriangleMesh apart = shapes::soup(base), more = shapes::with_unused_vertices(base, 2);
    Eigen::Affine3d map = k_rigid * Eigen::Scaling(1.0, 1.5, 0.7);
    const Measures whole = measure_map(base, map), copies = measure_map(apart, map);
    CHECK(copies.edge_rms == doctest::Approx(whole.edge_rms));
    for (int c = 0; c < apart.vertex_count(); ++c)
        CHECK(copies.vertex_stretch[c] == doctest::Approx(whole.vertex_stretch[base.triangles(c / 3, c % 3)]));
    Points positions = shapes::moved(more, map).points;
    const WorkingMesh working = shapes::working(more);
    for (int v = 0; v < more.vertex_count(); ++v)
        if (working.working_of_source[v] < 0)
            positions.row(v).setConstant(std::numeric_limits<double>::quiet_NaN()); // nobody looks there
    const Measures rest = measure(working, positions);
    CHECK(rest.vertex_stretch[0] == 0);
    CHECK(rest.edge_rms == doctest::Approx(whole.edge_rms));
}

TEST_CASE("degenerate triangles leave every measure finite") {
    for (const shapes::Broken& broken : shapes::eight_broken(shapes::bumpy_sphere(1))) {
        const Measures squeezed = measure_map(broken.mesh, k_rigid * Eigen::Scaling(1.0, 2.0, 1.0));
        CHECK(std::isfinite(squeezed.volume_ratio));
        CHECK(std::isfinite(squeezed.edge_rms));
        CHECK(std::isfinite(squeezed.worst_stretch));
        CHECK(std::all_of(squeezed.vertex_stretch.begin(), squeezed.vertex_stretch.end(),
                          [](float s) { return std::isfinite(s); }));
    }
}

TEST_CASE("an edit of another size or without numbers is refused") {
    const WorkingMesh working = shapes::working(shapes::box(2, 2, 2));
    Points positions = shapes::box(2, 2, 2).points;
    CHECK_THROWS_AS((void)measure(working, Points::Zero(3, 3)), InvalidInput);
    positions(0, 0) = std::numeric_limits<double>::infinity();
    CHECK_THROWS_AS((void)measure(working, positions), InvalidInput);
}
