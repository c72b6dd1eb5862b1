#include "lissom/hair/iterative_field.h"

#include "lissom/mesh/errors.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>

namespace lissom {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::RowVectorXd;
using Eigen::Vector3i;

namespace {

constexpr double k_tolerance = 1e-10;  // of the residual beside the constraints
constexpr int k_most_iterations = 500;
constexpr int k_modes = 6;             // smoothest modes per axis that are taken exactly
constexpr int k_overlap = 2;           // grid steps that neighbourhoods reach into each other
constexpr std::size_t k_core = 400;    // constraints of a neighbourhood before the overlap

std::vector<Vector3i> cells_of(const std::vector<FieldConstraint>& constraints, const Vector3i& n) {
    std::vector<Vector3i> cells;
    for (const FieldConstraint& c : constraints)
        cells.push_back({c.node % n.x(), c.node / n.x() % n.y(), c.node / (n.x() * n.y())});
    return cells;
}

/// Halves a set of nodes across its longest side until every part is small.
void split(std::vector<int> part, const std::vector<Vector3i>& cells, std::vector<std::vector<int>>& out) {
    if (part.size() <= k_core) {
        if (!part.empty()) out.push_back(std::move(part));
        return;
    }
    Vector3i low = cells[static_cast<std::size_t>(part[0])], high = low;
    for (const int i : part) {
        low = low.cwiseMin(cells[static_cast<std::size_t>(i)]);
        high = high.cwiseMax(cells[static_cast<std::size_t>(i)]);
    }
    int axis = 0;
    (high - low).maxCoeff(&axis);
    const auto middle = part.begin() + static_cast<std::ptrdiff_t>(part.size() / 2);
    std::nth_element(part.begin(), middle, part.end(), [&](int a, int b) {
        const int u = cells[static_cast<std::size_t>(a)][axis], v = cells[static_cast<std::size_t>(b)][axis];
        return u != v ? u < v : a < b;
    });
    split({part.begin(), middle}, cells, out);
    split({middle, part.end()}, cells, out);
}

} // namespace

class IterativeField::Preconditioner {
public:
    Preconditioner(const GridBilaplacian& K, const std::vector<Vector3i>& cells) {
        const GridBilaplacian::Modes modes = K.smoothest(cells, k_modes);
        std::vector<int> all(cells.size());
        for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<int>(i);
        std::vector<std::vector<int>> cores;
        split(std::move(all), cells, cores);
        for (std::vector<int>& core : cores) add(K, cells, modes, core);

        // H = H_rest + Φ Λ⁻¹ Φᵀ; the constant has no stiffness at all, so multipliers keep 1ᵀ l = 0.
        smooth_ = local(modes.values);
        const MatrixXd inner = modes.values.transpose() * smooth_;
        Eigen::VectorXd stiffness(modes.inverse.size());
        for (Index k = 0; k < stiffness.size(); ++k) stiffness[k] = modes.inverse[k] > 0 ? 1 / modes.inverse[k] : 0;
        coarse_.compute(inner + MatrixXd(stiffness.asDiagonal()));
        phi_ = modes.values;
    }

    [[nodiscard]] MatrixXd operator()(const MatrixXd& r) const {
        const MatrixXd s = local(r);
        return s - smooth_ * coarse_.solve(phi_.transpose() * s);
    }

private:
    struct Neighbourhood {
        std::vector<int> rows;
        Eigen::LLT<MatrixXd> factor;
    };

    void add(const GridBilaplacian& K, const std::vector<Vector3i>& cells, const GridBilaplacian::Modes& modes,
             const std::vector<int>& core) {
        std::map<std::array<int, 3>, char> reached;
        for (const int i : core) {
            const Vector3i& c = cells[static_cast<std::size_t>(i)];
            for (int z = -k_overlap; z <= k_overlap; ++z)
                for (int y = -k_overlap; y <= k_overlap; ++y)
                    for (int x = -k_overlap; x <= k_overlap; ++x) reached[{c.x() + x, c.y() + y, c.z() + z}] = 1;
        }
        Neighbourhood here;
        std::vector<Vector3i> nodes;
        for (std::size_t i = 0; i < cells.size(); ++i)
            if (reached.count({cells[i].x(), cells[i].y(), cells[i].z()})) {
                here.rows.push_back(static_cast<int>(i));
                nodes.push_back(cells[i]);
            }
        MatrixXd phi(static_cast<Index>(nodes.size()), modes.values.cols());
        for (std::size_t i = 0; i < nodes.size(); ++i) phi.row(static_cast<Index>(i)) = modes.values.row(here.rows[i]);
        MatrixXd rest = K.green(nodes, nodes) - phi * modes.inverse.asDiagonal() * phi.transpose();
        rest.diagonal().array() += 1 / (weight * weight);
        here.factor.compute(rest);
        if (here.factor.info() != Eigen::Success)
            throw SolverFailure("A neighbourhood of " + std::to_string(nodes.size()) + " hair constraints could not be factored.");
        neighbourhoods_.push_back(std::move(here));
    }

    [[nodiscard]] MatrixXd local(const MatrixXd& r) const {
        MatrixXd out = MatrixXd::Zero(r.rows(), r.cols());
        for (const Neighbourhood& here : neighbourhoods_) {
            MatrixXd part(static_cast<Index>(here.rows.size()), r.cols());
            for (std::size_t i = 0; i < here.rows.size(); ++i) part.row(static_cast<Index>(i)) = r.row(here.rows[i]);
            here.factor.solveInPlace(part);
            for (std::size_t i = 0; i < here.rows.size(); ++i) out.row(here.rows[i]) += part.row(static_cast<Index>(i));
        }
        return out;
    }

    std::vector<Neighbourhood> neighbourhoods_;
    MatrixXd phi_, smooth_; // the modes, and the neighbourhoods' answer to them
    Eigen::PartialPivLU<MatrixXd> coarse_;
};

IterativeField::IterativeField(std::shared_ptr<const GridBilaplacian> operator_) : K_(std::move(operator_)), l_(0, 3) {}
IterativeField::~IterativeField() = default;

MatrixXd IterativeField::spread(const MatrixXd& l) const {
    MatrixXd load = MatrixXd::Zero(K_->size().prod(), l.cols());
    for (std::size_t i = 0; i < held_.size(); ++i) load.row(held_[i].node) = l.row(static_cast<Index>(i));
    return K_->apply_inverse(load);
}

void IterativeField::set_constraints(std::span<const FieldConstraint> constraints) {
    const ConstraintChange change = constraint_change(held_, constraints, K_->size().prod());
    std::map<int, Eigen::RowVector3d> known;
    for (std::size_t i = 0; i < held_.size(); ++i) known[held_[i].node] = l_.row(static_cast<Index>(i));
    held_.assign(constraints.begin(), constraints.end());
    std::sort(held_.begin(), held_.end(), [](const auto& a, const auto& b) { return a.node < b.node; });
    iterations_ = 0;
    const Index m = static_cast<Index>(held_.size());
    l_ = MatrixXd::Zero(m, 3);
    a_.setZero();
    if (m == 0) {
        preconditioner_.reset();
        return;
    }
    if (!preconditioner_ || !change.added.empty() || !change.removed.empty())
        preconditioner_ = std::make_unique<Preconditioner>(*K_, cells_of(held_, K_->size()));

    MatrixXd c(m, 3);
    for (Index i = 0; i < m; ++i) {
        c.row(i) = held_[static_cast<std::size_t>(i)].vector.transpose();
        if (const auto at = known.find(held_[static_cast<std::size_t>(i)].node); at != known.end()) l_.row(i) = at->second;
    }
    const auto centred = [](MatrixXd x) -> MatrixXd { return x.rowwise() - x.colwise().mean(); };
    const auto apply = [&](const MatrixXd& l) { // (G_CC + I/ω²) l
        const MatrixXd t = spread(l);
        MatrixXd out = l / (weight * weight);
        for (Index i = 0; i < m; ++i) out.row(i) += t.row(held_[static_cast<std::size_t>(i)].node);
        return out;
    };
    l_ = centred(l_);
    MatrixXd r = c - apply(l_);
    // In the space of 1ᵀ l = 0 the constant part a is whatever mean the residual has.
    const double enough = k_tolerance * std::max(c.norm(), 1e-300);
    MatrixXd z = centred((*preconditioner_)(centred(r))), p = z;
    RowVectorXd rz = r.cwiseProduct(z).colwise().sum();
    for (; centred(r).norm() > enough; ++iterations_) {
        if (iterations_ == k_most_iterations)
            throw SolverFailure("The hair field did not settle after " + std::to_string(iterations_) +
                                " iterations; choose a coarser grid.");
        const MatrixXd Hp = apply(p);
        // The three components share their matrix, so they walk together, each with its own step.
        const RowVectorXd pHp = p.cwiseProduct(Hp).colwise().sum();
        const RowVectorXd step = (pHp.array() > 0).select(rz.array() / pHp.array(), 0);
        l_ += p * step.asDiagonal();
        r -= Hp * step.asDiagonal();
        z = centred((*preconditioner_)(centred(r)));
        const RowVectorXd after = r.cwiseProduct(z).colwise().sum();
        const RowVectorXd turn = (rz.array() > 0).select(after.array() / rz.array(), 0);
        p = z + p * turn.asDiagonal();
        rz = after;
    }
    a_ = r.colwise().mean();
}

Points IterativeField::field() const {
    if (held_.empty()) return Points::Zero(K_->size().prod(), 3);
    return spread(l_).rowwise() + a_;
}

} // namespace lissom
