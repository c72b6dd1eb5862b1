#include "lissom/match/affine_fit.h"

#include <algorithm>
#include <utility>

namespace lissom {

using Eigen::Matrix4d;
using Eigen::Vector3d;
using Eigen::Vector4d;

namespace {

constexpr double k_keep_shape = 1e-4; // of λ: what nothing decides stays as at rest
constexpr double k_keep_place = 1e-6; // of a node's own data: what nothing pulls stays where it was

const Vector4d k_linear{1, 1, 1, 0}; // the part of a node's unknowns that is A

} // namespace

AffineFit::AffineFit(Points rest, const Triangles& triangles, const NodeGraph& graph, const Points& now) : rest_(std::move(rest)), graph_(graph), carried_offsets_{0} {
    const double r = graph.radius();
    for (int v = 0; v < rest_.rows(); ++v) {
        for (const auto& [node, weight] : graph.bindings(v)) {
            Basis basis;
            basis << (rest_.row(v) - rest_.row(graph.nodes()[node])).transpose() / r, 1;
            carried_.push_back({node, weight * basis});
        }
        carried_offsets_.push_back(static_cast<int>(carried_.size()));
    }
    unknowns_.resize(4 * graph.count(), 3);
    for (int g = 0; g < graph.count(); ++g) {
        unknowns_.middleRows<3>(4 * g) = r * Eigen::Matrix3d::Identity();
        unknowns_.row(4 * g + 3) = now.row(graph.nodes()[g]);
    }
    set_pattern(triangles);
}

void AffineFit::set_pattern(const Triangles& triangles) {
    std::vector<std::pair<int, int>> all; // (column, row), row ≥ column
    const auto couple = [](std::vector<std::pair<int, int>>& to, std::vector<int>& nodes) {
        std::sort(nodes.begin(), nodes.end());
        nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
        for (std::size_t i = 0; i < nodes.size(); ++i)
            for (std::size_t j = i; j < nodes.size(); ++j) to.emplace_back(nodes[i], nodes[j]);
    };
    const auto tidy = [](std::vector<std::pair<int, int>>& list) {
        std::sort(list.begin(), list.end());
        list.erase(std::unique(list.begin(), list.end()), list.end());
    };
    std::vector<int> nodes;
    for (int v = 0; v < rest_.rows(); ++v) {
        nodes.clear();
        for (const auto& binding : graph_.bindings(v)) nodes.push_back(binding.node);
        couple(pairs_, nodes);
    }
    tidy(pairs_);
    for (int t = 0; t < triangles.rows(); ++t) {
        nodes.clear();
        for (const int v : triangles.row(t))
            for (const auto& binding : graph_.bindings(v)) nodes.push_back(binding.node);
        couple(all, nodes);
        if (all.size() > 4000000) tidy(all);
    }
    all.insert(all.end(), pairs_.begin(), pairs_.end());
    for (int g = 0; g < graph_.count(); ++g) all.emplace_back(g, g);
    tidy(all);
    std::erase_if(pairs_, [](const auto& pair) { return pair.first == pair.second; });

    columns_.assign(static_cast<std::size_t>(graph_.count()) + 1, 0);
    for (const auto& [column, row] : all) {
        ++columns_[column + 1];
        rows_.push_back(row);
    }
    for (int g = 0; g < graph_.count(); ++g) columns_[g + 1] += columns_[g];
    blocks_.resize(rows_.size());

    std::vector<Eigen::Triplet<double>> entries;
    Points places(4 * graph_.count(), 3);
    for (int g = 0; g < graph_.count(); ++g) {
        places.middleRows<4>(4 * g).rowwise() = rest_.row(graph_.nodes()[g]);
        for (int b = columns_[g]; b < columns_[g + 1]; ++b)
            for (int j = 0; j < 4; ++j)
                for (int i = rows_[b] == g ? j : 0; i < 4; ++i) entries.emplace_back(4 * rows_[b] + i, 4 * g + j, 0.0);
    }
    A_.resize(4 * graph_.count(), 4 * graph_.count());
    A_.setFromTriplets(entries.begin(), entries.end());
    if (graph_.count() > 0) factor_.emplace(A_, &places);
}

int AffineFit::block(int row, int column) const {
    const auto first = rows_.begin() + columns_[column], last = rows_.begin() + columns_[column + 1];
    return static_cast<int>(std::lower_bound(first, last, row) - rows_.begin());
}

/// The nodes that carry the place of a pull, ascending.
void AffineFit::gather(const Pull& pull, std::vector<Carried>& carried) const {
    carried.clear();
    for (int k = 0; k < (pull.is_vertex() ? 1 : 3); ++k)
        for (int c = carried_offsets_[pull.vertices[k]]; c < carried_offsets_[pull.vertices[k] + 1]; ++c) {
            const Carried part{carried_[c].node, (pull.is_vertex() ? 1 : pull.weights[k]) * carried_[c].basis};
            const auto at = std::lower_bound(carried.begin(), carried.end(), part.node, [](const Carried& a, int node) { return a.node < node; });
            if (at != carried.end() && at->node == part.node) at->basis += part.basis;
            else carried.insert(at, part);
        }
}

Points AffineFit::solve(std::span<const Pull> pulls, double stiffness) {
    const int n = graph_.count();
    if (n == 0) return rest_;
    const double r = graph_.radius();
    for (Matrix4d& block : blocks_) block.setZero();
    Columns right = Columns::Zero(4 * n, 3);
    double squares = 0; // of what is aimed at: the minimum of |M u − y|² is |y|² − u·Mᵀy

    double whole = 0;
    for (const Pull& pull : pulls) whole += pull.weight;
    std::vector<Carried> carried;
    for (const Pull& pull : pulls) {
        const double weight = n / whole * pull.weight;
        if (!(weight > 0)) continue;
        squares += weight * pull.target.squaredNorm();
        gather(pull, carried);
        for (std::size_t p = 0; p < carried.size(); ++p) {
            const Vector4d weighted = weight * carried[p].basis;
            right.middleRows<4>(4 * carried[p].node).noalias() += weighted * pull.target.transpose();
            for (std::size_t q = 0; q <= p; ++q) blocks_[block(carried[p].node, carried[q].node)].noalias() += weighted * carried[q].basis.transpose();
        }
    }

    const double of_pairs = pairs_.empty() ? 0 : stiffness * n / static_cast<double>(pairs_.size());
    const Vector4d place = Vector4d::Unit(3);
    const Matrix4d alike = k_linear.asDiagonal();
    for (const auto& [g, h] : pairs_) { // g < h
        Vector4d way;
        way << (rest_.row(graph_.nodes()[h]) - rest_.row(graph_.nodes()[g])).transpose() / r, 1;
        Vector4d back = -way;
        back[3] = 1;
        // f_g(h) − t_h, f_h(g) − t_g and A_g − A_h
        blocks_[block(g, g)] += of_pairs * (way * way.transpose() + place * place.transpose() + alike);
        blocks_[block(h, h)] += of_pairs * (back * back.transpose() + place * place.transpose() + alike);
        blocks_[block(h, g)] -= of_pairs * (place * way.transpose() + back * place.transpose() + alike);
    }
    for (int g = 0; g < n; ++g) {
        Matrix4d& own = blocks_[block(g, g)];
        own += k_keep_shape * stiffness * alike;
        own(3, 3) += k_keep_place;
        right.middleRows<3>(4 * g) += k_keep_shape * stiffness * r * Eigen::Matrix3d::Identity();
        right.row(4 * g + 3) += k_keep_place * unknowns_.row(4 * g + 3);
        squares += 3 * k_keep_shape * stiffness * r * r + k_keep_place * unknowns_.row(4 * g + 3).squaredNorm();
    }
    write_values();
    factor_->factorize(A_);
    unknowns_ = right;
    factor_->solve(unknowns_);
    energy_ = std::max(0.0, squares - unknowns_.cwiseProduct(right).sum()) / n;

    Points moved = Points::Zero(rest_.rows(), 3);
    for (int v = 0; v < moved.rows(); ++v)
        for (int c = carried_offsets_[v]; c < carried_offsets_[v + 1]; ++c)
            moved.row(v).noalias() += carried_[c].basis.transpose() * unknowns_.middleRows<4>(4 * carried_[c].node);
    return moved;
}

/// Of the blocks, in the order of the matrix: its columns hold the blocks' columns one below another.
void AffineFit::write_values() {
    double* value = A_.valuePtr();
    for (int g = 0; g < graph_.count(); ++g)
        for (int j = 0; j < 4; ++j)
            for (int b = columns_[g]; b < columns_[g + 1]; ++b)
                for (int i = rows_[b] == g ? j : 0; i < 4; ++i) *value++ = blocks_[b](i, j);
}

} // namespace lissom
