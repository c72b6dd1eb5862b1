#include "lissom/mesh/edge_surgery.h"

#include "../shapes.h"

#include "lissom/mesh/topology.h"

#include <doctest/doctest.h>

#include <set>
#include <tuple>

using namespace lissom;

namespace {

/// χ = V − E + F of what is left.
int euler(const EdgeSurgery& surgery) {
    const auto [place, count] = surgery.numbering();
    return count - static_cast<int>(surgery.edges().size()) + static_cast<int>(surgery.triangles(place).rows());
}

/// Every side of a triangle once in each direction at most, and its partner beside it where the surface is closed.
bool fits_together(const Triangles& triangles, bool closed) {
    std::set<std::pair<int, int>> sides;
    for (Eigen::Index t = 0; t < triangles.rows(); ++t)
        for (int k = 0; k < 3; ++k)
            if (!sides.insert({triangles(t, k), triangles(t, (k + 1) % 3)}).second) return false;
    if (closed)
        for (const auto& [a, b] : sides)
            if (!sides.count({b, a})) return false;
    return true;
}

} // namespace

TEST_CASE("whatever edges are split, collapsed and swapped, the surface stays what it is") {
    for (const auto& [mesh, closed, chi] : {std::tuple{shapes::icosphere(2), true, 2}, std::tuple{shapes::torus(12, 8), true, 0}, std::tuple{shapes::sheet(6, 5), false, 1}}) {
        EdgeSurgery surgery(mesh.triangles, mesh.vertex_count());
        int splits = 0, collapses = 0, swaps = 0;
        for (int round = 0; round < 4; ++round) {
            int number = 0;
            for (const auto& [a, b] : surgery.edges()) {
                ++number;
                if (!surgery.alive(a) || !surgery.alive(b)) continue;
                const EdgeSurgery::Sides at = surgery.sides(a, b);
                if (at.left < 0 && at.right < 0) continue; // gone with others
                if (number % 7 == 0) splits += surgery.split(a, b) >= 0;
                else if (number % 3 == 0 && surgery.may_collapse(a, b)) {
                    surgery.collapse(a, b);
                    ++collapses;
                } else if (number % 5 == 0 && surgery.may_swap(a, b)) {
                    surgery.swap(a, b);
                    ++swaps;
                }
            }
            const auto [place, count] = surgery.numbering();
            CHECK(count == surgery.vertex_count());
            CHECK(euler(surgery) == chi);
            CHECK(fits_together(surgery.triangles(place), closed));
        }
        CHECK(splits > 0);
        CHECK(collapses > 0);
        CHECK(swaps > 0);
    }
}

TEST_CASE("a tetrahedron keeps its vertices, a border is not pinched, and an edge of three triangles is left alone") {
    Triangles four(4, 3);
    four << 0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3;
    EdgeSurgery closed(four, 4);
    for (const auto& [a, b] : closed.edges()) CHECK_FALSE(closed.may_collapse(a, b));
    CHECK_FALSE(closed.may_swap(0, 1));

    Triangles strip(4, 3); // two rows of three: the edge between the middles joins two borders
    strip << 0, 1, 3, 1, 4, 3, 1, 2, 4, 2, 5, 4;
    const EdgeSurgery open(strip, 6);
    CHECK(open.on_border(1));
    CHECK_FALSE(open.may_collapse(1, 4));
    CHECK(open.ring(1) == std::vector<int>{0, 2, 3, 4});

    Triangles fin(3, 3);
    fin << 0, 1, 2, 1, 0, 3, 0, 1, 4;
    EdgeSurgery many(fin, 5);
    CHECK_FALSE(many.sides(0, 1).sound);
    CHECK(many.split(0, 1) == -1);
    CHECK_FALSE(many.may_collapse(0, 1));
    CHECK_FALSE(many.may_swap(0, 1));
}

TEST_CASE("triangles of equal corners are left out, and vertices of none are no vertices") {
    Triangles some(2, 3);
    some << 0, 1, 2, 3, 3, 4;
    const EdgeSurgery surgery(some, 6);
    CHECK(surgery.vertex_count() == 3);
    CHECK(surgery.edges().size() == 3);
    CHECK_FALSE(surgery.alive(3));
}
