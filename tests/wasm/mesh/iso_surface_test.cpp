#include "lissom/mesh/iso_surface.h"

#include "lissom/mesh/chance.h"
#include "lissom/mesh/operators.h"
#include "lissom/mesh/topology.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace lissom;
using Eigen::Vector3d;

namespace {

Grid grid_of(int n) { return {Vector3d::Constant(-1.5), 3.0 / (n - 1), Eigen::Vector3i::Constant(n)}; }

template <class F>
std::vector<float> values_of(const Grid& grid, F f) {
    std::vector<float> values;
    for (int i = 0; i < grid.count(); ++i) values.push_back(static_cast<float>(f(grid.position(i))));
    return values;
}

} // namespace

TEST_CASE("a ball and a ring are closed, of their genus, face outward and have their volume, the better the finer") {
    double last = 1;
    for (const int n : {12, 24, 48}) {
        const Grid grid = grid_of(n);
        const TriangleMesh ball = iso_surface(grid, values_of(grid, [](const Vector3d& p) { return p.norm() - 1; }));
        CHECK(euler_characteristic(ball) == 2);
        CHECK(boundary_loops(ball).empty());
        CHECK(non_manifold_vertices(ball).empty());
        const double error = std::abs(signed_volume(ball) - 4.18879) / 4.18879;
        CHECK(error < 0.3 * last);
        last = error;
        const TriangleMesh ring = iso_surface(grid, values_of(grid, [](const Vector3d& p) { return std::hypot(std::hypot(p.x(), p.y()) - 1, p.z()) - 0.35; }));
        CHECK(euler_characteristic(ring) == 0);
        CHECK(boundary_loops(ring).empty());
        CHECK(signed_volume(ring) > 0);
        CHECK((triangle_areas(ring).array() > 0).all());
    }
}

TEST_CASE("whatever the values, the surface is closed and manifold, and every edge has two triangles that agree") {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const Grid grid{Vector3d::Zero(), 1, {7, 6, 8}};
        std::vector<float> values;
        for (int i = 0; i < grid.count(); ++i) {
            const Eigen::Vector3i c = grid.cell(i);
            const bool border = (c.array() == 0).any() || (c.array() == grid.size.array() - 1).any();
            const double x = chance(seed, static_cast<std::uint64_t>(i), 1) - 0.5;
            values.push_back(border ? 1.0f : static_cast<float>(i % 11 == 0 ? 0 : x)); // zeros, too
        }
        const TriangleMesh mesh = iso_surface(grid, values);
        for (const Edge& e : edges(mesh)) CHECK((e.forward == 1 && e.backward == 1));
        CHECK(non_manifold_vertices(mesh).empty());
        CHECK(signed_volume(mesh) > 0);
    }
}
