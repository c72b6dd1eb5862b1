#include "ordering.h"

#include <Eigen/OrderingMethods>

#include <numeric>

namespace lissom::solve {

std::vector<int> minimum_degree_order(const Graph& graph) {
    const int n = graph.size();
    if (n < 3) {
        std::vector<int> order(n);
        std::iota(order.begin(), order.end(), 0);
        return order;
    }
    // Only the pattern is read; one byte a value keeps it small. A node without a diagonal entry would be
    // taken for a dense one.
    Eigen::SparseMatrix<signed char> pattern(n, n);
    pattern.resizeNonZeros(static_cast<int>(graph.neighbours.size()) + n);
    int* next = pattern.innerIndexPtr();
    for (int i = 0; i < n; ++i) {
        pattern.outerIndexPtr()[i] = graph.offsets[i] + i;
        *next++ = i;
        next = std::copy(graph[i].begin(), graph[i].end(), next);
    }
    pattern.outerIndexPtr()[n] = graph.offsets[n] + n;
    std::fill_n(pattern.valuePtr(), pattern.nonZeros(), static_cast<signed char>(1));
    Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order;
    Eigen::internal::minimum_degree_ordering(pattern, order);
    return {order.indices().data(), order.indices().data() + n};
}

} // namespace lissom::solve
