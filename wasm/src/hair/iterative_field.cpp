#include "lissom/hair/iterative_field.h"

#include "lissom/mesh/errors.h"

#include <string>

namespace lissom {

using Eigen::Index;

namespace {

constexpr double k_shift = 1e-3;       // α of the preconditioner
constexpr double k_tolerance = 1e-11;  // of the residual beside the right-hand side
constexpr int k_most_iterations = 3000;

/// The symmetric Neumann Laplacian over six, of each column (Fu 4.4.1).
Eigen::MatrixXd laplacian(const Eigen::MatrixXd& t, const Eigen::Vector3i& n) {
    Eigen::MatrixXd out = Eigen::MatrixXd::Zero(t.rows(), t.cols());
    const Index stride[3] = {1, n.x(), Index(n.x()) * n.y()};
    for (Index c = 0; c < t.cols(); ++c) {
        const double* from = t.col(c).data();
        double* to = out.col(c).data();
        Index at = 0;
        for (int z = 0; z < n.z(); ++z)
            for (int y = 0; y < n.y(); ++y)
                for (int x = 0; x < n.x(); ++x, ++at) {
                    double sum = 0;
                    if (x > 0) sum += from[at - stride[0]] - from[at];
                    if (x + 1 < n.x()) sum += from[at + stride[0]] - from[at];
                    if (y > 0) sum += from[at - stride[1]] - from[at];
                    if (y + 1 < n.y()) sum += from[at + stride[1]] - from[at];
                    if (z > 0) sum += from[at - stride[2]] - from[at];
                    if (z + 1 < n.z()) sum += from[at + stride[2]] - from[at];
                    to[at] = sum / 6;
                }
    }
    return out;
}

} // namespace

IterativeField::IterativeField(std::shared_ptr<const GridBilaplacian> operator_)
    : K_(std::move(operator_)), t_(Points::Zero(K_->size().prod(), 3)) {}

void IterativeField::set_constraints(std::span<const FieldConstraint> constraints) {
    const ConstraintChange change = constraint_change(held_, constraints, K_->size().prod());
    if (!held_.empty() && change.removed.size() == held_.size()) t_.setZero(); // nothing of it to start from
    held_.assign(constraints.begin(), constraints.end());
    iterations_ = 0;
    if (held_.empty()) {
        t_.setZero();
        return;
    }
    constexpr double w2 = weight * weight;
    const auto apply = [&](const Eigen::MatrixXd& x) { // Eq 4.3
        Eigen::MatrixXd y = laplacian(laplacian(x, K_->size()), K_->size());
        for (const FieldConstraint& c : held_) y.row(c.node) += w2 * x.row(c.node);
        return y;
    };
    Eigen::MatrixXd x = t_, r = -apply(x);
    double size = 0;
    for (const FieldConstraint& c : held_) {
        r.row(c.node) += w2 * c.vector.transpose();
        size += c.vector.squaredNorm();
    }
    const double enough = k_tolerance * w2 * std::sqrt(std::max(size, 1e-300));
    Eigen::MatrixXd z = K_->apply_inverse(r, k_shift), p = z;
    Eigen::RowVectorXd rz = r.cwiseProduct(z).colwise().sum();
    // The three components share their matrix, so they walk together, each with its own step.
    for (; r.norm() > enough; ++iterations_) {
        if (iterations_ == k_most_iterations)
            throw SolverFailure("The hair field did not settle after " + std::to_string(iterations_) +
                                " iterations; choose a coarser grid.");
        const Eigen::MatrixXd Ap = apply(p);
        const Eigen::RowVectorXd pAp = p.cwiseProduct(Ap).colwise().sum();
        const Eigen::RowVectorXd a = (pAp.array() > 0).select(rz.array() / pAp.array(), 0);
        x += p * a.asDiagonal();
        r -= Ap * a.asDiagonal();
        z = K_->apply_inverse(r, k_shift);
        const Eigen::RowVectorXd after = r.cwiseProduct(z).colwise().sum();
        const Eigen::RowVectorXd b = (rz.array() > 0).select(after.array() / rz.array(), 0);
        p = z + p * b.asDiagonal();
        rz = after;
    }
    t_ = x;
}

} // namespace lissom
