// Times SparseCholesky beside Eigen::SimplicialLDLT, one line of JSON per matrix. Built like the kernel,
// natively and for WebAssembly (then run by node).
//
//   solve_bench [--vertices 10000,50000] [--no-eigen-above 100000] [--repeat 3]

#include "options.h"

#include "lissom/solve/sparse_cholesky.h"
#include "lissom/mesh/stopwatch.h"

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <memory>
#include <set>
#include <vector>

namespace {

using lissom::Columns;
using lissom::Points;
using lissom::SparseMatrix;

struct Surface {
    Points points;
    std::vector<std::vector<int>> rings; ///< 1-ring of each vertex, without itself
};

/// A closed bumpy sphere of about `vertices` points: a cube's surface, cut into triangles and blown up. Six
/// neighbours almost everywhere, edges of similar length, like a remeshed scan.
Surface bumpy_sphere(int vertices) {
    const int m = std::max(2, static_cast<int>(std::lround(std::sqrt(vertices / 6.0))));
    std::map<std::array<int, 3>, int> index; // of the lattice points on the cube
    std::vector<std::set<int>> rings;
    std::vector<Eigen::Vector3d> points;
    const auto at = [&](const std::array<int, 3>& lattice) {
        const auto [found, is_new] = index.try_emplace(lattice, static_cast<int>(points.size()));
        if (is_new) {
            Eigen::Vector3d x;
            for (int a = 0; a < 3; ++a) // equal angles rather than equal lengths on the cube
                x[a] = std::tan(0.25 * M_PI * (2.0 * lattice[a] / m - 1));
            x.normalize();
            points.push_back(x * (1 + 0.1 * std::sin(5 * x[0]) * std::cos(7 * x[1] + 3 * x[2])));
            rings.emplace_back();
        }
        return found->second;
    };
    const auto join = [&](int i, int j) {
        rings[i].insert(j);
        rings[j].insert(i);
    };
    for (int axis = 0; axis < 3; ++axis)
        for (const int side : {0, m})
            for (int u = 0; u < m; ++u)
                for (int v = 0; v < m; ++v) {
                    const auto corner = [&](int du, int dv) {
                        std::array<int, 3> lattice;
                        lattice[axis] = side;
                        lattice[(axis + 1) % 3] = u + du;
                        lattice[(axis + 2) % 3] = v + dv;
                        return at(lattice);
                    };
                    join(corner(0, 0), corner(1, 0));
                    join(corner(0, 0), corner(0, 1));
                    join(corner(1, 0), corner(1, 1));
                    join(corner(0, 1), corner(1, 1));
                    join(corner(0, 0), corner(1, 1));
                }
    Surface s;
    s.points.resize(static_cast<int>(points.size()), 3);
    for (std::size_t i = 0; i < points.size(); ++i) {
        s.points.row(static_cast<int>(i)) = points[i];
        s.rings.emplace_back(rings[i].begin(), rings[i].end());
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
        lissom::Stopwatch watch;
        f();
        best = std::min(best, watch.lap());
    }
    return best;
}

double residual(const SparseMatrix& A, const Columns& X, const Columns& B) {
    return (A * X - B).norm() / B.norm();
}

struct Timing {
    double analyze = 0, factor = 0, solve = 0, residual = 0;
};

Columns right_hand_sides(int n) {
    Columns B(n, 3);
    for (int i = 0; i < n; ++i)
        B.row(i) << std::sin(i), std::cos(2.0 * i), std::sin(3.0 * i + 1);
    return B;
}

Timing time_ours(lissom::SparseCholesky& ours, const SparseMatrix& A, const Points& points, int repeat) {
    const Columns B = right_hand_sides(static_cast<int>(A.rows()));
    Columns X;
    Timing t;
    t.analyze = seconds(repeat, [&] { ours = lissom::SparseCholesky(A, &points); });
    t.factor = seconds(repeat, [&] { ours.factorize(A); });
    t.solve = seconds(3 * repeat, [&] {
        X = B;
        ours.solve(X);
    });
    t.residual = residual(A, X, B);
    return t;
}

Timing time_eigen(const SparseMatrix& A, int repeat) {
    const Eigen::MatrixXd B = right_hand_sides(static_cast<int>(A.rows()));
    Eigen::MatrixXd X;
    Eigen::SimplicialLDLT<SparseMatrix> eigen;
    Timing t;
    t.analyze = seconds(repeat, [&] { eigen.analyzePattern(A); });
    t.factor = seconds(repeat, [&] { eigen.factorize(A); });
    t.solve = seconds(3 * repeat, [&] { X = eigen.solve(B); });
    t.residual = residual(A, X, B);
    return t;
}

void compare(const char* name, const SparseMatrix& A, const Points& points, bool with_eigen, int repeat) {
    lissom::SparseCholesky ours(A, &points);
    const Timing t = time_ours(ours, A, points, repeat);
    std::printf("{\"matrix\":\"%s\",\"n\":%d,\"per_row\":%.1f,\"ordering\":\"%s\",\"entries\":%.0f,"
                "\"gflop\":%.2f,\"analyze_s\":%.3f,\"factor_s\":%.3f,\"solve3_ms\":%.1f,\"residual\":%.0e",
                name, static_cast<int>(A.rows()), static_cast<double>(A.nonZeros()) / A.rows(), ours.ordering(),
                ours.factor_entries(), 2e-9 * ours.factor_work(), t.analyze, t.factor, 1e3 * t.solve, t.residual);
    if (with_eigen) {
        const Timing e = time_eigen(A, std::max(1, repeat / 2));
        std::printf(",\"eigen_analyze_s\":%.3f,\"eigen_factor_s\":%.3f,\"eigen_solve3_ms\":%.1f,"
                    "\"eigen_residual\":%.0e,\"factor_ratio\":%.1f,\"prepare_ratio\":%.1f,\"solve_ratio\":%.1f",
                    e.analyze, e.factor, 1e3 * e.solve, e.residual, e.factor / t.factor,
                    (e.analyze + e.factor) / (t.analyze + t.factor), e.solve / t.solve);
    }
    std::printf("}\n");
    std::fflush(stdout);
}

/// Engines compile WebAssembly twice, well the second time and only after some use: both sides have it.
void warm_up() {
    const Surface surface = bumpy_sphere(2000);
    const SparseMatrix A = edge_coherence(surface);
    lissom::SparseCholesky ours(A);
    for (int round = 0; round < 20; ++round) {
        time_ours(ours, A, surface.points, 1);
        time_eigen(A, 1);
    }
}

} // namespace

int main(int argc, char** argv) {
    const bench::Options options(argc, argv);
    const int eigen_limit = options.number("--no-eigen-above", 100000), repeat = options.number("--repeat", 3);
    warm_up();
    for (const int vertices : options.numbers("--vertices", "10000,50000")) {
        const Surface surface = bumpy_sphere(vertices);
        compare("squared-laplacian", squared_laplacian(surface), surface.points, vertices <= eigen_limit, repeat);
        compare("edge-coherence", edge_coherence(surface), surface.points, vertices <= eigen_limit, repeat);
    }
}
