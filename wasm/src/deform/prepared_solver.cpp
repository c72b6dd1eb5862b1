#include "lissom/deform/prepared_solver.h"

#include "lissom/mesh/errors.h"

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
    return sizeof(double) * factor_.factor_entries() +
           entry * static_cast<double>(equations_.A.nonZeros() + equations_.G.nonZeros());
}

Columns PreparedSolver::solve(const Columns& w, const Columns* b) const {
    Columns x = -(equations_.G * w);
    if (b != nullptr) x += *b;
    if (x.rows() > 0) factor_.solve(x);
    return x;
}

} // namespace lissom
