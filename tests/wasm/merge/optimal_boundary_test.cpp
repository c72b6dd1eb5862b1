// Optimal boundaries (Fu 3.4): energies that only fall, and what a merge gains by them.

#include "lissom/merge/optimal_boundary.h"

#include "tubes.h"

#include "lissom/mesh/operators.h"
#include "lissom/mesh/topology.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/SVD>
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace lissom;
using tubes::within;

namespace {

/// Singular value ratio of the source's triangles that went in whole: 95 of 100 lie below.
double quasi_conformal(const TriangleMesh& source, const MergedModel& model) {
    const auto flat = [](const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
        const Eigen::Vector3d x = (b - a).normalized(), y = (b - a).cross(c - a).cross(x).normalized();
        Eigen::Matrix2d M;
        M << (b - a).dot(x), (c - a).dot(x), (b - a).dot(y), (c - a).dot(y);
        return M;
    };
    std::vector<double> ratios;
    for (const int t : model.source.faces) {
        const auto rest = [&](int c) -> Eigen::Vector3d { return source.points.row(source.triangles(t, c)).transpose(); };
        const auto moved = [&](int c) -> Eigen::Vector3d { return model.positions.row(model.source.result_of_vertex[source.triangles(t, c)]).transpose(); };
        const Eigen::Matrix2d J = flat(moved(0), moved(1), moved(2)) * flat(rest(0), rest(1), rest(2)).inverse();
        const Eigen::JacobiSVD<Eigen::Matrix2d> svd(J);
        ratios.push_back(svd.singularValues()[0] / svd.singularValues()[1]);
    }
    std::sort(ratios.begin(), ratios.end());
    return ratios[ratios.size() * 95 / 100];
}

} // namespace

TEST_CASE("a boundary's energy never rises, and falls where there is something to gain") {
    const TriangleMesh source = shapes::bumpy_sphere(5), target = shapes::icosphere(5);
    const RegionMaps maps = map_regions(source, within(source, -0.1, 2), within(source, 0.75, 2), target, within(target, -0.3, 2));
    const Placement placement = best_placement(maps);
    const OptimalBoundary found = optimal_boundary(maps, placement);
    REQUIRE(found.energies.size() >= 2);
    for (std::size_t k = 1; k < found.energies.size(); ++k) CHECK(found.energies[k] <= found.energies[k - 1]);
    CHECK(found.energies.back() <= 0.8 * found.energies.front());
}

TEST_CASE("a feature merged along its optimal boundary gives one closed surface, whatever the pose of its source") {
    const TriangleMesh source_mesh = shapes::bumpy_sphere(4), target_mesh = shapes::icosphere(4);
    const PaintedRegions regions{within(source_mesh, -0.1, 2), within(source_mesh, 0.7, 2), within(target_mesh, -0.3, 2), std::nullopt};
    const auto run = [&](const TriangleMesh& from) {
        const WorkingMesh source = shapes::working(from), target = shapes::working(target_mesh);
        MergeSession session(source, target, regions);
        while (session.step()) {}
        return session.merge(std::vector<MergeKeys>(1));
    };
    const MergeResult plain = run(source_mesh);
    CHECK(plain.model.euler_characteristic == 2);
    CHECK(plain.seam.least_angle > 1);
    CHECK(plain.seam.high_dihedral < 20);
    const TriangleMesh mesh = tubes::mesh_of(plain.model, source_mesh, target_mesh);
    CHECK(euler_characteristic(mesh) == 2);
    CHECK(boundary_loops(mesh).empty());
    CHECK(non_manifold_vertices(mesh).empty());
    CHECK(signed_volume(mesh) > 0);
    double worst = 0;
    for (const Eigen::Affine3d& map : tubes::twenty_similarities()) {
        const MergeResult other = run(shapes::moved(source_mesh, map));
        REQUIRE(other.model.positions.rows() == plain.model.positions.rows());
        worst = std::max(worst, (other.model.positions - plain.model.positions).rowwise().norm().maxCoeff());
    }
    CHECK(worst < 1e-6 * diagonal(target_mesh.points));
    // The feature's topology does not matter, and a source that faces inward merges all the same.
    const MergeResult turned = run(shapes::turned_inside_out(source_mesh));
    CHECK(turned.model.euler_characteristic == 2);
}

TEST_CASE("the optimal boundary distorts the feature less than the painted edge does") {
    const TriangleMesh source_mesh = shapes::bumpy_sphere(5), target_mesh = shapes::icosphere(5);
    const WorkingMesh source = shapes::working(source_mesh), target = shapes::working(target_mesh);
    const auto run = [&](int rounds) {
        MergeSession session(source, target, PaintedRegions{within(source_mesh, -0.1, 2), within(source_mesh, 0.6, 2), within(target_mesh, -0.3, 2), std::nullopt, rounds});
        while (session.step()) {}
        return std::pair(session.energies().back(), quasi_conformal(source_mesh, session.merge(std::vector<MergeKeys>(1)).model));
    };
    const auto painted = run(0), optimal = run(50);
    CHECK(optimal.first <= 0.8 * painted.first);
    CHECK(optimal.second < painted.second);
}
