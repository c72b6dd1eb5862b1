// Times SparseCholesky beside Eigen::SimplicialLDLT, one line of JSON per matrix. Built like the kernel,
// natively and for WebAssembly (then run by node).
//
//   solve_bench [--vertices 10000,50000] [--no-eigen-above 100000] [--repeat 3]

#include "lissom/solve/sparse_cholesky.h"

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

namespace {

using lissom::Columns;
using lissom::Points;
using lissom::SparseMatrix;

struct Surface {
    Points points;
    std::vector<std::vector<int>> rings; ///< 1-ring of each vertex, without itself
};

/// A closed bumpy sphere of about `vertices` points on a Fibonacci spiral would need a triangulation; a grid
/// of latitudes and longitudes with poles has a regular one, and 6 neighbours almost everywhere.
Surface bumpy_sphere(int vertices) {
    const int columns = std::max(8, static_cast<int>(std::sqrt(vertices * 2.0)));
    const int rows = std::max(4, vertices / columns);
    Surface s;
    s.points.resize(rows * columns, 3);
    s.rings.resize(rows * columns);
    const auto at = [&](int i, int j) { return i * columns + (j + columns) % columns; };
    for (int i = 0; i < rows; ++i)
        for (int j = 0; j < columns; ++j) {
            const double theta = M_PI * (i + 0.5) / rows, phi = 2 * M_PI * j / columns;
            const double r = 1 + 0.1 * std::sin(5 * theta) * std::cos(7 * phi);
            s.points.row(at(i, j)) << r * std::sin(theta) * std::cos(phi), r * std::sin(theta) * std::sin(phi),
                r * std::cos(theta);
            std::vector<int>& ring = s.rings[at(i, j)];
            ring = {at(i, j - 1), at(i, j + 1)};
            if (i > 0) {
                ring.push_back(at(i - 1, j));
                ring.push_back(at(i - 1, j + 1));
            }
            if (i + 1 < rows) {
                ring.push_back(at(i + 1, j));
                ring.push_back(at(i + 1, j - 1));
            }
        }
    return s;
}

/// LᵀL with the umbrella Laplacian and a little of the identity: the 2-ring, 19 non-zeros a row.
SparseMatrix squared_laplacian(const Surface& surface) {
    const int n = static_cast<int>(surface.rings.size());
    std::vector<Eigen::Triplet<double>> entries;
    for (int i = 0; i < n; ++i) {
        entries.emplace_back(i, i, static_cast<double>(surface.rings[i].size()));
        for (const int j : surface.rings[i])
            entries.emplace_back(i, j, -1);
    }
    SparseMatrix L(n, n), I(n, n);
    L.setFromTriplets(entries.begin(), entries.end());
    I.setIdentity();
    return SparseMatrix(L.transpose() * L) + 1e-3 * I;
}

/// AᵀA where a row of A joins the 1-rings of both ends of an edge, as the coherence of gradients does in
/// implicit Laplacian editing: 37 non-zeros a row.
SparseMatrix edge_coherence(const Surface& surface) {
    const int n = static_cast<int>(surface.rings.size());
    std::vector<Eigen::Triplet<double>> entries;
    int row = 0;
    for (int i = 0; i < n; ++i)
        for (const int j : surface.rings[i]) {
            if (j < i)
                continue;
            for (const int v : {i, j}) {
                const double sign = v == i ? 1 : -1;
                const auto& ring = surface.rings[v];
                entries.emplace_back(row, v, sign);
                for (std::size_t t = 0; t < ring.size(); ++t)
                    entries.emplace_back(row, ring[t], sign * std::sin(1.0 + ring[t] + 3.0 * t));
            }
            ++row;
        }
    SparseMatrix A(row, n), I(n, n);
    A.setFromTriplets(entries.begin(), entries.end());
    I.setIdentity();
    return SparseMatrix(A.transpose() * A) + 1e-3 * I;
}

template <class F>
double seconds(int repeat, const F& f) {
    double best = INFINITY;
    for (int r = 0; r < repeat; ++r) {
        const auto start = std::chrono::steady_clock::now();
        f();
        best = std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    }
    return best;
}

double residual(const SparseMatrix& A, const Columns& X, const Columns& B) {
    return (A * X - B).norm() / B.norm();
}

void compare(const char* name, const SparseMatrix& A, const Points& points, bool with_eigen, int repeat) {
    Columns B(A.rows(), 3);
    for (int i = 0; i < B.rows(); ++i)
        B.row(i) << std::sin(i), std::cos(2.0 * i), std::sin(3.0 * i + 1);

    std::unique_ptr<lissom::SparseCholesky> ours;
    const double analyze = seconds(1, [&] { ours = std::make_unique<lissom::SparseCholesky>(A, &points); });
    const double factor = seconds(repeat, [&] { ours->factorize(A); });
    Columns X;
    const double solve = seconds(2 * repeat, [&] {
        X = B;
        ours->solve(X);
    });
    std::printf("{\"matrix\":\"%s\",\"n\":%d,\"nnz_per_row\":%.1f,\"ordering\":\"%s\",\"entries\":%.0f,"
                "\"gflop\":%.2f,\"analyze\":%.3f,\"factor\":%.4f,\"gflops\":%.2f,\"solve3\":%.4f,\"residual\":%.1e",
                name, static_cast<int>(A.rows()), double(A.nonZeros()) / A.rows(), ours->ordering(),
                ours->factor_entries(), 2e-9 * ours->factor_work(), analyze, factor,
                2e-9 * ours->factor_work() / factor, solve, residual(A, X, B));
    ours.reset();
    if (with_eigen) {
        Eigen::SimplicialLDLT<SparseMatrix> eigen;
        const Eigen::MatrixXd right = B;
        Eigen::MatrixXd Y;
        const double eigen_analyze = seconds(1, [&] { eigen.analyzePattern(A); });
        const double eigen_factor = seconds(1, [&] { eigen.factorize(A); });
        const double eigen_solve = seconds(repeat, [&] { Y = eigen.solve(right); });
        std::printf(",\"eigen_analyze\":%.3f,\"eigen_factor\":%.4f,\"eigen_solve3\":%.4f,\"eigen_residual\":%.1e,"
                    "\"factor_ratio\":%.2f,\"total_ratio\":%.2f,\"solve_ratio\":%.2f",
                    eigen_analyze, eigen_factor, eigen_solve, residual(A, Y, B), eigen_factor / factor,
                    (eigen_analyze + eigen_factor) / (analyze + factor), eigen_solve / solve);
    }
    std::printf("}\n");
    std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv) {
    std::string sizes = "10000,50000";
    int eigen_limit = 100000, repeat = 3;
    for (int a = 1; a + 1 < argc; a += 2) {
        if (!std::strcmp(argv[a], "--vertices"))
            sizes = argv[a + 1];
        else if (!std::strcmp(argv[a], "--no-eigen-above"))
            eigen_limit = std::atoi(argv[a + 1]);
        else if (!std::strcmp(argv[a], "--repeat"))
            repeat = std::atoi(argv[a + 1]);
        else {
            std::fprintf(stderr, "solve_bench: unknown option %s\n", argv[a]);
            return 1;
        }
    }
    for (const char* at = sizes.c_str(); *at;) {
        char* end = nullptr;
        const int vertices = static_cast<int>(std::strtol(at, &end, 10));
        const Surface surface = bumpy_sphere(vertices);
        compare("squared-laplacian", squared_laplacian(surface), surface.points, vertices <= eigen_limit, repeat);
        compare("edge-coherence", edge_coherence(surface), surface.points, vertices <= eigen_limit, repeat);
        at = *end == ',' ? end + 1 : end;
        if (end == at && *end)
            break;
    }
    return 0;
}
