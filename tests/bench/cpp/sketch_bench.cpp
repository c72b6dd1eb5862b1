// Times setting up a curve on a model and the lines of its views, one line of JSON per size: what is done once a mesh, what once a
// stroke, what once a view.
//
//   sketch_bench [--vertices 50000,170000,544000] [--repeat 8]

#include "egg.h"
#include "options.h"

#include "lissom/contour/contour_session.h"
#include "lissom/curve/extract.h"
#include "lissom/curve/line_weights.h"
#include "lissom/curve/region.h"
#include "lissom/curve/spline.h"
#include "lissom/mesh/stopwatch.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>

namespace {

using namespace lissom;

/// Along the egg, from end to end, seen from +z, 400 pixels long.
Stroke along_the_egg() {
    constexpr int places = 100;
    Stroke stroke;
    stroke.pixels.resize(places, 2);
    stroke.origins.resize(places, 3);
    stroke.directions.resize(places, 3);
    for (int i = 0; i < places; ++i) {
        const double y = -1.4 + 2.8 * i / (places - 1), x = 0.05 * std::sin(0.2 * i);
        stroke.pixels.row(i) << 140 * x, 140 * y;
        stroke.origins.row(i) << x, y, 10;
        stroke.directions.row(i) << 0, 0, -1;
    }
    return stroke;
}

void run(int vertices, int repeat, bool quiet = false) {
    const auto working = std::make_shared<WorkingMesh>(make_working_mesh(bench::bumpy_egg(vertices)));
    Stopwatch clock;
    const CurveSurface surface(working);
    const double once = clock.lap();
    const ExtractedCurve curve = extract_curve(surface, along_the_egg());
    const double extract = clock.lap();
    const CurveRegion region = curve_region(surface, SplineCurve(curve.controls), curve.radius, {.hits = curve.hits});
    const double regions = clock.lap();

    ContourSession session(working);
    while (session.step()) {
    }
    const double curvature = clock.lap();
    double view = INFINITY, slowest = 0;
    std::size_t lines = 0;
    for (int r = 0; r < repeat; ++r) {
        clock.lap();
        lines = session.lines({.perspective = true, .eye = {6 * std::cos(0.1 * r), 1, 6 * std::sin(0.1 * r)}}).size();
        const double seconds = clock.lap();
        view = std::min(view, seconds);
        slowest = std::max(slowest, seconds);
    }
    Polyline line;
    for (int k = 0; k <= 40; ++k) line.push_back({0.2 * std::sin(0.05 * k), -0.5 + 0.025 * k, 1});
    clock.lap();
    const std::size_t pulled = line_weights(surface, line, {}).vertices.size();
    const double weights = clock.lap();
    if (!quiet)
        std::printf("{\"vertices\":%d,\"surface_ms\":%.0f,\"extract_ms\":%.0f,\"region_ms\":%.0f,\"region\":%zu,\"setup_ms\":%.0f,\"curvature_ms\":%.0f,\"view_ms\":%.1f,\"slowest_ms\":%.1f,"
                    "\"lines\":%zu,\"views_per_s\":%.0f,\"weights_ms\":%.0f,\"pulled\":%zu}\n",
                    working->mesh.vertex_count(), 1e3 * once, 1e3 * extract, 1e3 * regions, region.vertices.size(), 1e3 * (once + extract + regions), 1e3 * curvature, 1e3 * view, 1e3 * slowest,
                    lines, 1 / view, 1e3 * weights, pulled);
    std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv) {
    const bench::Options options(argc, argv);
    run(5000, 20, true); // engines compile WebAssembly twice, well the second time and only after some use
    for (const int vertices : options.numbers("--vertices", "50000,170000,544000")) run(vertices, options.number("--repeat", 8));
}
