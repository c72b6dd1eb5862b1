#include "panel_values.h"

#include "strips.h"

#include "lissom/mesh/errors.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace lissom::solve {

namespace {

/// A number that tells patterns of the lower triangle apart (FNV-1a over rows and columns).
std::uint64_t pattern_of(const SparseMatrix& A) {
    std::uint64_t hash = 0xcbf29ce484222325u;
    for_each_lower(A, [&](int i, int j, double) {
        hash = (hash ^ static_cast<std::uint32_t>(i)) * 0x100000001b3u;
        hash = (hash ^ static_cast<std::uint32_t>(j)) * 0x100000001b3u;
    });
    return hash;
}

} // namespace

PanelValues::PanelValues(const SparseMatrix& A, const Supernodes& nodes)
    : size_(static_cast<int>(A.cols())), pattern_(pattern_of(A)), offsets_(nodes.count() + 1, 0) {
    std::vector<int> node_of(size_);
    for (int s = 0; s < nodes.count(); ++s)
        std::fill(node_of.begin() + nodes.first[s], node_of.begin() + nodes.first[s + 1], s);

    const auto column_of = [&](int i, int j) { return std::min(nodes.inverse[i], nodes.inverse[j]); };
    for_each_lower(A, [&](int i, int j, double) { ++offsets_[node_of[column_of(i, j)] + 1]; });
    for (int s = 0; s < nodes.count(); ++s)
        offsets_[s + 1] += offsets_[s];

    const std::size_t count = offsets_.back();
    std::vector<std::size_t> next(offsets_.begin(), offsets_.end() - 1);
    std::vector<int> rows(count), columns(count);
    slots_.reserve(count);
    for_each_lower(A, [&](int i, int j, double) {
        const int column = column_of(i, j);
        const std::size_t slot = next[node_of[column]]++;
        slots_.push_back(static_cast<int>(slot));
        columns[slot] = column;
        rows[slot] = std::max(nodes.inverse[i], nodes.inverse[j]);
    });

    values_.resize(count);
    destinations_.resize(count);
    std::vector<int> place(size_);
    for (int s = 0; s < nodes.count(); ++s) {
        const PanelShape shape{nodes.width(s), nodes.height(s)};
        for (int k = 0; k < shape.width; ++k)
            place[nodes.first[s] + k] = k;
        for (int k = 0; k < shape.height; ++k)
            place[nodes.rows_of(s)[k]] = shape.width + k;
        for (std::size_t slot = offsets_[s]; slot < offsets_[s + 1]; ++slot)
            destinations_[slot] =
                static_cast<std::uint32_t>(shape.at(place[rows[slot]], columns[slot] - nodes.first[s]));
    }
}

void PanelValues::take(const SparseMatrix& A) {
    if (A.rows() != size_ || A.cols() != size_ || pattern_of(A) != pattern_)
        throw InvalidInput("pattern-changed", "SparseCholesky::begin: the matrix has other non-zeros than the one "
                                              "analyzed; analyze it again");
    std::size_t t = 0;
    for_each_lower(A, [&](int i, int j, double value) {
        if (!std::isfinite(value)) {
            std::ostringstream message;
            message << "the matrix holds " << value << " in row " << i << ", column " << j << " (matrix of " << size_
                    << " columns)";
            throw SolverFailure(message.str());
        }
        values_[slots_[t++]] = value;
    });
}

} // namespace lissom::solve
