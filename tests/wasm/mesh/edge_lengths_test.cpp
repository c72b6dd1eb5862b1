#include "lissom/mesh/edge_lengths.h"

#include "lissom/mesh/operators.h"
#include "lissom/mesh/topology.h"
#include "shapes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace lissom;

TEST_CASE("without adapting, and where the surface bends the same everywhere, lengths are equal") {
    for (const double h : edge_lengths(shapes::bumpy_sphere(3), 0.1, 0)) CHECK(h == 0.1);
    const auto on_ball = edge_lengths(shapes::icosphere(4), 0.1, 1);
    CHECK(*std::max_element(on_ball.begin(), on_ball.end()) < 0.11);
    CHECK(*std::min_element(on_ball.begin(), on_ball.end()) > 0.09);
    for (const double h : edge_lengths(shapes::sheet(10, 10), 0.1, 1)) CHECK(h == doctest::Approx(0.1));
}

TEST_CASE("triangles get small where it bends; as many in all, lengths change slowly, whatever the scale") {
    const TriangleMesh torus = shapes::torus(96, 48);
    const auto h = edge_lengths(torus, 0.05, 1);
    const VertexRings rings = vertex_rings(torus);
    const Eigen::VectorXd areas = vertex_areas(torus);
    double density = 0;
    for (int v = 0; v < torus.vertex_count(); ++v) {
        density += areas[v] / (h[v] * h[v]);
        for (const int w : rings[v]) CHECK(h[v] <= h[w] + 1.1 * k_grading * (torus.points.row(v) - torus.points.row(w)).norm());
    }
    CHECK(density == doctest::Approx(areas.sum() / (0.05 * 0.05)).epsilon(0.02));
    TriangleMesh egg = shapes::icosphere(4);
    egg.points.col(0) *= 4;
    const auto of_egg = edge_lengths(egg, 0.1, 1);
    Eigen::Index tip = 0, flank = 0;
    egg.points.col(0).maxCoeff(&tip);
    egg.points.col(0).cwiseAbs().minCoeff(&flank);
    CHECK(of_egg[static_cast<std::size_t>(tip)] < 0.6 * of_egg[static_cast<std::size_t>(flank)]);
    TriangleMesh large = egg;
    large.points *= 1024;
    const auto of_large = edge_lengths(large, 102.4, 1);
    for (std::size_t v = 0; v < of_egg.size(); ++v) CHECK(of_large[v] == doctest::Approx(1024 * of_egg[v]).epsilon(1e-12));
}

TEST_CASE("a crease is no curvature") {
    const TriangleMesh box = shapes::box(10, 10, 10);
    std::vector<char> creases(static_cast<std::size_t>(box.vertex_count()), 0);
    for (int v = 0; v < box.vertex_count(); ++v) {
        int on = 0;
        for (int k = 0; k < 3; ++k) on += std::abs(std::abs(box.points(v, k) - (k == 1 ? 0.5 : 0)) - 0.5) < 1e-12;
        creases[v] = on >= 2;
    }
    for (const double h : edge_lengths(box, 0.1, 1, creases)) CHECK(h == doctest::Approx(0.1));
    const auto asked = edge_lengths(box, 0.1, 1);
    CHECK(*std::min_element(asked.begin(), asked.end()) < 0.08);
}
