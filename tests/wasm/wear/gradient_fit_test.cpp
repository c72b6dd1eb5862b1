#include "lissom/wear/gradient_fit.h"

#include "shapes.h"

#include "lissom/mesh/operators.h"
#include "lissom/wear/surface_turns.h"

#include <doctest/doctest.h>

#include <cmath>

using Eigen::AngleAxisd;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using lissom::Points;
using lissom::TriangleMesh;

namespace {

Points fitted(const TriangleMesh& mesh, const std::vector<Matrix3d>& maps, const Points& means) {
    lissom::GradientFit fit(mesh);
    while (fit.step()) CHECK(fit.fraction() <= 1);
    return fit.fit(maps, means);
}

Points waved(Points points) {
    for (Eigen::Index v = 0; v < points.rows(); ++v) points.row(v) += 0.2 * Eigen::RowVector3d(std::sin(2 * points(v, 1)), points(v, 2) * points(v, 0), std::cos(3 * points(v, 0)));
    return points;
}

double farthest(const Points& a, const Points& b) { return (a - b).rowwise().norm().maxCoeff(); }

} // namespace

TEST_CASE("maps that belong to a surface give that surface, each of its pieces where its mean is") {
    for (const TriangleMesh& mesh : {shapes::bumpy_sphere(3), shapes::bumpy_sheet(), shapes::two_spheres()}) {
        const Points there = waved(mesh.points);
        CHECK(farthest(fitted(mesh, lissom::surface_maps(mesh, there), there - mesh.points), there) < 1e-9);
    }
}

TEST_CASE("the fit is the least of all: what is wanted beside it is square to every change") {
    const TriangleMesh mesh = shapes::bumpy_sphere(2);
    std::vector<Matrix3d> maps;
    for (int t = 0; t < mesh.triangle_count(); ++t) maps.push_back(AngleAxisd(std::sin(t), Vector3d::UnitX()).toRotationMatrix());
    const auto energy = [&](const Points& points) {
        const Eigen::VectorXd areas = lissom::triangle_areas(mesh);
        double sum = 0;
        for (int t = 0; t < mesh.triangle_count(); ++t) {
            const auto side = [&](const Points& p, int k) -> Vector3d { return (p.row(mesh.triangles(t, k)) - p.row(mesh.triangles(t, 0))).transpose(); };
            // In the triangle's own plane: the gradients of both coordinates there.
            const Vector3d x = side(mesh.points, 1).normalized(), n = side(mesh.points, 1).cross(side(mesh.points, 2)).normalized(), y = n.cross(x);
            Eigen::Matrix2d rest;
            rest << x.dot(side(mesh.points, 1)), x.dot(side(mesh.points, 2)), y.dot(side(mesh.points, 1)), y.dot(side(mesh.points, 2));
            Eigen::Matrix<double, 3, 2> moved, plane;
            moved << side(points, 1), side(points, 2);
            plane << x, y;
            sum += areas[t] * (moved * rest.inverse() - maps[static_cast<std::size_t>(t)] * plane).squaredNorm();
        }
        return sum;
    };
    const Points best = fitted(mesh, maps, Points::Zero(mesh.vertex_count(), 3));
    const double least = energy(best);
    for (int v = 0; v < mesh.vertex_count(); v += 17)
        for (const double by : {-1e-3, 1e-3}) {
            Points other = best;
            other(v, v % 3) += by;
            CHECK(energy(other) > least);
        }
}

TEST_CASE("unused vertices and needles do not keep it from being found") {
    const TriangleMesh mesh = shapes::with_needles(shapes::with_unused_vertices(shapes::bumpy_sphere(2), 3), 4, 1e-9);
    const std::vector<Matrix3d> maps(static_cast<std::size_t>(mesh.triangle_count()), AngleAxisd(0.5, Vector3d::UnitY()).toRotationMatrix());
    CHECK(fitted(mesh, maps, Points::Zero(mesh.vertex_count(), 3)).allFinite());
}
