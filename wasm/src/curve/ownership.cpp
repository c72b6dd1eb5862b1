#include "lissom/curve/ownership.h"

#include "lissom/mesh/operators.h"
#include "lissom/mesh/smooth.h"
#include "lissom/mesh/surface_paths.h"
#include "lissom/solve/sparse_cholesky.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <queue>

namespace lissom {

namespace {

constexpr double k_least = 1e-3; ///< what every share loses, so that the last of them end at nothing

/// Adds one vertex: the largest shares, summing to 1.
void close_vertex(OwnerShares& all, std::vector<std::pair<double, int>>& shares) {
    std::sort(shares.begin(), shares.end(), [](const auto& a, const auto& b) { return a.first != b.first ? a.first > b.first : a.second < b.second; });
    if (static_cast<int>(shares.size()) > OwnerShares::k_most) shares.resize(OwnerShares::k_most);
    double sum = 0;
    for (const auto& [share, owner] : shares) sum += share;
    for (const auto& [share, owner] : shares) {
        all.owners.push_back(owner);
        all.shares.push_back(shares.size() == 1 ? 1.0 : share / sum);
    }
    all.offsets.push_back(static_cast<int>(all.owners.size()));
}

} // namespace

OwnerShares whole_shares(std::span<const int> owner) {
    OwnerShares result;
    for (const int o : owner) {
        result.owners.push_back(o);
        result.shares.push_back(1);
        result.offsets.push_back(static_cast<int>(result.owners.size()));
    }
    return result;
}

OwnerShares diffused_shares(const TriangleMesh& mesh, std::span<const int> owner, std::span<const double> rho) {
    const int n = mesh.vertex_count();
    std::vector<int> names(owner.begin(), owner.end());
    std::sort(names.begin(), names.end());
    names.erase(std::unique(names.begin(), names.end()), names.end());
    const int columns = static_cast<int>(names.size());
    if (columns < 2) return whole_shares(owner);
    const auto column_of = [&](int name) { return static_cast<int>(std::lower_bound(names.begin(), names.end(), name) - names.begin()); };

    const Eigen::VectorXd areas = vertex_areas(mesh);
    SparseMatrix A = -cotangent_laplacian(mesh); // M + L_ρ
    Eigen::VectorXd diagonal = areas;
    for (int j = 0; j < n; ++j)
        for (SparseMatrix::InnerIterator entry(A, j); entry; ++entry) {
            if (entry.row() == j) continue;
            entry.valueRef() *= rho[entry.row()] * rho[j];
            diagonal[j] -= entry.value();
        }
    for (int v = 0; v < n; ++v) A.coeffRef(v, v) = diagonal[v];
    SparseCholesky solver(A, &mesh.points);
    solver.factorize(A);
    Columns w = Columns::Zero(n, columns);
    for (int v = 0; v < n; ++v) w(v, column_of(owner[v])) = areas[v];
    solver.solve(w);

    OwnerShares result;
    std::vector<std::pair<double, int>> shares;
    for (int v = 0; v < n; ++v) {
        shares.clear();
        for (int c = 0; c < columns; ++c)
            if (w(v, c) > k_least) shares.emplace_back(w(v, c) - k_least, names[c]);
        if (shares.empty()) shares.emplace_back(1, owner[v]); // a needle's weights may all be off
        close_vertex(result, shares);
    }
    return result;
}

OwnerShares geodesic_shares(const TriangleMesh& mesh, std::span<const int> owner, std::span<const double> rho) {
    const int n = mesh.vertex_count();
    const WeightedGraph graph = edge_graph(mesh);
    // From the middle of every edge that joins two owners: the way to the border, and whose vertices lie beyond it.
    std::vector<double> way(n, std::numeric_limits<double>::infinity());
    std::vector<int> other(n, -1);
    using Reached = std::pair<double, int>;
    std::priority_queue<Reached, std::vector<Reached>, std::greater<>> front;
    for (int v = 0; v < n; ++v)
        for (int e = graph.offsets[v]; e < graph.offsets[v + 1]; ++e) {
            const int u = graph.ends[e];
            if (owner[u] == owner[v] || graph.lengths[e] / 2 >= way[v]) continue;
            way[v] = graph.lengths[e] / 2;
            other[v] = owner[u];
        }
    for (int v = 0; v < n; ++v)
        if (other[v] >= 0) front.emplace(way[v], v);
    while (!front.empty()) {
        const auto [reached, v] = front.top();
        front.pop();
        if (reached > way[v] || reached > rho[v]) continue;
        for (int e = graph.offsets[v]; e < graph.offsets[v + 1]; ++e) {
            const int u = graph.ends[e];
            if (owner[u] != owner[v] || reached + graph.lengths[e] >= way[u]) continue;
            way[u] = reached + graph.lengths[e];
            other[u] = other[v];
            front.emplace(way[u], u);
        }
    }
    OwnerShares result;
    std::vector<std::pair<double, int>> shares;
    for (int v = 0; v < n; ++v) {
        const double own = other[v] < 0 || !(rho[v] > 0) ? 1 : smooth(0.5 + way[v] / (2 * rho[v]));
        shares.assign(1, {own, owner[v]});
        if (own < 1) shares.emplace_back(1 - own, other[v]);
        close_vertex(result, shares);
    }
    return result;
}

std::vector<int> joined_owners(const VertexRings& rings, std::vector<int> owner) {
    const int n = rings.vertex_count();
    std::vector<int> piece(n, -1);
    std::vector<int> size, of;
    std::vector<bool> touches;
    for (int seed = 0; seed < n; ++seed) {
        if (piece[seed] >= 0) continue;
        const int here = static_cast<int>(size.size());
        size.push_back(0);
        of.push_back(owner[seed]);
        touches.push_back(false);
        std::vector<int> front{seed};
        piece[seed] = here;
        while (!front.empty()) {
            const int v = front.back();
            front.pop_back();
            ++size[here];
            for (const int u : rings[v]) {
                if (owner[u] != owner[seed]) touches[here] = true;
                else if (piece[u] < 0) {
                    piece[u] = here;
                    front.push_back(u);
                }
            }
        }
    }
    std::map<int, int> main_piece; // of each owner
    for (int k = 0; k < static_cast<int>(size.size()); ++k) {
        const auto [found, fresh] = main_piece.emplace(of[k], k);
        if (!fresh && size[k] > size[found->second]) found->second = k;
    }
    std::vector<bool> stray(n);
    for (int v = 0; v < n; ++v) stray[v] = touches[piece[v]] && main_piece[of[piece[v]]] != piece[v];
    std::vector<int> front;
    for (int v = 0; v < n; ++v)
        if (!stray[v]) front.push_back(v);
    while (!front.empty()) { // rings around what stays, one after the other
        std::vector<int> next;
        for (const int v : front)
            for (const int u : rings[v])
                if (stray[u]) {
                    stray[u] = false;
                    owner[u] = owner[v];
                    next.push_back(u);
                }
        front = std::move(next);
    }
    return owner;
}

} // namespace lissom
