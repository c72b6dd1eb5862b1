#pragma once

#include "lissom/mesh/types.h"

#include <algorithm>
#include <span>
#include <vector>

namespace lissom {

/// Rows of D numbers an entry over generalised columns: [0, unknowns) are unknown vertices, then come four
/// columns per handle (the three of its linear part and its translation), so that what a handle prescribes
/// is one more column instead of a number that must be known in advance.
template <int D>
struct EntryRows {
    using Value = Eigen::Matrix<double, D, 1>;
    std::vector<int> offsets{0}; ///< rows + 1
    std::vector<int> columns;
    std::vector<Value> values;

    [[nodiscard]] int count() const { return static_cast<int>(offsets.size()) - 1; }
    void close_row() { offsets.push_back(static_cast<int>(columns.size())); }
};

/// A sparse row under construction: add entries in any order, then append it to some EntryRows.
template <int D>
class RowBuilder {
public:
    using Value = Eigen::Matrix<double, D, 1>;

    explicit RowBuilder(int columns) : sums_(static_cast<std::size_t>(columns), Value::Zero()), used_(static_cast<std::size_t>(columns), 0) {}

    void add(int column, const Value& value) {
        if (!used_[column]) {
            used_[column] = 1;
            touched_.push_back(column);
        }
        sums_[column] += value;
    }
    [[nodiscard]] std::span<const int> touched() const { return touched_; }
    [[nodiscard]] const Value& operator[](int column) const { return sums_[column]; }

    void clear() {
        for (const int column : touched_) {
            sums_[column].setZero();
            used_[column] = 0;
        }
        touched_.clear();
    }
    void append_to(EntryRows<D>& rows) {
        for (const int column : touched_) {
            rows.columns.push_back(column);
            rows.values.push_back(sums_[column]);
        }
        rows.close_row();
        clear();
    }

private:
    std::vector<Value> sums_;
    std::vector<char> used_;
    std::vector<int> touched_;
};

/// The normal equations A x = −G w of a least-squares problem: x the unknowns, w the handles' parameters.
struct NormalEquations {
    SparseMatrix A;                                    ///< unknowns², lower triangle only
    Eigen::SparseMatrix<double, Eigen::RowMajor> G;    ///< unknowns × 4·handles
};

/// The rows that normal equations were made of: A x + G w = leftᵀ (right (x, w)) but for rounding, and with fewer digits
/// lost, for a row cancels before it is squared.
struct RowPair {
    Eigen::SparseMatrix<double, Eigen::RowMajor> left;  ///< rows × unknowns
    Eigen::SparseMatrix<double, Eigen::RowMajor> right; ///< rows × (unknowns + 4·handles)
};

/// The D numbers of each row as rows of their own, without those that are 0.
template <int D>
RowPair row_pair(const EntryRows<D>& left, const EntryRows<D>& right, int unknowns, int columns) {
    const auto flat = [&](const EntryRows<D>& rows, int width) {
        std::vector<Eigen::Triplet<double>> entries;
        for (int i = 0; i < rows.count(); ++i)
            for (int e = rows.offsets[i]; e < rows.offsets[i + 1]; ++e)
                for (int d = 0; d < D; ++d)
                    if (rows.columns[e] < width && rows.values[e][d] != 0) entries.emplace_back(D * i + d, rows.columns[e], rows.values[e][d]);
        Eigen::SparseMatrix<double, Eigen::RowMajor> matrix(D * rows.count(), width);
        matrix.setFromTriplets(entries.begin(), entries.end());
        return matrix;
    };
    return {flat(left, unknowns), flat(right, columns)};
}

/// A_km = Σ_i left_i[k] · right_i[m]. The caller sees to it that the result is symmetric (left = right, or
/// right = Λ left with Λ symmetric). Row by row with a dense accumulator; sorted by the final transposition.
template <int D>
NormalEquations normal_equations(const EntryRows<D>& left, const EntryRows<D>& right, int unknowns, int columns) {
    // Which rows hold unknown k, and with what: the transpose of `left`.
    std::vector<int> start(static_cast<std::size_t>(unknowns) + 1, 0);
    for (const int k : left.columns)
        if (k < unknowns) ++start[k + 1];
    for (int k = 0; k < unknowns; ++k) start[k + 1] += start[k];
    std::vector<int> row_of(static_cast<std::size_t>(start[unknowns])), entry_of(row_of.size());
    std::vector<int> next(start.begin(), start.end() - 1);
    for (int i = 0; i < left.count(); ++i)
        for (int e = left.offsets[i]; e < left.offsets[i + 1]; ++e)
            if (left.columns[e] < unknowns) {
                const int slot = next[left.columns[e]]++;
                row_of[slot] = i;
                entry_of[slot] = e;
            }

    RowBuilder<1> sums(columns);
    std::vector<int> offsets{0}, found;
    std::vector<double> values;
    std::vector<Eigen::Triplet<double>> held;
    for (int k = 0; k < unknowns; ++k) {
        sums.add(k, RowBuilder<1>::Value::Zero());
        for (int s = start[k]; s < start[k + 1]; ++s) {
            const auto& factor = left.values[entry_of[s]];
            for (int e = right.offsets[row_of[s]]; e < right.offsets[row_of[s] + 1]; ++e) {
                const int m = right.columns[e];
                if (m <= k || m >= unknowns)
                    sums.add(m, RowBuilder<1>::Value::Constant(factor.dot(right.values[e])));
            }
        }
        for (const int m : sums.touched())
            if (m < unknowns) {
                found.push_back(m);
                values.push_back(sums[m][0]);
            } else {
                held.emplace_back(k, m - unknowns, sums[m][0]);
            }
        offsets.push_back(static_cast<int>(found.size()));
        sums.clear();
    }

    NormalEquations result;
    result.G.resize(unknowns, columns - unknowns);
    result.G.setFromTriplets(held.begin(), held.end());
    // Row k's entries go to column m; k rises, so every column comes out sorted.
    result.A.resize(unknowns, unknowns);
    result.A.resizeNonZeros(static_cast<Eigen::Index>(found.size()));
    int* outer = result.A.outerIndexPtr();
    std::fill(outer, outer + unknowns + 1, 0);
    for (const int m : found) ++outer[m + 1];
    for (int m = 0; m < unknowns; ++m) outer[m + 1] += outer[m];
    std::vector<int> place(outer, outer + unknowns);
    for (int k = 0; k < unknowns; ++k)
        for (int e = offsets[k]; e < offsets[k + 1]; ++e) {
            const int slot = place[found[e]]++;
            result.A.innerIndexPtr()[slot] = k;
            result.A.valuePtr()[slot] = values[e];
        }
    return result;
}

} // namespace lissom
