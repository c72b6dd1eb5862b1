// Times the isoline method from mesh to frame, one line of JSON per size and number of handles: once per mesh, once per set of
// handles, one iteration, and beside it one iteration of the unreduced method. Built like the kernel, natively and for WebAssembly.
//
//   isoline_bench [--vertices 10000,50000,170000,1000000] [--handles 3,4] [--no-full-above 200000] [--repeat 20]

#include "egg.h"
#include "options.h"

#include "lissom/isoline/full_pass.h"
#include "lissom/isoline/isoline_session.h"
#include "lissom/mesh/stopwatch.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <string>
#include <vector>

#ifdef __EMSCRIPTEN__
#include <unistd.h>

#include <cstdint>
#endif

namespace {

using Eigen::Affine3d;
using lissom::DeformHandle;
using lissom::IsolineModel;
using lissom::IsolineSession;
using lissom::Points;

/// Caps at +y, −y, then around the waist.
std::vector<DeformHandle> caps(const Points& points, int count) {
    std::vector<DeformHandle> handles(static_cast<std::size_t>(count));
    std::vector<Eigen::Vector3d> directions{{0, 1, 0}, {0, -1, 0}};
    for (int h = 2; h < count; ++h) {
        const double angle = 2 * M_PI * (h - 2) / std::max(1, count - 2);
        directions.emplace_back(std::cos(angle), 0.3 * (h % 2), std::sin(angle));
    }
    for (int v = 0; v < points.rows(); ++v)
        for (int h = 0; h < count; ++h)
            if (points.row(v).normalized().dot(directions[static_cast<std::size_t>(h)]) > 0.97) handles[static_cast<std::size_t>(h)].vertices.push_back(v);
    return handles;
}

std::vector<Affine3d> targets(int count, double share) {
    std::vector<Affine3d> maps;
    for (int h = 0; h < count; ++h)
        maps.emplace_back(Eigen::Translation3d(0.3 * share * h, -0.1 * share, 0.1 * share) * Eigen::AngleAxisd(share * 0.4 * h, Eigen::Vector3d(0, 0.6, 0.8)));
    return maps;
}

/// Bytes that the program holds at most, as far as it can tell.
double peak_bytes() {
#ifdef __EMSCRIPTEN__
    return static_cast<double>(reinterpret_cast<std::uintptr_t>(sbrk(0)));
#else
    return 0;
#endif
}

std::string measure(const lissom::WorkingMesh& working, const IsolineModel& model, int handles, bool full, int repeat) {
    std::vector<int> roi(working.working_of_source.size());
    std::iota(roi.begin(), roi.end(), 0);
    const auto held = caps(working.source, handles);
    lissom::Stopwatch clock;
    IsolineSession session(model, roi, held);
    while (session.step()) {
    }
    const double setup = clock.lap();
    double iteration = INFINITY, frame = INFINITY;
    for (int r = 0; r < repeat; ++r) {
        clock.lap();
        const lissom::IsolineFrame done = session.drag(targets(handles, 0.5 + 0.5 * r / repeat));
        const double seconds = clock.lap();
        frame = std::min(frame, seconds);
        iteration = std::min(iteration, seconds / done.solves);
    }
    clock.lap();
    const Points moved = session.positions();
    const double blend = clock.lap();
    const lissom::IsolineMemory announced = lissom::estimate_isoline_memory(working.mesh.vertex_count(), working.mesh.triangle_count(), handles);
    char line[1000];
    int used = std::snprintf(line, sizeof line,
                             "{\"vertices\":%d,\"handles\":%d,\"unknowns\":%d,\"model_s\":%.2f,\"setup_s\":%.2f,\"fields_s\":%.2f,\"reduce_s\":%.2f,\"iteration_ms\":%.3f,"
                             "\"frame_ms\":%.2f,\"blend_ms\":%.0f,\"peak_mb\":%.0f,\"announced_mb\":%.0f",
                             working.mesh.vertex_count(), handles, session.unknowns(), model.seconds(), setup, session.seconds().fields, session.seconds().reduce,
                             1e3 * iteration, 1e3 * frame, 1e3 * blend, 1e-6 * peak_bytes(), 1e-6 * std::max(announced.model, announced.session));
    if (full) {
        clock.lap();
        lissom::FullPass pass(working, roi, held);
        while (pass.step()) {
        }
        const double prepare = clock.lap();
        (void)pass.apply(moved, targets(handles, 1));
        const double once = clock.lap();
        used += std::snprintf(line + used, sizeof line - used, ",\"full_prepare_s\":%.2f,\"full_iteration_ms\":%.0f,\"ratio\":%.0f", prepare, 1e3 * once, once / iteration);
    }
    return std::string(line, used) + "}";
}

void run(int vertices, const std::vector<int>& counts, bool full, int repeat, bool quiet = false) {
    const lissom::WorkingMesh working = lissom::make_working_mesh(bench::bumpy_egg(vertices));
    IsolineModel model(working);
    while (model.step()) {
    }
    for (const int handles : counts) {
        const std::string line = measure(working, model, handles, full, repeat);
        if (!quiet) std::printf("%s\n", line.c_str());
        std::fflush(stdout);
    }
}

} // namespace

int main(int argc, char** argv) {
    const bench::Options options(argc, argv);
    const int limit = options.number("--no-full-above", 200000), repeat = options.number("--repeat", 20);
    run(5000, {3}, true, 200, true); // engines compile WebAssembly twice, well the second time and only after some use
    for (const int vertices : options.numbers("--vertices", "10000,50000,170000,1000000"))
        run(vertices, options.numbers("--handles", "3,4"), vertices <= limit, repeat);
}
