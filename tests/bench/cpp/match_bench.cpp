// Times a match from models to skins, one line of JSON per case: two eggs cut differently with markers, three of them at once, and an egg grown over a much
// finer one without markers. The longest slice is what a cancel waits for. Built like the kernel, natively and for WebAssembly.
//
//   match_bench [--vertices 5000,15000]

#include "egg.h"
#include "options.h"

#include "lissom/match/match_session.h"
#include "lissom/mesh/stopwatch.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

namespace {

using lissom::Points;
using lissom::WorkingMesh;

constexpr int k_scan_vertices = 134000;

/// An egg that is bent, so that no two are alike.
WorkingMesh egg(int vertices, double bend) {
    lissom::PolygonMesh mesh = bench::bumpy_egg(vertices);
    for (Eigen::Index v = 0; v < mesh.points.rows(); ++v) {
        const double y = mesh.points(v, 1);
        mesh.points(v, 0) += bend * y * y;
        mesh.points(v, 2) *= 1 + bend * y;
    }
    return make_working_mesh(mesh);
}

/// Where the six half axes leave an egg, and the eight directions between: the same places on all.
Points markers(double bend) {
    Points places(14, 3);
    int at = 0;
    for (int x = -1; x <= 1; ++x)
        for (int y = -1; y <= 1; ++y)
            for (int z = -1; z <= 1; ++z)
                if (const int axes = std::abs(x) + std::abs(y) + std::abs(z); axes == 1 || axes == 3) {
                    Eigen::RowVector3d d = Eigen::RowVector3d(x, y, z).normalized();
                    d *= 1 + 0.1 * std::sin(5 * d[0]) * std::cos(7 * d[1] + 3 * d[2]);
                    d[1] *= 2;
                    places.row(at++) = Eigen::RowVector3d(d[0] + bend * d[1] * d[1], d[1], d[2] * (1 + bend * d[1]));
                }
    return places;
}

void measure(const char* name, const std::vector<lissom::MatchModel>& models, const lissom::MatchOptions& options) {
    lissom::Stopwatch clock, slice;
    lissom::MatchSession session(models, options);
    double longest = slice.lap();
    for (bool more = true; more;) {
        more = session.step();
        longest = std::max(longest, slice.lap());
    }
    const lissom::MatchResult found = session.result();
    const double seconds = clock.lap();
    const lissom::MatchSeconds& parts = found.report.seconds;
    const lissom::SurfaceDistances& last = found.report.skins.back().distances;
    std::printf(R"({"match":"%s","models":%d,"skin vertices":%d,"seconds":%.2f,"start":%.2f,"carry":%.2f,"fine":%.2f,"edges":%.2f,"report":%.2f,"longest slice ms":%.0f,"mean":%.5f,"p99":%.5f})"
                "\n",
                name, static_cast<int>(models.size()), found.skins.vertex_count(), seconds, parts.start, parts.carry, parts.fine, parts.connectivity, parts.report, 1e3 * longest,
                std::max(last.mean_there, last.mean_back), last.most);
}

} // namespace

int main(int argc, char** argv) {
    const bench::Options options(argc, argv);
    for (const int vertices : options.numbers("--vertices", "5000,15000")) {
        if (vertices > 20000) continue; // sizes that other programs are asked for
        const WorkingMesh source = egg(vertices, 0), second = egg(vertices * 7 / 8, 0.08), third = egg(vertices * 9 / 8, -0.06);
        measure("two", {{&source, markers(0)}, {&second, markers(0.08)}}, {});
        measure("three", {{&source, markers(0)}, {&second, markers(0.08)}, {&third, markers(-0.06)}}, {});
    }
    const WorkingMesh ball = egg(10242, 0), scan = egg(k_scan_vertices, 0.05);
    measure("onto a scan", {{&ball, Points(0, 3)}, {&scan, Points(0, 3)}}, {.connectivity = false});
}
