#include "lissom/solve/sparse_cholesky.h"

#include "elimination_tree.h"
#include "front.h"
#include "ordering.h"
#include "sweeps.h"

#include "lissom/mesh/errors.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <sstream>

namespace lissom {

namespace {

using solve::EliminationTree;
using solve::Factor;
using solve::for_each_lower;
using solve::Front;
using solve::Graph;
using solve::PanelShape;
using solve::Supernodes;

/// A number that two patterns share only if they are the same (FNV-1a over rows and columns).
class PatternHash {
public:
    void add(int row, int column) {
        hash_ = (hash_ ^ static_cast<std::uint32_t>(row)) * 0x100000001b3u;
        hash_ = (hash_ ^ static_cast<std::uint32_t>(column)) * 0x100000001b3u;
    }
    bool operator==(const PatternHash&) const = default;

private:
    std::uint64_t hash_ = 0xcbf29ce484222325u;
};

EliminationTree best_tree(const Graph& graph, const Points* coordinates, const char*& ordering) {
    EliminationTree tree = elimination_tree(graph, solve::minimum_degree_order(graph));
    ordering = "minimum-degree";
    if (coordinates) {
        EliminationTree other = elimination_tree(graph, nested_dissection_order(graph, *coordinates));
        if (other.work < tree.work) {
            tree = std::move(other);
            ordering = "nested-dissection";
        }
    }
    return tree;
}

std::string number(double value) {
    std::ostringstream out;
    out << value;
    return out.str();
}

std::string sized(const std::string& message, int n) {
    return message + " (matrix of " + std::to_string(n) + " columns)";
}

} // namespace

struct SparseCholesky::State {
    int n = 0;
    const char* ordering = "";
    Factor factor;
    double entries = 0, work = 0;

    // Values of A by supernode, and where each goes in its panel.
    PatternHash pattern;
    std::vector<int> slots; ///< per entry of A's lower triangle: index into the next two
    std::vector<double> values;
    std::vector<std::uint32_t> destinations;
    std::vector<std::size_t> value_offsets; ///< per supernode

    // Updates that wait for their parents: a child is always one level deeper, so two stacks, taken in turn
    // by depth, never have to move what they hold.
    std::unique_ptr<double[]> stacks[2];
    std::size_t tops[2] = {0, 0};
    std::size_t stack_sizes[2] = {0, 0};

    enum class Stage { idle, running, finished } stage = Stage::idle;
    int node = 0;   ///< supernode at work
    int column = 0; ///< in it; a multiple of the block width
    double done = 0;

    State(const SparseMatrix& A, const Points* coordinates);
    void find_offsets();
    void map_values(const SparseMatrix& A);
    void take_values(const SparseMatrix& A);
    void assemble();
    void factor_one_block();
    [[nodiscard]] Front front() const;
    [[nodiscard]] std::size_t update_size(int s) const {
        return solve::triangle_size(factor.supernodes.height(s));
    }
};

SparseCholesky::State::State(const SparseMatrix& A, const Points* coordinates) : n(static_cast<int>(A.cols())) {
    const Graph graph = solve::graph_of_lower_triangle(A);
    factor.supernodes = solve::supernodes(graph, best_tree(graph, coordinates, ordering));
    find_offsets();
    map_values(A);
}

void SparseCholesky::State::find_offsets() {
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
        for (int c = s - 1; c >= nodes.first_descendant[s]; c = nodes.first_descendant[c] - 1)
            top[1 - own] -= update_size(c);
    }
    entries = static_cast<double>(offset);
}

void SparseCholesky::State::map_values(const SparseMatrix& A) {
    const Supernodes& nodes = factor.supernodes;
    std::vector<int> node_of(n);
    for (int s = 0; s < nodes.count(); ++s)
        std::fill(node_of.begin() + nodes.first[s], node_of.begin() + nodes.first[s + 1], s);

    value_offsets.assign(nodes.count() + 1, 0);
    const auto column_of = [&](int i, int j) { return std::min(nodes.inverse[i], nodes.inverse[j]); };
    for_each_lower(A, [&](int i, int j, double) {
        pattern.add(i, j);
        ++value_offsets[node_of[column_of(i, j)] + 1];
    });
    for (int s = 0; s < nodes.count(); ++s)
        value_offsets[s + 1] += value_offsets[s];

    std::vector<std::size_t> next(value_offsets.begin(), value_offsets.end() - 1);
    std::vector<int> rows(value_offsets.back()), columns(value_offsets.back());
    slots.reserve(value_offsets.back());
    for_each_lower(A, [&](int i, int j, double) {
        const int k = column_of(i, j);
        const std::size_t slot = next[node_of[k]]++;
        slots.push_back(static_cast<int>(slot));
        columns[slot] = k;
        rows[slot] = std::max(nodes.inverse[i], nodes.inverse[j]);
    });

    destinations.resize(value_offsets.back());
    std::vector<int> place(n);
    for (int s = 0; s < nodes.count(); ++s) {
        const PanelShape shape = factor.shape(s);
        for (int k = 0; k < shape.width; ++k)
            place[nodes.first[s] + k] = k;
        for (int k = 0; k < shape.height; ++k)
            place[nodes.rows_of(s)[k]] = shape.width + k;
        for (std::size_t slot = value_offsets[s]; slot < value_offsets[s + 1]; ++slot)
            destinations[slot] = static_cast<std::uint32_t>(
                shape.at(place[rows[slot]], columns[slot] - nodes.first[s]));
    }
}

void SparseCholesky::State::take_values(const SparseMatrix& A) {
    PatternHash given;
    if (A.rows() == n && A.cols() == n)
        for_each_lower(A, [&](int i, int j, double) { given.add(i, j); });
    if (A.rows() != n || A.cols() != n || given != pattern)
        throw InvalidInput("pattern-changed", "SparseCholesky::begin: the matrix has other non-zeros than the "
                                              "one analyzed; analyze it again");
    values.resize(slots.size());
    std::size_t t = 0;
    for_each_lower(A, [&](int i, int j, double value) {
        if (!std::isfinite(value))
            throw SolverFailure(sized("the matrix holds " + number(value) + " in row " + std::to_string(i) +
                                          ", column " + std::to_string(j), n));
        values[slots[t++]] = value;
    });
}

Front SparseCholesky::State::front() const {
    const int own = factor.supernodes.depth[node] % 2;
    return {factor.shape(node), factor.numbers.get() + factor.panel_offsets[node], stacks[own].get() + tops[own]};
}

/// Fills the front at work with A's values and the updates of its children, which top the other stack.
void SparseCholesky::State::assemble() {
    const Supernodes& nodes = factor.supernodes;
    const Front target = front();
    std::fill_n(target.panel, target.shape.size(), 0.0);
    std::fill_n(target.update, update_size(node), 0.0);
    for (std::size_t slot = value_offsets[node]; slot < value_offsets[node + 1]; ++slot)
        target.panel[destinations[slot]] = values[slot];
    const int other = 1 - nodes.depth[node] % 2;
    for (int c = node - 1; c >= nodes.first_descendant[node]; c = nodes.first_descendant[c] - 1) {
        tops[other] -= update_size(c);
        solve::extend_add(target, stacks[other].get() + tops[other], nodes.height(c), nodes.places_of(c));
    }
}

void SparseCholesky::State::factor_one_block() {
    const Supernodes& nodes = factor.supernodes;
    if (column == 0)
        assemble();
    const Front target = front();
    const solve::Breakdown breakdown = solve::factor_block(target, column);
    if (breakdown.column >= 0) {
        stage = Stage::idle;
        throw SolverFailure(sized("the matrix is not positive definite: pivot " + number(breakdown.pivot) +
                                      " in column " + std::to_string(nodes.order[nodes.first[node] + breakdown.column]), n));
    }
    done += solve::block_work(target.shape, column);
    column += solve::k_block_columns;
    if (column < target.shape.width)
        return;
    tops[nodes.depth[node] % 2] += update_size(node);
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

void SparseCholesky::begin(const SparseMatrix& A) {
    State& s = *state_;
    s.stage = State::Stage::idle;
    s.take_values(A);
    if (!s.factor.numbers)
        s.factor.numbers.reset(new double[static_cast<std::size_t>(s.entries)]);
    for (int i : {0, 1}) {
        if (!s.stacks[i])
            s.stacks[i].reset(new double[s.stack_sizes[i]]);
        s.tops[i] = 0;
    }
    s.node = s.column = 0;
    s.done = 0;
    s.stage = State::Stage::running;
}

bool SparseCholesky::step(double work) {
    State& s = *state_;
    if (s.stage != State::Stage::running)
        return false;
    const double until = s.done + work;
    while (s.node < s.factor.supernodes.count()) {
        s.factor_one_block();
        if (s.done >= until)
            break;
    }
    if (s.node < s.factor.supernodes.count())
        return true;
    s.stage = State::Stage::finished;
    for (auto& stack : s.stacks) // as large as a good part of the factor, and of no more use
        stack.reset();
    return false;
}

double SparseCholesky::fraction() const {
    const State& s = *state_;
    return s.stage == State::Stage::finished ? 1 : s.work > 0 ? std::min(1.0, s.done / s.work) : 0;
}

void SparseCholesky::factorize(const SparseMatrix& A) {
    begin(A);
    while (step(INFINITY))
        ;
}

void SparseCholesky::solve(Eigen::Ref<Columns> B) const {
    const State& s = *state_;
    if (s.stage != State::Stage::finished)
        throw SolverFailure(sized("solve needs a finished factorization", s.n));
    if (B.rows() != s.n)
        throw InvalidInput("wrong-size", "SparseCholesky::solve: " + std::to_string(B.rows()) +
                                             " rows on the right for " + std::to_string(s.n) + " unknowns");
    const std::vector<int>& order = s.factor.supernodes.order;
    for (Eigen::Index from = 0; from < B.cols();) {
        const int k = static_cast<int>(std::min<Eigen::Index>(B.cols() - from, 4));
        Columns X(s.n, k);
        for (int i = 0; i < s.n; ++i)
            X.row(i) = B.row(order[i]).segment(from, k);
        solve::solve_sweeps(s.factor, X.data(), k);
        for (int i = 0; i < s.n; ++i)
            B.row(order[i]).segment(from, k) = X.row(i);
        from += k;
    }
    if (!B.allFinite())
        throw SolverFailure(sized("the solution is not finite; is the right-hand side?", s.n));
}

int SparseCholesky::size() const { return state_->n; }
double SparseCholesky::factor_entries() const { return state_->entries; }
double SparseCholesky::factor_work() const { return state_->work; }
const char* SparseCholesky::ordering() const { return state_->ordering; }

} // namespace lissom
