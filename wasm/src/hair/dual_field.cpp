#include "lissom/hair/dual_field.h"

#include <unordered_map>

namespace lissom {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3i;

namespace {

Vector3i cell(int node, const Vector3i& size) {
    return {node % size.x(), node / size.x() % size.y(), node / (size.x() * size.y())};
}

} // namespace

DualField::DualField(std::shared_ptr<const GridBilaplacian> operator_) : K_(std::move(operator_)), multipliers_(solve()) {}

void DualField::set_constraints(std::span<const FieldConstraint> constraints) {
    const ConstraintChange change = constraint_change(held_, constraints, K_->size().prod());
    if (!change.removed.empty()) {
        H_.remove(change.removed);
        std::size_t next = 0, to = 0;
        for (std::size_t from = 0; from < held_.size(); ++from) {
            if (next < change.removed.size() && change.removed[next] == static_cast<int>(from)) {
                ++next;
                continue;
            }
            held_[to] = held_[from];
            cells_[to++] = cells_[from];
        }
        held_.resize(to);
        cells_.resize(to);
    }
    std::vector<FieldConstraint> added;
    for (const int place : change.added) added.push_back(constraints[static_cast<std::size_t>(place)]);
    append(added);

    std::unordered_map<int, std::size_t> place_of;
    for (std::size_t i = 0; i < held_.size(); ++i) place_of.emplace(held_[i].node, i);
    for (const FieldConstraint& c : constraints) held_[place_of.at(c.node)].vector = c.vector;
    multipliers_ = solve();
}

void DualField::append(std::span<const FieldConstraint> added) {
    if (added.empty()) return;
    std::vector<Vector3i> fresh;
    for (const FieldConstraint& c : added) fresh.push_back(cell(c.node, K_->size()));
    MatrixXd diagonal = K_->green(fresh, fresh);
    diagonal.diagonal().array() += 1 / (weight * weight); // (★)
    H_.append(K_->green(fresh, cells_), diagonal);
    held_.insert(held_.end(), added.begin(), added.end());
    cells_.insert(cells_.end(), fresh.begin(), fresh.end());
}

DualField::Multipliers DualField::solve() const {
    const Index m = static_cast<Index>(held_.size());
    if (m == 0) return {MatrixXd(0, 3), Eigen::RowVector3d::Zero()};
    MatrixXd zu(m, 4); // H⁻¹ c and H⁻¹ 1 in one sweep
    for (Index i = 0; i < m; ++i) zu.row(i) << held_[static_cast<std::size_t>(i)].vector.transpose(), 1;
    H_.solve(zu);
    const Eigen::RowVector4d sums = zu.colwise().sum();
    const Eigen::RowVector3d a = sums.head<3>() / sums[3]; // from 1ᵀ l = 0
    return {zu.leftCols<3>() - zu.col(3) * a, a};
}

Points DualField::field() const {
    MatrixXd load = MatrixXd::Zero(K_->size().prod(), 3);
    for (std::size_t i = 0; i < held_.size(); ++i) load.row(held_[i].node) = multipliers_.l.row(static_cast<Index>(i));
    return (K_->apply_inverse(load)).rowwise() + multipliers_.a;
}

Points DualField::field_at(std::span<const int> nodes) const {
    std::vector<Vector3i> cells;
    for (const int node : nodes) cells.push_back(cell(node, K_->size()));
    return (K_->green(cells, cells_) * multipliers_.l).rowwise() + multipliers_.a;
}

double DualField::residual() const {
    const Index m = static_cast<Index>(held_.size());
    if (m == 0) return 0;
    MatrixXd c(m, 3);
    for (Index i = 0; i < m; ++i) c.row(i) = held_[static_cast<std::size_t>(i)].vector.transpose();
    const MatrixXd Hl = K_->green(cells_, cells_) * multipliers_.l + multipliers_.l / (weight * weight);
    return ((Hl - c).rowwise() + multipliers_.a).norm() / c.norm();
}

} // namespace lissom
