#include "lissom/merge/ring_cycle.h"

#include "shapes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

using namespace lissom;

namespace {

constexpr double k_far = std::numeric_limits<double>::infinity();

/// A flat ring of n rows of m vertices, slit straight across.
struct Slit {
    TriangleMesh mesh;
    SlitRing slit;
    WeightedGraph graph;

    Slit(int n, int m) : mesh(shapes::flat_ring(n, m)) {
        std::vector<int> inner, outer;
        for (int j = 0; j < m; ++j) {
            inner.push_back(j);
            outer.push_back((n - 1) * m + j);
        }
        slit = slit_ring(mesh, path_across(mesh, outer, inner));
        graph = edge_graph(slit.mesh);
    }
};

/// Costs without any order, the same every time and on both sides of the slit.
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

} // namespace

TEST_CASE("few searches find the same cheapest cycle as one from every vertex of the cut") {
    for (const auto& [n, m] : {std::pair{12, 30}, {30, 40}, {60, 25}})
        for (unsigned seed = 0; seed < 12; ++seed) {
            CAPTURE(seed);
            Slit ring(n, m);
            const SlitRing& slit = ring.slit;
            WeightedGraph& graph = ring.graph;
            make_costs_irregular(graph, slit, seed);
            const RingCycle fast = cheapest_cycle(graph, slit.left, slit.right), slow = cheapest_cycle_by_all_searches(graph, slit.left, slit.right);
            CHECK(fast.cost == doctest::Approx(slow.cost).epsilon(1e-12));
            CHECK(slit.original[fast.path.front()] == slit.original[fast.path.back()]);
        }
}

TEST_CASE("by length alone the cheapest way around a flat ring is its inner border") {
    const int around = 20;
    const Slit ring(8, around);
    const RingCycle found = cheapest_cycle(ring.graph, ring.slit.left, ring.slit.right);
    CHECK(found.cost == doctest::Approx(2 * around * std::sin(std::numbers::pi / around)));
    CHECK(found.path.size() == around + 1);
    for (const int v : found.path) CHECK(ring.slit.original[v] < around);
}

TEST_CASE("a cycle is a walk along edges, and its cost their sum") {
    Slit ring(12, 30);
    make_costs_irregular(ring.graph, ring.slit, 3);
    const RingCycle found = cheapest_cycle(ring.graph, ring.slit.left, ring.slit.right);
    double cost = 0;
    for (std::size_t k = 1; k < found.path.size(); ++k) {
        const int v = found.path[k - 1];
        const auto first = ring.graph.ends.begin() + ring.graph.offsets[v], last = ring.graph.ends.begin() + ring.graph.offsets[v + 1];
        const auto to = std::find(first, last, found.path[k]);
        REQUIRE(to != last);
        cost += ring.graph.lengths[static_cast<std::size_t>(to - ring.graph.ends.begin())];
    }
    CHECK(cost == doctest::Approx(found.cost));
}

TEST_CASE("a wall that no edge leads through leaves no way around") {
    const int around = 20;
    Slit ring(8, around);
    for (int v = 0; v < ring.graph.size(); ++v)
        for (int e = ring.graph.offsets[v]; e < ring.graph.offsets[v + 1]; ++e)
            if (ring.slit.original[v] % around == 10 || ring.slit.original[ring.graph.ends[e]] % around == 10) ring.graph.lengths[e] = k_far;
    for (const RingCycle& none : {cheapest_cycle(ring.graph, ring.slit.left, ring.slit.right), cheapest_cycle_by_all_searches(ring.graph, ring.slit.left, ring.slit.right)}) {
        CHECK(none.cost == k_far);
        CHECK(none.path.empty());
    }
}
