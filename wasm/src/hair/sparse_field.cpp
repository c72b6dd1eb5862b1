#include "lissom/hair/sparse_field.h"

#include <algorithm>

namespace lissom {

namespace {

/// D of Fu Eq 4.2 with symmetric (Neumann) rows: the grid's graph Laplacian divided by 6.
SparseMatrix grid_laplacian(const Grid& grid) {
    std::vector<Eigen::Triplet<double>> entries;
    for (int node = 0; node < grid.count(); ++node) {
        const Eigen::Vector3i at = grid.cell(node);
        int stride = 1;
        for (int d = 0; d < 3; stride *= grid.size[d++]) {
            if (at[d] + 1 == grid.size[d]) continue;
            const int next = node + stride;
            for (const auto& [i, j, value] : {std::tuple(node, node, -1.0), {next, next, -1.0}, {node, next, 1.0}, {next, node, 1.0}})
                entries.emplace_back(i, j, value / 6);
        }
    }
    SparseMatrix D(grid.count(), grid.count());
    D.setFromTriplets(entries.begin(), entries.end());
    return D;
}

constexpr double k_weight_squared = FieldSolver::weight * FieldSolver::weight;

} // namespace

SparseField::SparseField(const Eigen::Vector3i& size) : grid_{Eigen::Vector3d::Zero(), 1, size} {
    const SparseMatrix D = grid_laplacian(grid_);
    DtD_ = D.transpose() * D;
}

SparseMatrix SparseField::system() const {
    SparseMatrix A = DtD_;
    for (const int node : weighted_) A.coeffRef(node, node) += k_weight_squared;
    return A;
}

Columns SparseField::right_side() const {
    Columns b = Columns::Zero(grid_.count(), 3);
    for (const FieldConstraint& c : held_) b.row(c.node) = k_weight_squared * c.vector.transpose();
    return b;
}

void SparseField::refactor() {
    if (weighted_.empty()) return;
    const SparseMatrix A = system();
    if (!analysis_) {
        Points places(grid_.count(), 3);
        for (int node = 0; node < grid_.count(); ++node) places.row(node) = grid_.position(node);
        analysis_.emplace(A, &places);
    }
    analysis_->factorize(A);
    factor_.emplace(*analysis_);
}

void SparseField::set_constraints(std::span<const FieldConstraint> constraints) {
    static_cast<void>(constraint_change(held_, constraints, grid_.count()));
    held_.assign(constraints.begin(), constraints.end());
    if (held_.empty()) return;

    std::vector<int> wanted, added, removed;
    for (const FieldConstraint& c : held_) wanted.push_back(c.node);
    std::sort(wanted.begin(), wanted.end());
    std::set_difference(wanted.begin(), wanted.end(), weighted_.begin(), weighted_.end(), std::back_inserter(added));
    std::set_difference(weighted_.begin(), weighted_.end(), wanted.begin(), wanted.end(), std::back_inserter(removed));
    weighted_ = std::move(wanted);
    if (!factor_) return refactor();
    factor_->update(added, weight);
    factor_->downdate(removed, weight);
}

Points SparseField::field() const {
    if (held_.empty()) return Points::Zero(grid_.count(), 3);
    const SparseMatrix A = system();
    const Columns b = right_side();
    Columns t = b;
    factor_->solve(t);
    Columns correction = b - A * t; // one step of refinement: what updates have left
    factor_->solve(correction);
    return t + correction;
}

double SparseField::residual() const {
    if (held_.empty()) return 0;
    const Columns b = right_side();
    return (system() * field() - b).norm() / b.norm();
}

} // namespace lissom
