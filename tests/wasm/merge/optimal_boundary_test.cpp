// Optimal boundaries (Fu 3.4): cheapest cycles, conformal maps, energies that only fall.

#include "tubes.h"

#include "lissom/merge/hole_filling.h"
#include "lissom/merge/optimal_boundary.h"
#include "lissom/merge/ring_cycle.h"
#include "lissom/mesh/errors.h"
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

namespace {

/// A flat ring of n rows of m vertices, radius 1 to 2, costs without any order but the same every time.
struct Ring {
    TriangleMesh mesh;
    std::vector<int> inner, outer;
};

Ring flat_ring(int n, int m) {
    Ring ring{{Points(n * m, 3), Triangles(2 * (n - 1) * m, 3)}, {}, {}};
    int f = 0;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < m; ++j) {
            const double r = 1 + static_cast<double>(i) / (n - 1), a = 2 * std::numbers::pi * j / m;
            ring.mesh.points.row(i * m + j) << r * std::cos(a), r * std::sin(a), 0;
            if (i + 1 == n) continue;
            const int k = (j + 1) % m;
            ring.mesh.triangles.row(f++) << i * m + j, (i + 1) * m + j, (i + 1) * m + k;
            ring.mesh.triangles.row(f++) << i * m + j, (i + 1) * m + k, i * m + k;
        }
    for (int j = 0; j < m; ++j) {
        ring.inner.push_back(j);
        ring.outer.push_back((n - 1) * m + j);
    }
    return ring;
}

void make_costs_irregular(WeightedGraph& graph, const SlitRing& slit, unsigned seed) {
    for (int v = 0; v < graph.size(); ++v)
        for (int e = graph.offsets[v]; e < graph.offsets[v + 1]; ++e) {
            const auto a = static_cast<unsigned>(std::min(slit.original[v], slit.original[graph.ends[e]]));
            const auto b = static_cast<unsigned>(std::max(slit.original[v], slit.original[graph.ends[e]]));
            unsigned h = (a * 2654435761u) ^ (b * 40503u + seed * 97u);
            h ^= h >> 13;
            h *= 2246822519u;
            h ^= h >> 16;
            graph.lengths[e] *= 0.05 + (h % 1000) / 1000.0;
        }
}

std::vector<int> within(const TriangleMesh& mesh, double low, double high) {
    std::vector<int> list;
    for (int v = 0; v < mesh.vertex_count(); ++v)
        if (mesh.points(v, 1) >= low && mesh.points(v, 1) <= high) list.push_back(v);
    return list;
}

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

TEST_CASE("few searches find the same cheapest cycle as one from every vertex of the cut") {
    for (const auto& [n, m] : {std::pair{12, 30}, {30, 40}, {60, 25}})
        for (unsigned seed = 0; seed < 12; ++seed) {
            CAPTURE(seed);
            const Ring ring = flat_ring(n, m);
            const SlitRing slit = slit_ring(ring.mesh, path_across(ring.mesh, ring.outer, ring.inner));
            WeightedGraph graph = edge_graph(slit.mesh);
            make_costs_irregular(graph, slit, seed);
            const RingCycle fast = cheapest_cycle(graph, slit.left, slit.right), slow = cheapest_cycle_by_all_searches(graph, slit.left, slit.right);
            CHECK(fast.cost == doctest::Approx(slow.cost).epsilon(1e-12));
            CHECK(slit.original[fast.path.front()] == slit.original[fast.path.back()]);
        }
}

TEST_CASE("a slit ring is a disk with the ring's triangles") {
    const Ring ring = flat_ring(8, 20);
    const std::vector<int> across = path_across(ring.mesh, ring.outer, ring.inner);
    CHECK(across.size() == 8);
    const SlitRing slit = slit_ring(ring.mesh, across);
    CHECK(euler_characteristic(slit.mesh) == 1);
    CHECK(boundary_loops(slit.mesh).size() == 1);
}

TEST_CASE("the least-area filling of a flat polygon has its area") {
    const Ring ring = flat_ring(2, 24);
    double area = 0;
    for (const auto& [a, b, c] : least_area_filling(ring.mesh.points, ring.inner)) {
        const Eigen::Vector3d p = ring.mesh.points.row(a), q = ring.mesh.points.row(b), r = ring.mesh.points.row(c);
        area += (q - p).cross(r - p).norm() / 2;
    }
    CHECK(area == doctest::Approx(12 * std::sin(2 * std::numbers::pi / 24)));
}

TEST_CASE("the conformal map of a flat patch is the patch, but for a similarity") {
    TriangleMesh sheet = shapes::sheet(9, 6);
    const auto loops = boundary_loops(sheet);
    const PlanePoints map = conformal_map(sheet, loops.front());
    Points flat = Points::Zero(map.rows(), 3);
    flat.leftCols(2) = map;
    CHECK(misfit(fit_similarity(sheet.points, flat), sheet.points, flat) < 1e-8);
}

TEST_CASE("a boundary's energy never rises, and falls where there is something to gain") {
    const TriangleMesh source = shapes::bumpy_sphere(5), target = shapes::icosphere(5);
    const RegionMaps maps = map_regions(source, within(source, -0.1, 2), within(source, 0.75, 2), target, within(target, -0.3, 2));
    const Placement placement = best_placement(maps);
    const OptimalBoundary found = optimal_boundary(maps, placement);
    REQUIRE(found.energies.size() >= 2);
    for (std::size_t k = 1; k < found.energies.size(); ++k) CHECK(found.energies[k] <= found.energies[k - 1]);
    CHECK(found.energies.back() <= 0.8 * found.energies.front());
}

TEST_CASE("regions that cannot work are refused with what is wrong") {
    const TriangleMesh ball = shapes::icosphere(4);
    const auto code = [&](const std::vector<int>& region, const std::vector<int>& feature, const std::vector<int>& target) {
        try {
            (void)map_regions(ball, region, feature, ball, target);
        } catch (const InvalidInput& error) {
            return error.code();
        }
        return std::string("none");
    };
    const std::vector<int> cap = within(ball, 0.1, 2), tip = within(ball, 0.7, 2), belt = within(ball, -0.4, 0.4), none;
    CHECK(code(cap, tip, cap) == "none");
    CHECK(code(cap, none, cap) == "no-feature");
    CHECK(code(tip, cap, cap) == "feature-outside-region");
    CHECK(code(cap, cap, cap) == "region-touches-feature");
    CHECK(code(cap, tip, none) == "no-target-region");
    CHECK(code(cap, tip, belt) == "target-region-not-a-disk");
    CHECK(code(within(ball, -2, 2), tip, cap) == "region-not-a-ring");
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
