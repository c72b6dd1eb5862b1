#include "lissom/merge/plane_map.h"

#include "lissom/mesh/operators.h"
#include "lissom/mesh/similarity.h"
#include "lissom/mesh/topology.h"
#include "shapes.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

using namespace lissom;
using Eigen::Vector2d;

namespace {

double twice_area(const PlanePoints& map, const Triangles& triangles, int t) {
    const Eigen::RowVector2d a = map.row(triangles(t, 0)), b = map.row(triangles(t, 1)), c = map.row(triangles(t, 2));
    return (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
}

Vector2d place_of(const PlanePoints& map, const Triangles& triangles, const PlanePlace& place) {
    Vector2d out = Vector2d::Zero();
    for (int c = 0; c < 3; ++c) out += place.weight[static_cast<std::size_t>(c)] * map.row(triangles(place.triangle, c)).transpose();
    return out;
}

/// The upper half of a bumpy sphere: an open cap.
TriangleMesh cap() {
    const TriangleMesh ball = shapes::bumpy_sphere(4);
    std::vector<Eigen::RowVector3i> kept;
    std::vector<int> place(static_cast<std::size_t>(ball.vertex_count()), -1), back;
    for (int t = 0; t < ball.triangle_count(); ++t) {
        bool above = true;
        for (int c = 0; c < 3; ++c) above = above && ball.points(ball.triangles(t, c), 1) > 0.1;
        if (above) kept.emplace_back(ball.triangles.row(t));
    }
    for (const Eigen::RowVector3i& t : kept)
        for (int c = 0; c < 3; ++c)
            if (place[t[c]] < 0) {
                place[t[c]] = static_cast<int>(back.size());
                back.push_back(t[c]);
            }
    TriangleMesh out{Points(std::ssize(back), 3), Triangles(std::ssize(kept), 3)};
    for (std::size_t v = 0; v < back.size(); ++v) out.points.row(static_cast<Eigen::Index>(v)) = ball.points.row(back[v]);
    for (std::size_t t = 0; t < kept.size(); ++t)
        for (int c = 0; c < 3; ++c) out.triangles(static_cast<Eigen::Index>(t), c) = place[kept[t][c]];
    return out;
}

} // namespace

TEST_CASE("a point is found in its triangle, by weights that give it back") {
    const TriangleMesh ring = shapes::flat_ring(6, 15);
    const PlanePoints flat = ring.points.leftCols(2);
    const PlaneLocator locator(flat, ring.triangles);
    for (int i = 0; i < 400; ++i) {
        const double r = 1.02 + 0.95 * (0.5 + 0.5 * std::sin(3.1 * i)), a = 2.7 * i; // within the polygons
        const Vector2d p = r * std::cos(std::numbers::pi / 15) * Vector2d(std::cos(a), std::sin(a));
        const PlanePlace found = locator.locate(p);
        if (found.triangle < 0) {
            CHECK(p.norm() < 1); // in the hole: the inner polygon's corners reach out to 1
            continue;
        }
        for (const double weight : found.weight) CHECK(weight >= -1e-9);
        CHECK((place_of(flat, ring.triangles, found) - p).norm() < 1e-12);
    }
}

TEST_CASE("a point outside is nowhere, or at the nearest place if that is asked for") {
    const TriangleMesh sheet = shapes::sheet(7, 7);
    const PlanePoints flat = sheet.points.leftCols(2);
    const double low = flat.minCoeff(), high = flat.maxCoeff();
    const PlaneLocator locator(flat, sheet.triangles);
    for (const auto& [p, nearest] : {std::pair{Vector2d(high + 5, high + 1), Vector2d(high, high)}, {Vector2d(low - 0.1, 0.4 * low + 0.6 * high), Vector2d(low, 0.4 * low + 0.6 * high)}}) {
        CHECK(locator.locate(p).triangle == -1);
        const PlanePlace found = locator.locate(p, true);
        REQUIRE(found.triangle >= 0);
        CHECK((place_of(flat, sheet.triangles, found) - nearest).norm() < 1e-12);
    }
    CHECK(PlaneLocator(PlanePoints(0, 2), Triangles(0, 3)).locate({0, 0}, true).triangle == -1);
}

TEST_CASE("with a convex border no triangle of a Tutte map turns over, whatever the surface") {
    const TriangleMesh mesh = cap();
    const std::vector<int> border = boundary_loops(mesh).front();
    PlanePoints circle(std::ssize(border), 2);
    for (Eigen::Index k = 0; k < circle.rows(); ++k) {
        const double a = 2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(circle.rows());
        circle.row(k) << std::cos(a), std::sin(a);
    }
    const PlanePoints map = tutte_map(mesh, border, circle);
    for (int t = 0; t < mesh.triangle_count(); ++t) CHECK(twice_area(map, mesh.triangles, t) > 0);
    for (std::size_t k = 0; k < border.size(); ++k) CHECK(map.row(border[k]) == circle.row(static_cast<Eigen::Index>(k)));
    // Every other vertex lies at the mean of its neighbours.
    const VertexRings rings = vertex_rings(mesh);
    const std::vector<bool> fixed = boundary_vertices(mesh);
    for (int v = 0; v < mesh.vertex_count(); ++v) {
        if (fixed[v]) continue;
        Eigen::RowVector2d mean = Eigen::RowVector2d::Zero();
        for (const int w : rings[v]) mean += map.row(w) / static_cast<double>(rings[v].size());
        CHECK((map.row(v) - mean).norm() < 1e-10);
    }
}

TEST_CASE("the conformal map of a flat patch is the patch, but for a similarity") {
    TriangleMesh sheet = shapes::sheet(9, 6);
    const auto loops = boundary_loops(sheet);
    const PlanePoints map = conformal_map(sheet, loops.front());
    Points flat = Points::Zero(map.rows(), 3);
    flat.leftCols(2) = map;
    CHECK(misfit(fit_similarity(sheet.points, flat), sheet.points, flat) < 1e-8);
}

TEST_CASE("a conformal map has area π about the origin and keeps the orientation") {
    for (const TriangleMesh& mesh : {cap(), shapes::bumpy_sheet(12, 9)}) {
        const PlanePoints map = conformal_map(mesh, boundary_loops(mesh).front());
        double area = 0;
        Eigen::RowVector2d centre = Eigen::RowVector2d::Zero();
        for (int t = 0; t < mesh.triangle_count(); ++t) {
            const double part = twice_area(map, mesh.triangles, t) / 2;
            CHECK(part > 0);
            area += part;
            for (int c = 0; c < 3; ++c) centre += part * map.row(mesh.triangles(t, c)) / 3;
        }
        CHECK(area == doctest::Approx(std::numbers::pi));
        CHECK(centre.norm() < 1e-9);
    }
}

TEST_CASE("a conformal map keeps angles: its Dirichlet energy is its area, nearly") {
    const TriangleMesh mesh = cap();
    const PlanePoints map = conformal_map(mesh, boundary_loops(mesh).front());
    const Eigen::MatrixXd flat = map;
    const double energy = -0.5 * flat.cwiseProduct(cotangent_laplacian(mesh) * flat).sum(); // ≥ the area, equal where conformal
    CHECK(energy >= std::numbers::pi * (1 - 1e-9));
    CHECK(energy < std::numbers::pi * 1.01);
}

TEST_CASE("neither the unit nor the pose of the surface matters to its conformal map") {
    const TriangleMesh mesh = cap();
    const std::vector<int> border = boundary_loops(mesh).front();
    const PlanePoints here = conformal_map(mesh, border);
    for (const double unit : {1e-4, 1e4}) {
        const Eigen::Affine3d map = Eigen::Translation3d(unit * Eigen::Vector3d(1, 2, 3)) * Eigen::AngleAxisd(2, Eigen::Vector3d(1, 0, 2).normalized()) * Eigen::Scaling(unit);
        CHECK((conformal_map(shapes::moved(mesh, map), border) - here).norm() < 1e-6 * here.norm());
    }
}
