// Times curves on a model, one line of JSON per size: once per drawing, a pose where one curve has every vertex, one where two share half
// of them, one where they share all, and the table alone, which is all that a drag makes. Built like the kernel, natively and for WebAssembly.
//
//   curve_bench [--vertices 10000,170000,544000] [--repeat 20]

#include "egg.h"
#include "options.h"

#include "lissom/curve/pose.h"
#include "lissom/mesh/self_intersections.h"
#include "lissom/mesh/stopwatch.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <vector>

namespace {

using lissom::CurvePosture;
using lissom::CurveSession;
using lissom::Points;

/// Control points of the long egg's axis between two heights, pulled aside by a parabola.
Points axis(double from, double to, double aside) {
    Points points(5, 3);
    for (int i = 0; i < 5; ++i) {
        const double y = from + (to - from) * i / 4;
        points.row(i) = Eigen::RowVector3d(aside * (y - from) * (y - from), y, 0);
    }
    return points;
}

/// Radii over which two curves share half of the vertices between them.
constexpr double k_half = 6;

/// Seconds of the fastest of some poses.
double fastest(const CurveSession& session, const std::vector<CurvePosture>& postures, int repeat) {
    double best = INFINITY;
    lissom::Stopwatch clock;
    for (int r = 0; r < repeat; ++r) {
        clock.lap();
        const auto posed = session.posed(postures);
        best = std::min(best, clock.lap());
        if (!posed.positions.allFinite()) std::printf("a position that is none\n");
    }
    return best;
}

void run(int vertices, int repeat, bool quiet = false) {
    lissom::PolygonMesh egg = bench::bumpy_egg(vertices);
    egg.points.col(1) *= 6;
    const auto model = std::make_shared<const lissom::WorkingMesh>(lissom::make_working_mesh(egg));
    const int n = static_cast<int>(model->source.rows());
    lissom::Stopwatch clock;
    CurveSession one(model, {{.rest = axis(-5, 5, 0), .anchor = lissom::CurveEnd::start}});
    while (one.step()) {
    }
    const double setup = clock.lap();
    const auto sharing = [&](double blend) { // over so many radii
        lissom::CurveOptions wide;
        wide.blending = lissom::CurveBlending::geodesic;
        wide.blend = blend;
        CurveSession made(model, {{.rest = axis(-5, 0, 0)}, {.rest = axis(0, 5, 0)}}, {{1, 0, 1}}, wide);
        while (made.step()) {
        }
        return made;
    };
    const CurveSession two = sharing(k_half);
    const double linked = clock.lap();
    const CurveSession all = sharing(10);
    const std::vector<CurvePosture> bent{{.points = axis(-5, 5, 0.03)}}, both{{.points = axis(-5, 0, 0.05)}, {.points = axis(0, 5, 0.05)}};
    const double single = fastest(one, bent, repeat), shared = fastest(two, both, repeat), whole = fastest(all, both, repeat);
    const auto blended = [&](const CurveSession& session) {
        int count = 0;
        const auto weights = session.attributes().weights;
        for (int v = 0; v < n; ++v) count += weights[4 * static_cast<std::size_t>(v) + 1] > 0;
        return 100.0 * count / n;
    };
    clock.lap();
    double table = INFINITY;
    for (int r = 0; r < repeat; ++r) {
        clock.lap();
        (void)one.table(bent);
        table = std::min(table, clock.lap());
    }
    clock.lap();
    const int pairs = lissom::self_intersections(model->mesh).pairs;
    const double crossings = clock.lap();
    if (quiet) return;
    std::printf("{\"vertices\":%d,\"setup_s\":%.2f,\"regions_s\":%.2f,\"linked_s\":%.2f,\"pose_ms\":%.2f,\"one_curve_mverts\":%.0f,\"shared\":\"%.0f %%\",\"shared_mverts\":%.0f,"
                "\"blended\":\"%.0f %%\",\"blended_mverts\":%.0f,\"table_ms\":%.2f,\"memory_mb\":%.0f,\"crossings\":%d,\"crossings_s\":%.2f}\n",
                n, setup, one.seconds().regions, linked, 1e3 * single, 1e-6 * n / single, blended(two), 1e-6 * n / shared, blended(all), 1e-6 * n / whole, 1e3 * table,
                1e-6 * one.memory_bytes(), pairs, crossings);
    std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv) {
    const bench::Options options(argc, argv);
    const int repeat = options.number("--repeat", 20);
    run(5000, 200, true); // engines compile WebAssembly twice, well the second time and only after some use
    for (const int vertices : options.numbers("--vertices", "10000,170000,544000")) run(vertices, repeat);
}
