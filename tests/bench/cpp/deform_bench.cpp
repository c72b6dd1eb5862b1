// Times a deformation session from mesh to drag, one line of JSON per size, beside the same two matrices through
// Eigen::SimplicialLDLT. Built like the kernel, natively and for WebAssembly (then run by node).
//
//   deform_bench [--vertices 10000,50000,170000] [--no-eigen-above 100000] [--repeat 5]

#include "egg.h"
#include "options.h"

#include "lissom/deform/deform_session.h"
#include "lissom/deform/held_region.h"
#include "lissom/deform/implicit_system.h"
#include "lissom/deform/reconstruction.h"
#include "lissom/mesh/operators.h"
#include "lissom/mesh/stopwatch.h"

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <string>
#include <vector>

namespace {

using Eigen::Affine3d;
using lissom::DeformHandle;
using lissom::DeformResult;
using lissom::DeformSession;
using lissom::Points;
using lissom::SparseMatrix;
using lissom::WorkingMesh;

/// Every thousandth triangle gets a vertex 1e-4 of its edge from a corner: what costs the systems their digits.
void add_short_edges(lissom::PolygonMesh& mesh) {
    const int faces = mesh.face_count(), vertices = mesh.vertex_count();
    const int count = (faces + 999) / 1000;
    mesh.points.conservativeResize(vertices + count, 3);
    for (int k = 0; k < count; ++k) {
        const int t = 1000 * k, v = vertices + k;
        const int a = mesh.corners[3 * t], b = mesh.corners[3 * t + 1], c = mesh.corners[3 * t + 2];
        mesh.points.row(v) = (1 - 1e-4) * mesh.points.row(a) + 0.5e-4 * (mesh.points.row(b) + mesh.points.row(c));
        mesh.corners[3 * t + 2] = v;
        for (const int corner : {b, c, v, c, a, v}) mesh.corners.push_back(corner);
        for (int added = 0; added < 2; ++added) mesh.offsets.push_back(mesh.offsets.back() + 3);
    }
}

/// The two ends along y, a twentieth of its length each.
std::vector<DeformHandle> two_ends(const Points& points) {
    const double low = points.col(1).minCoeff(), high = points.col(1).maxCoeff();
    std::vector<DeformHandle> ends(2);
    for (int v = 0; v < points.rows(); ++v) {
        if (points(v, 1) < low + 0.05 * (high - low)) ends[0].vertices.push_back(v);
        if (points(v, 1) > high - 0.05 * (high - low)) ends[1].vertices.push_back(v);
    }
    return ends;
}

struct EigenTimes {
    double factor = 0, solve = INFINITY;
};

EigenTimes through_eigen(const SparseMatrix& A, int repeat) {
    Eigen::MatrixXd B(A.rows(), 3), X;
    for (int i = 0; i < B.rows(); ++i) B.row(i) << std::sin(i), std::cos(2.0 * i), std::sin(3.0 * i + 1);
    EigenTimes times;
    lissom::Stopwatch clock;
    const Eigen::SimplicialLDLT<SparseMatrix> ldlt(A); // reads the lower triangle
    times.factor = clock.lap();
    for (int r = 0; r < repeat; ++r) {
        clock.lap();
        X = ldlt.solve(B);
        times.solve = std::min(times.solve, clock.lap());
    }
    return times;
}

/// One line of JSON.
std::string measure(int free, bool with_short_edges, bool with_eigen, int repeat) {
    char line[1000];
    lissom::PolygonMesh mesh = bench::bumpy_egg(static_cast<int>(free / 0.95));
    if (with_short_edges) add_short_edges(mesh);
    const WorkingMesh working = lissom::make_working_mesh(mesh);
    std::vector<int> roi(static_cast<std::size_t>(mesh.vertex_count()));
    std::iota(roi.begin(), roi.end(), 0);
    const auto ends = two_ends(mesh.points);
    const std::vector<Affine3d> targets{Affine3d::Identity(),
                                        Affine3d(Eigen::Translation3d(0.3, -0.3, 0.1) * Eigen::AngleAxisd(1, Eigen::Vector3d(0, 0.6, 0.8)))};
    DeformSession session(working, roi, ends);
    while (session.step()) {
    }
    double step = INFINITY, preview = INFINITY;
    DeformResult best;
    for (int r = 0; r < repeat; ++r) {
        lissom::Stopwatch glance;
        (void)session.deform(targets, false);
        preview = std::min(preview, glance.lap());
        lissom::Stopwatch clock;
        DeformResult result = session.deform(targets);
        if (const double seconds = clock.lap(); seconds < step) {
            step = seconds;
            best = std::move(result);
        }
    }
    int used = std::snprintf(line, sizeof line, "{\"vertices\":%d,\"short_edges\":%d,\"corrected\":%d,\"free\":%d,\"assemble_s\":%.3f,\"factor_s\":%.3f,\"preview_ms\":%.1f,\"drag_ms\":%.1f,\"solve_ms\":%.1f,"
                "\"rotate_ms\":%.1f,\"reconstruct_ms\":%.1f,\"memory_mb\":%.0f",
                working.mesh.vertex_count(), with_short_edges, session.corrects(), session.free_vertices(), session.assemble_seconds(), session.factor_seconds(),
                1e3 * preview, 1e3 * step, 1e3 * best.solve_seconds, 1e3 * best.rotate_seconds, 1e3 * best.reconstruct_seconds,
                1e-6 * session.memory_bytes());
    if (with_eigen) {
        std::vector<lissom::Finding> warnings;
        const lissom::HeldRegion region = lissom::hold_region(working, lissom::assign_roles(working, roi, ends), 2, warnings);
        const SparseMatrix L = lissom::cotangent_laplacian(region.mesh);
        const Eigen::VectorXd areas = lissom::vertex_areas(region.mesh);
        const EigenTimes first = through_eigen(lissom::implicit_system(region, L, areas, 1).equations.A, repeat);
        const EigenTimes second = through_eigen(lissom::reconstruction(region, L, areas).equations.A, repeat);
        const double factor = first.factor + second.factor, solve = first.solve + second.solve;
        used += std::snprintf(line + used, sizeof line - used, ",\"eigen_factor_s\":%.3f,\"eigen_solve_ms\":%.1f,\"factor_ratio\":%.1f,\"solve_ratio\":%.1f,"
                    "\"drag_to_eigen_solve\":%.2f",
                    factor, 1e3 * solve, factor / session.factor_seconds(), solve / best.solve_seconds, step / solve);
    }
    return std::string(line, used) + "}";
}

/// Engines compile WebAssembly twice, well the second time and only after some use: both sides have it.
void warm_up() {
    for (int round = 0; round < 20; ++round) (void)measure(1500, false, true, 1);
}

} // namespace

int main(int argc, char** argv) {
    const bench::Options options(argc, argv);
    const int eigen_limit = options.number("--no-eigen-above", 100000), repeat = options.number("--repeat", 5);
    warm_up();
    for (const int free : options.numbers("--vertices", "10000,50000,170000")) {
        for (const bool with_short_edges : {false, true}) {
            std::printf("%s\n", measure(free, with_short_edges, free <= eigen_limit, repeat).c_str());
            std::fflush(stdout);
        }
    }
}
