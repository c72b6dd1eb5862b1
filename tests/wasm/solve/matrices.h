#pragma once

// Matrices to factor, all symmetric; both triangles are stored.

#include "lissom/solve/sparse_cholesky.h"

#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

namespace lissom::matrices {

/// A fixed sequence of numbers in [-1, 1) that looks random (xorshift).
class Sequence {
public:
    explicit Sequence(std::uint32_t seed) : state_(seed * 2654435761u + 1) {}
    double next() { return 2.0 * bits() / 4294967296.0 - 1; }
    int below(int n) { return static_cast<int>(bits() % static_cast<std::uint32_t>(n)); }

private:
    std::uint32_t bits() {
        state_ ^= state_ << 13;
        state_ ^= state_ >> 17;
        state_ ^= state_ << 5;
        return state_;
    }
    std::uint32_t state_;
};

inline Columns random_columns(int n, int k, std::uint32_t seed) {
    Sequence numbers(seed);
    Columns B(n, k);
    for (double& x : B.reshaped<Eigen::RowMajor>())
        x = numbers.next();
    return B;
}

/// A Laplacian of the given edges plus `shift` on the diagonal.
inline SparseMatrix laplacian(int n, const std::vector<std::pair<int, int>>& edges, double shift) {
    std::vector<Eigen::Triplet<double>> entries;
    for (int i = 0; i < n; ++i)
        entries.emplace_back(i, i, shift);
    for (const auto& [a, b] : edges)
        for (const auto& [i, j, value] : {std::tuple{a, a, 1}, {b, b, 1}, {a, b, -1}, {b, a, -1}})
            entries.emplace_back(i, j, value);
    SparseMatrix A(n, n);
    A.setFromTriplets(entries.begin(), entries.end());
    return A;
}

/// Grid points and the edges between neighbours; nz = 1 for a flat grid.
struct Grid {
    Points points;
    std::vector<std::pair<int, int>> edges;
};
inline Grid grid(int nx, int ny, int nz = 1) {
    Grid g;
    g.points.resize(nx * ny * nz, 3);
    const auto at = [&](int x, int y, int z) { return (z * ny + y) * nx + x; };
    for (int z = 0; z < nz; ++z)
        for (int y = 0; y < ny; ++y)
            for (int x = 0; x < nx; ++x) {
                g.points.row(at(x, y, z)) << x, y, z;
                if (x > 0)
                    g.edges.emplace_back(at(x - 1, y, z), at(x, y, z));
                if (y > 0)
                    g.edges.emplace_back(at(x, y - 1, z), at(x, y, z));
                if (z > 0)
                    g.edges.emplace_back(at(x, y, z - 1), at(x, y, z));
            }
    return g;
}

/// AᵀA + shift·I for an m×n A with `per_row` random entries a row.
inline SparseMatrix random_normal(int m, int n, int per_row, double shift, std::uint32_t seed) {
    Sequence numbers(seed);
    std::vector<Eigen::Triplet<double>> entries;
    for (int i = 0; i < m; ++i)
        for (int t = 0; t < per_row; ++t) {
            const int j = numbers.below(n);
            entries.emplace_back(i, j, numbers.next());
        }
    SparseMatrix A(m, n), I(n, n);
    A.setFromTriplets(entries.begin(), entries.end());
    I.setIdentity();
    return SparseMatrix(A.transpose() * A) + shift * I;
}

/// A with rows and columns renumbered: entry (i, j) goes to (to[i], to[j]).
inline SparseMatrix renumbered(const SparseMatrix& A, const std::vector<int>& to) {
    std::vector<Eigen::Triplet<double>> entries;
    for (int j = 0; j < A.cols(); ++j)
        for (SparseMatrix::InnerIterator e(A, j); e; ++e)
            entries.emplace_back(to[e.row()], to[j], e.value());
    SparseMatrix out(A.rows(), A.cols());
    out.setFromTriplets(entries.begin(), entries.end());
    return out;
}

inline std::vector<int> shuffled(int n, std::uint32_t seed) {
    Sequence numbers(seed);
    std::vector<int> order(n);
    for (int i = 0; i < n; ++i)
        order[i] = i;
    for (int i = n - 1; i > 0; --i)
        std::swap(order[i], order[numbers.below(i + 1)]);
    return order;
}

} // namespace lissom::matrices
