// Times the cheapest cycle around a ring: few searches that divide it beside one from every vertex of the cut, as in the
// thesis (Fu 3.4.3), one line of JSON per ring.
//
//   merge_bench [--rings 2500,10000]

#include "options.h"

#include "lissom/merge/ring_cycle.h"
#include "lissom/mesh/stopwatch.h"
#include "lissom/mesh/surface_paths.h"

#include <cmath>
#include <cstdio>
#include <numbers>
#include <random>
#include <vector>

namespace {

using namespace lissom;

/// About as many vertices across as around, costs without any order.
void measure(int vertices) {
    const int n = static_cast<int>(std::lround(std::sqrt(vertices))), m = n;
    TriangleMesh ring{Points(n * m, 3), Triangles(2 * (n - 1) * m, 3)};
    std::vector<int> inner, outer;
    for (int i = 0, f = 0; i < n; ++i)
        for (int j = 0; j < m; ++j) {
            const double r = 1 + static_cast<double>(i) / (n - 1), a = 2 * std::numbers::pi * j / m;
            ring.points.row(i * m + j) << r * std::cos(a), r * std::sin(a), 0;
            if (i + 1 == n) continue;
            const int k = (j + 1) % m;
            ring.triangles.row(f++) << i * m + j, (i + 1) * m + j, (i + 1) * m + k;
            ring.triangles.row(f++) << i * m + j, (i + 1) * m + k, i * m + k;
        }
    for (int j = 0; j < m; ++j) {
        inner.push_back(j);
        outer.push_back((n - 1) * m + j);
    }
    const SlitRing slit = slit_ring(ring, path_across(ring, outer, inner));
    WeightedGraph graph = edge_graph(slit.mesh);
    std::vector<double> cost(static_cast<std::size_t>(n) * m);
    std::mt19937 random(1);
    for (double& c : cost) c = 0.05 + random() / 4294967296.0;
    for (int v = 0; v < graph.size(); ++v)
        for (int e = graph.offsets[v]; e < graph.offsets[v + 1]; ++e) graph.lengths[e] *= cost[slit.original[v]] + cost[slit.original[graph.ends[e]]];
    Stopwatch watch;
    const RingCycle fast = cheapest_cycle(graph, slit.left, slit.right);
    const double few = watch.lap();
    const RingCycle slow = cheapest_cycle_by_all_searches(graph, slit.left, slit.right);
    const double all = watch.lap();
    std::printf("{\"ring\":%d,\"cut\":%d,\"searches\":%d,\"seconds\":%.4f,\"one each\":%.4f,\"ratio\":%.1f,\"apart\":%.1e}\n", n * m,
                static_cast<int>(slit.left.size()), fast.searches, few, all, all / few, std::abs(fast.cost - slow.cost) / slow.cost);
    std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv) {
    const bench::Options options(argc, argv);
    for (const int vertices : options.numbers("--rings", "2500,10000")) measure(vertices);
}
