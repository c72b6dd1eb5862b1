#include "lissom/mesh/grid.h"

#include <doctest/doctest.h>

#include <cmath>
#include <set>

using namespace lissom;
using Eigen::Vector3d;

namespace {

const Grid k_grid{{1, -2, 3}, 0.25, {5, 7, 4}};

} // namespace

TEST_CASE("each node has one number, one cell and one place") {
    std::set<int> seen;
    for (int z = 0; z < 4; ++z)
        for (int y = 0; y < 7; ++y)
            for (int x = 0; x < 5; ++x) {
                const int node = k_grid.node(x, y, z);
                seen.insert(node);
                CHECK(k_grid.cell(node) == Eigen::Vector3i(x, y, z));
                CHECK((k_grid.local(k_grid.position(node)) - Vector3d(x, y, z)).norm() < 1e-12);
            }
    CHECK(static_cast<int>(seen.size()) == k_grid.count());
    CHECK(*seen.begin() == 0);
    CHECK(*seen.rbegin() == k_grid.count() - 1);
}

TEST_CASE("the grid holds its walls and nothing beyond them") {
    const Vector3d last = k_grid.position(k_grid.count() - 1);
    CHECK(k_grid.contains(k_grid.origin));
    CHECK(k_grid.contains(last));
    for (int d = 0; d < 3; ++d) {
        CHECK(!k_grid.contains(k_grid.origin - 1e-6 * Vector3d::Unit(d)));
        CHECK(!k_grid.contains(last + 1e-6 * Vector3d::Unit(d)));
    }
}

TEST_CASE("trilinear weights give back every linear function, at the walls too") {
    for (int i = 0; i < 500; ++i) {
        const Vector3d share = 0.5 * (Vector3d::Ones() + Vector3d(std::sin(1.7 * i), std::cos(2.9 * i), std::sin(0.6 * i + 1)));
        Vector3d q = share.cwiseProduct((k_grid.size.array() - 1).cast<double>().matrix());
        if (i % 5 == 0) q = q.array().round(); // on nodes, edges and walls
        const Vector3d p = k_grid.origin + k_grid.step * q;
        const Cell cell = cell_of(k_grid, p);
        Vector3d mean = Vector3d::Zero();
        double sum = 0;
        for (int k = 0; k < 8; ++k) {
            CHECK(cell.weights[k] >= 0);
            CHECK((cell.nodes[k] >= 0 && cell.nodes[k] < k_grid.count()));
            sum += cell.weights[k];
            mean += cell.weights[k] * k_grid.position(cell.nodes[k]);
        }
        CHECK(sum == doctest::Approx(1));
        CHECK((mean - p).norm() < 1e-12);
    }
}

TEST_CASE("a point outside is taken to its nearest place inside, on a grid of one layer as well") {
    const Grid flat{{0, 0, 0}, 1, {3, 3, 1}};
    const Cell cell = cell_of(flat, {1.5, -4, 9});
    Vector3d mean = Vector3d::Zero();
    for (int k = 0; k < 8; ++k) mean += cell.weights[k] * flat.position(cell.nodes[k]);
    CHECK((mean - Vector3d(1.5, 0, 0)).norm() < 1e-12);
}
