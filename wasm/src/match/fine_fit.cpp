#include "lissom/match/fine_fit.h"

#include "lissom/match/smoothing_rings.h"

#include <algorithm>

namespace lissom {

namespace {

/// Of a held vertex against the mean of 1: what the move it is given pulls its surroundings by.
constexpr double k_held = 1e4;
/// What nothing pulls and nothing around it either stays.
constexpr double k_keep_place = 1e-9;

SparseMatrix lower_bilaplacian(const TriangleMesh& mesh) {
    const VertexRings rings = smoothing_rings(mesh);
    const int n = mesh.vertex_count();
    std::vector<Eigen::Triplet<double>> entries;
    for (int v = 0; v < n; ++v) {
        entries.emplace_back(v, v, 1.0);
        for (const int w : rings[v]) entries.emplace_back(v, w, -1.0 / static_cast<double>(rings[v].size()));
        if (rings[v].empty()) entries.back() = {v, v, 0.0};
    }
    SparseMatrix L(n, n);
    L.setFromTriplets(entries.begin(), entries.end());
    SparseMatrix places(n, n); // of edges and of the diagonal, whether or not L reaches them
    entries.clear();
    for (int v = 0; v < n; ++v) entries.emplace_back(v, v, 0.0);
    for (const Edge& e : edges(mesh)) entries.emplace_back(e.b, e.a, 0.0);
    places.setFromTriplets(entries.begin(), entries.end());
    const SparseMatrix squared = L.transpose() * L;
    SparseMatrix lower = SparseMatrix(squared.triangularView<Eigen::Lower>()) + places;
    lower.makeCompressed();
    return lower;
}

} // namespace

FineFit::FineFit(const TriangleMesh& mesh) : bilaplacian_(lower_bilaplacian(mesh)), A_(bilaplacian_), factor_(A_, &mesh.points) {}

Points FineFit::solve(const Points& points, std::span<const Pull> pulls, std::span<const Held> held, double stiffness) {
    const int n = static_cast<int>(points.rows());
    A_ = stiffness * bilaplacian_;
    Columns right = Columns::Zero(n, 3);
    const auto entry = [&](int i, int j) -> double& {
        const auto [column, row] = std::minmax(i, j);
        const int* first = A_.innerIndexPtr() + A_.outerIndexPtr()[column];
        const int* last = A_.innerIndexPtr() + A_.outerIndexPtr()[column + 1];
        return A_.valuePtr()[std::lower_bound(first, last, row) - A_.innerIndexPtr()];
    };
    const auto on_diagonal = [&](int v) -> double& { return A_.valuePtr()[A_.outerIndexPtr()[v]]; };
    for (int v = 0; v < n; ++v) on_diagonal(v) += k_keep_place;
    for (const Pull& pull : pulls) {
        if (pull.is_vertex()) {
            const int v = pull.vertices[0];
            on_diagonal(v) += pull.weight;
            right.row(v) += pull.weight * (pull.target.transpose() - points.row(v));
            continue;
        }
        Eigen::RowVector3d left = pull.target.transpose();
        for (int k = 0; k < 3; ++k) left -= pull.weights[k] * points.row(pull.vertices[k]);
        for (int k = 0; k < 3; ++k) {
            right.row(pull.vertices[k]) += pull.weight * pull.weights[k] * left;
            for (int l = 0; l <= k; ++l) entry(pull.vertices[k], pull.vertices[l]) += pull.weight * pull.weights[k] * pull.weights[l];
        }
    }
    for (const auto& [vertex, target] : held) {
        on_diagonal(vertex) += k_held;
        right.row(vertex) += k_held * (target.transpose() - points.row(vertex));
    }
    factor_.factorize(A_);
    factor_.solve(right);
    Points moves = right;
    for (const auto& [vertex, target] : held) moves.row(vertex) = target.transpose() - points.row(vertex);
    return moves;
}

} // namespace lissom
