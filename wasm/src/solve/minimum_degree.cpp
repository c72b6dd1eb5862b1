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
    // Only the pattern is read; one byte a value keeps it small.
    Eigen::SparseMatrix<signed char> pattern(n, n);
    pattern.resizeNonZeros(static_cast<int>(graph.neighbours.size()));
    std::copy(graph.offsets.begin(), graph.offsets.end(), pattern.outerIndexPtr());
    std::copy(graph.neighbours.begin(), graph.neighbours.end(), pattern.innerIndexPtr());
    std::fill_n(pattern.valuePtr(), graph.neighbours.size(), static_cast<signed char>(1));
    Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order;
    Eigen::internal::minimum_degree_ordering(pattern, order);
    return {order.indices().data(), order.indices().data() + n};
}

} // namespace lissom::solve
