#include "lissom/deform/prepared_solver.h"

#include "lissom/mesh/errors.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace lissom {

PreparedSolver::PreparedSolver(NormalEquations equations, const Points& coordinates)
    : equations_(std::move(equations)), factor_(equations_.A, &coordinates) {
    begin();
}

void PreparedSolver::begin() {
    if (shift_ == 0) {
        factor_.begin(equations_.A);
        return;
    }
    const Eigen::VectorXd diagonal = equations_.A.diagonal();
    SparseMatrix raised = equations_.A;
    raised.diagonal() = (diagonal.array() + shift_ * diagonal.mean()).matrix();
    factor_.begin(raised);
}

bool PreparedSolver::step() {
    try {
        if (factor_.step()) return true;
        trial_error_ = try_out();
        equations_.A = SparseMatrix(); // only the factor is needed from here on
        ready_ = true;
        return false;
    } catch (const SolverFailure&) {
        if (shift_ >= 1e-6) throw;
        shift_ = shift_ == 0 ? 1e-10 : 100 * shift_;
        begin();
        return true;
    }
}

double PreparedSolver::memory_bytes() const {
    constexpr double entry = sizeof(double) + sizeof(int);
    const auto rows = rows_ ? rows_->left.nonZeros() + rows_->right.nonZeros() : 0;
    return sizeof(double) * factor_.factor_entries() +
           entry * static_cast<double>(equations_.A.nonZeros() + equations_.G.nonZeros() + rows);
}

Columns PreparedSolver::solve(const Columns& w, const Columns* b, bool is_final) const {
    Columns x = -(equations_.G * w);
    if (b != nullptr) x += *b;
    if (x.rows() == 0) return x;
    factor_.solve(x);
    if (rows_ && is_final) correct(x, w, b);
    return x;
}

/// One correction by the residual in the equations themselves: what it is short of, the rows' is of the same size.
double PreparedSolver::try_out() const {
    if (equations_.A.rows() == 0 || equations_.G.cols() == 0) return 0;
    Columns w(equations_.G.cols(), 3);
    Eigen::Matrix<double, 4, 3> map;
    map << 0.4, -0.3, 0.2, 0.5, -0.2, 0.3, -0.1, 0.4, 0.6, 0.2, 0.3, -0.5;
    for (Eigen::Index row = 0; row < w.rows(); ++row) w.row(row) = map.row(row % 4); // handles or not, four columns or not
    const Columns b = -(equations_.G * w);
    Columns x = b;
    factor_.solve(x);
    Columns change = b - equations_.A.selfadjointView<Eigen::Lower>() * x;
    factor_.solve(change);
    const double size = x.cwiseAbs().maxCoeff();
    return size > 0 ? change.cwiseAbs().maxCoeff() / size : 0;
}

void PreparedSolver::correct(Columns& x, const Columns& w, const Columns* b) const {
    Columns all(rows_->right.cols(), x.cols());
    all.bottomRows(w.rows()) = w;
    double before = std::numeric_limits<double>::infinity();
    for (int round = 0; round < k_rounds; ++round) {
        all.topRows(x.rows()) = x;
        const Columns sums = rows_->right * all;
        Columns change = -(rows_->left.transpose() * sums);
        if (b != nullptr) change += *b;
        factor_.solve(change);
        const double size = change.cwiseAbs().maxCoeff();
        if (!(size < 0.5 * before)) return; // it does not get better than this
        x += change;
        // Each correction leaves about the trial's share of itself.
        if (size * std::min(1.0, 10 * trial_error_) <= k_fine * x.cwiseAbs().maxCoeff()) return;
        before = size;
    }
}

} // namespace lissom
