#include "lissom/solve/sparse_cholesky.h"

#include "elimination_tree.h"
#include "front.h"
#include "ordering.h"
#include "panel_values.h"
#include "sweeps.h"

#include "lissom/mesh/errors.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace lissom {

namespace {

using solve::EliminationTree;
using solve::Factor;
using solve::Front;
using solve::Graph;
using solve::PanelShape;
using solve::Supernodes;

EliminationTree best_tree(const Graph& graph, const Points* coordinates, const char*& ordering) {
    EliminationTree tree = elimination_tree(graph, solve::minimum_degree_order(graph));
    ordering = "minimum-degree";
    if (coordinates) {
        EliminationTree other = elimination_tree(graph, solve::nested_dissection_order(graph, *coordinates));
        if (other.work < tree.work) {
            tree = std::move(other);
            ordering = "nested-dissection";
        }
    }
    return tree;
}

SolverFailure not_positive(double pivot, int column, int n) {
    std::ostringstream message;
    message << "the matrix is not positive definite: pivot " << pivot << " in column " << column << " (matrix of "
            << n << " columns)";
    return SolverFailure(message.str());
}

} // namespace

/// The multifrontal method: supernodes are factored children first, each in a dense front of its own that
/// takes in A's values and the children's updates, and leaves an update for its parent.
///
/// Source: Liu, "The multifrontal method for sparse matrix solution: theory and practice", SIAM Review 34(1),
///         1992.
struct SparseCholesky::State {
    int n;
    const char* ordering = "";
    Factor factor;
    solve::PanelValues values;
    double entries = 0, work = 0;

    // Updates that wait for their parents. A child is always one level deeper, so two stacks, taken in turn
    // by depth, never have to move what they hold.
    std::unique_ptr<double[]> stacks[2];
    std::size_t tops[2] = {0, 0};
    std::size_t stack_sizes[2] = {0, 0};

    enum class Stage { idle, running, finished } stage = Stage::idle;
    int node = 0;   ///< supernode at work
    int column = 0; ///< in it; a multiple of the block width
    double done = 0;

    State(const SparseMatrix& A, const Points* coordinates);
    void lay_out();
    void begin(const SparseMatrix& A);
    void factor_one_block();
    void assemble(const Front& front);

    [[nodiscard]] std::size_t update_size(int s) const {
        return solve::triangle_size(factor.supernodes.height(s));
    }
    /// Children of s, last first, as they lie on their stack: f(child).
    template <class F>
    void for_each_child(int s, const F& f) const {
        const std::vector<int>& first = factor.supernodes.first_descendant;
        for (int c = s - 1; c >= first[s]; c = first[c] - 1)
            f(c);
    }
};

SparseCholesky::State::State(const SparseMatrix& A, const Points* coordinates) : n(static_cast<int>(A.cols())) {
    const Graph graph = solve::graph_of_lower_triangle(A);
    factor.supernodes = solve::supernodes(graph, best_tree(graph, coordinates, ordering));
    values = solve::PanelValues(A, factor.supernodes);
    lay_out();
}

void SparseCholesky::State::lay_out() {
    const Supernodes& nodes = factor.supernodes;
    std::size_t offset = 0, top[2] = {0, 0};
    for (int s = 0; s < nodes.count(); ++s) {
        const PanelShape shape = factor.shape(s);
        factor.panel_offsets.push_back(offset);
        offset += shape.size();
        for (int begin = 0; begin < shape.width; begin += solve::k_block_columns)
            work += solve::block_work(shape, begin);
        const int own = nodes.depth[s] % 2;
        top[own] += update_size(s);
        stack_sizes[own] = std::max(stack_sizes[own], top[own]);
        for_each_child(s, [&](int c) { top[1 - own] -= update_size(c); });
    }
    entries = static_cast<double>(offset);
}

void SparseCholesky::State::begin(const SparseMatrix& A) {
    stage = Stage::idle;
    values.take(A);
    if (!factor.numbers)
        factor.numbers.reset(new double[static_cast<std::size_t>(entries)]);
    for (const int i : {0, 1}) {
        if (!stacks[i])
            stacks[i].reset(new double[stack_sizes[i]]);
        tops[i] = 0;
    }
    node = column = 0;
    done = 0;
    stage = Stage::running;
}

void SparseCholesky::State::assemble(const Front& front) {
    const Supernodes& nodes = factor.supernodes;
    std::fill_n(front.panel, front.shape.size(), 0.0);
    std::fill_n(front.update, update_size(node), 0.0);
    values.place(node, front.panel);
    const int other = 1 - nodes.depth[node] % 2;
    for_each_child(node, [&](int c) {
        tops[other] -= update_size(c);
        solve::extend_add(front, stacks[other].get() + tops[other], nodes.height(c), nodes.places_of(c));
    });
}

void SparseCholesky::State::factor_one_block() {
    const Supernodes& nodes = factor.supernodes;
    const int own = nodes.depth[node] % 2;
    const Front front = {factor.shape(node), factor.numbers.get() + factor.panel_offsets[node],
                         stacks[own].get() + tops[own]};
    if (column == 0)
        assemble(front);
    const solve::Breakdown breakdown = solve::factor_block(front, column);
    if (breakdown.column >= 0) {
        stage = Stage::idle;
        throw not_positive(breakdown.pivot, nodes.order[nodes.first[node] + breakdown.column], n);
    }
    done += solve::block_work(front.shape, column);
    column += solve::k_block_columns;
    if (column < front.shape.width)
        return;
    tops[own] += update_size(node);
    column = 0;
    ++node;
}

SparseCholesky::SparseCholesky(const SparseMatrix& A, const Points* coordinates) {
    if (A.rows() != A.cols())
        throw InvalidInput("not-square", "SparseCholesky: the matrix has " + std::to_string(A.rows()) +
                                             " rows but " + std::to_string(A.cols()) + " columns");
    if (coordinates && coordinates->rows() != A.rows())
        throw InvalidInput("wrong-size", "SparseCholesky: " + std::to_string(coordinates->rows()) +
                                             " coordinates for " + std::to_string(A.rows()) + " unknowns");
    state_ = std::make_unique<State>(A, coordinates);
}

SparseCholesky::~SparseCholesky() = default;
SparseCholesky::SparseCholesky(SparseCholesky&&) noexcept = default;
SparseCholesky& SparseCholesky::operator=(SparseCholesky&&) noexcept = default;

void SparseCholesky::begin(const SparseMatrix& A) { state_->begin(A); }

bool SparseCholesky::step(double work) {
    State& s = *state_;
    if (s.stage != State::Stage::running)
        return false;
    const int count = s.factor.supernodes.count();
    const double until = s.done + work;
    do {
        if (s.node < count)
            s.factor_one_block();
    } while (s.node < count && s.done < until);
    if (s.node < count)
        return true;
    s.stage = State::Stage::finished;
    for (auto& stack : s.stacks) // as large as a good part of the factor, and of no more use
        stack.reset();
    return false;
}

double SparseCholesky::fraction() const {
    const State& s = *state_;
    if (s.stage == State::Stage::finished)
        return 1;
    return s.work > 0 ? std::min(1.0, s.done / s.work) : 0;
}

void SparseCholesky::factorize(const SparseMatrix& A) {
    begin(A);
    step(INFINITY);
}

void SparseCholesky::solve(Eigen::Ref<Columns> B) const {
    const State& s = *state_;
    if (s.stage != State::Stage::finished)
        throw SolverFailure("SparseCholesky::solve: the factorization is not finished");
    if (B.rows() != s.n)
        throw InvalidInput("wrong-size", "SparseCholesky::solve: " + std::to_string(B.rows()) +
                                             " rows on the right for " + std::to_string(s.n) + " unknowns");
    const std::vector<int>& order = s.factor.supernodes.order;
    for (Eigen::Index from = 0; from < B.cols(); from += 4) {
        const int k = static_cast<int>(std::min<Eigen::Index>(B.cols() - from, 4));
        Columns X(s.n, k);
        for (int i = 0; i < s.n; ++i)
            X.row(i) = B.row(order[i]).segment(from, k);
        solve::solve_sweeps(s.factor, X.data(), k);
        for (int i = 0; i < s.n; ++i)
            B.row(order[i]).segment(from, k) = X.row(i);
    }
    if (!B.allFinite())
        throw SolverFailure("SparseCholesky::solve: the solution is not finite; look at the right-hand side (matrix "
                            "of " + std::to_string(s.n) + " columns)");
}

LowerTriangle SparseCholesky::lower_triangle() const {
    const State& s = *state_;
    if (s.stage != State::Stage::finished)
        throw SolverFailure("SparseCholesky::lower_triangle: the factorization is not finished");
    const Supernodes& nodes = s.factor.supernodes;
    LowerTriangle L{nodes.order, {0}, {}, {}};
    L.rows.reserve(static_cast<std::size_t>(s.entries));
    L.values.reserve(static_cast<std::size_t>(s.entries));
    for (int k = 0; k < nodes.count(); ++k) {
        const PanelShape shape = s.factor.shape(k);
        const double* panel = s.factor.numbers.get() + s.factor.panel_offsets[k];
        for (int j = 0; j < shape.width; ++j) {
            for (int i = j; i < shape.width + shape.height; ++i) {
                const double value = panel[shape.at(i, j)];
                L.rows.push_back(i < shape.width ? nodes.first[k] + i : nodes.rows_of(k)[i - shape.width]);
                L.values.push_back(i == j ? 1 / value : value); // the panel keeps reciprocals there
            }
            L.offsets.push_back(L.rows.size());
        }
    }
    return L;
}

int SparseCholesky::size() const { return state_->n; }
double SparseCholesky::factor_entries() const { return state_->entries; }
double SparseCholesky::factor_work() const { return state_->work; }
const char* SparseCholesky::ordering() const { return state_->ordering; }

} // namespace lissom
