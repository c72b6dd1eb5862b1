#include "graph.h"

namespace lissom::solve {

Graph graph_of_lower_triangle(const SparseMatrix& A) {
    const int n = static_cast<int>(A.cols());
    Graph graph;
    graph.offsets.assign(n + 1, 0);
    for_each_lower(A, [&](int i, int j, double) {
        if (i != j) {
            ++graph.offsets[i + 1];
            ++graph.offsets[j + 1];
        }
    });
    for (int i = 0; i < n; ++i)
        graph.offsets[i + 1] += graph.offsets[i];
    graph.neighbours.resize(graph.offsets[n]);
    std::vector<int> next(graph.offsets.begin(), graph.offsets.end() - 1);
    for_each_lower(A, [&](int i, int j, double) {
        if (i != j) {
            graph.neighbours[next[i]++] = j;
            graph.neighbours[next[j]++] = i;
        }
    });
    return graph;
}

} // namespace lissom::solve
