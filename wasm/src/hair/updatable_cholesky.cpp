#include "lissom/hair/updatable_cholesky.h"

#include "lissom/mesh/errors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace lissom {

namespace {
constexpr int k_together = 8; // changes carried at once: what stays in registers and one cache line of w
}

UpdatableCholesky::UpdatableCholesky(const SparseCholesky& factor) : L_(factor.lower_triangle()), column_of_(L_.order.size()) {
    for (std::size_t k = 0; k < L_.order.size(); ++k) column_of_[static_cast<std::size_t>(L_.order[k])] = static_cast<int>(k);
}

void UpdatableCholesky::change(std::span<const int> nodes, double w, int sign) {
    std::vector<int> columns;
    for (const int node : nodes) columns.push_back(column_of_[static_cast<std::size_t>(node)]);
    std::sort(columns.begin(), columns.end()); // neighbours in elimination order share most of their paths
    for (std::size_t at = 0; at < columns.size(); at += k_together)
        change_some(std::span(columns).subspan(at, std::min<std::size_t>(k_together, columns.size() - at)), w, sign);
}

void UpdatableCholesky::change_some(std::span<const int> columns, double w, int sign) {
    using Work = std::array<double, k_together>;
    const int n = size(), count = static_cast<int>(columns.size());
    std::vector<Work> work(static_cast<std::size_t>(n), Work{});
    std::vector<char> on_path(static_cast<std::size_t>(n), 0);
    for (int k = 0; k < count; ++k) {
        work[static_cast<std::size_t>(columns[k])][static_cast<std::size_t>(k)] = w;
        on_path[static_cast<std::size_t>(columns[k])] = 1;
    }
    for (int j = columns.front(); j < n; ++j) {
        if (!on_path[static_cast<std::size_t>(j)]) continue;
        const std::size_t begin = L_.offsets[static_cast<std::size_t>(j)], end = L_.offsets[static_cast<std::size_t>(j) + 1];
        if (begin + 1 < end) on_path[static_cast<std::size_t>(L_.rows[begin + 1])] = 1; // the parent in the elimination tree

        // One plane rotation (hyperbolic for a downdate) per change brings its entry in row j to zero.
        double s[k_together] = {}, c[k_together];
        double diagonal = L_.values[begin];
        for (int k = 0; k < k_together; ++k) {
            const double wj = work[static_cast<std::size_t>(j)][static_cast<std::size_t>(k)];
            const double square = diagonal * diagonal + sign * wj * wj;
            if (!(square > 0))
                throw SolverFailure("UpdatableCholesky: taking a weight away leaves the matrix not positive definite at column " +
                                    std::to_string(L_.order[static_cast<std::size_t>(j)]) + " of " + std::to_string(n));
            const double r = std::sqrt(square);
            c[k] = r / diagonal;
            s[k] = wj / diagonal;
            diagonal = r;
        }
        L_.values[begin] = diagonal;
        for (std::size_t e = begin + 1; e < end; ++e) {
            double l = L_.values[e];
            Work& wi = work[static_cast<std::size_t>(L_.rows[e])];
            for (int k = 0; k < k_together; ++k) {
                l = (l + sign * s[k] * wi[static_cast<std::size_t>(k)]) / c[k];
                wi[static_cast<std::size_t>(k)] = c[k] * wi[static_cast<std::size_t>(k)] - s[k] * l;
            }
            L_.values[e] = l;
        }
    }
}

void UpdatableCholesky::solve(Columns& b) const {
    const int n = size();
    Columns x(n, b.cols());
    for (int j = 0; j < n; ++j) x.row(j) = b.row(L_.order[static_cast<std::size_t>(j)]);
    for (int j = 0; j < n; ++j) {
        const std::size_t begin = L_.offsets[static_cast<std::size_t>(j)], end = L_.offsets[static_cast<std::size_t>(j) + 1];
        x.row(j) /= L_.values[begin];
        for (std::size_t e = begin + 1; e < end; ++e) x.row(L_.rows[e]) -= L_.values[e] * x.row(j);
    }
    for (int j = n - 1; j >= 0; --j) {
        const std::size_t begin = L_.offsets[static_cast<std::size_t>(j)], end = L_.offsets[static_cast<std::size_t>(j) + 1];
        for (std::size_t e = begin + 1; e < end; ++e) x.row(j) -= L_.values[e] * x.row(L_.rows[e]);
        x.row(j) /= L_.values[begin];
    }
    for (int j = 0; j < n; ++j) b.row(L_.order[static_cast<std::size_t>(j)]) = x.row(j);
}

} // namespace lissom
