#include "elimination_tree.h"

#include <numeric>

namespace lissom::solve {

namespace {

std::vector<int> inverse_of(const std::vector<int>& order) {
    std::vector<int> inverse(order.size());
    for (int k = 0; k < static_cast<int>(order.size()); ++k)
        inverse[order[k]] = k;
    return inverse;
}

/// Parent of column k: the row of the first entry below its diagonal in L.
std::vector<int> parents(const Graph& graph, const std::vector<int>& order, const std::vector<int>& inverse) {
    const int n = graph.size();
    std::vector<int> parent(n, -1);
    std::vector<int> ancestor(n, -1); // parent links, shortened as they are walked
    for (int k = 0; k < n; ++k)
        for (const int neighbour : graph[order[k]])
            for (int i = inverse[neighbour]; i < k && i != -1;) {
                const int above = ancestor[i];
                ancestor[i] = k;
                if (above == -1)
                    parent[i] = k;
                i = above == k ? -1 : above;
            }
    return parent;
}

int root_of(std::vector<int>& ancestor, int i) {
    int root = i;
    while (ancestor[root] != root)
        root = ancestor[root];
    while (ancestor[i] != root) {
        const int above = ancestor[i];
        ancestor[i] = root;
        i = above;
    }
    return root;
}

/// Row i of L is a subtree rooted at i whose leaves are found among the entries of A. A column counts the
/// row subtrees it lies in, by differences: +1 at each leaf, −1 where two branches meet and above the root.
std::vector<int> column_counts(const Graph& graph, const EliminationTree& tree) {
    const int n = graph.size();
    std::vector<int> count(n, 0), first(n), last_first(n, -1), last_leaf(n, -1), ancestor(n);
    std::iota(first.begin(), first.end(), 0);
    std::iota(ancestor.begin(), ancestor.end(), 0);
    for (int k = 0; k < n; ++k) // smallest descendant; in a postorder the first child carries it
        if (tree.parent[k] >= 0 && first[k] < first[tree.parent[k]])
            first[tree.parent[k]] = first[k];
    for (int k = 0; k < n; ++k) {
        if (first[k] == k)
            ++count[k];
        if (tree.parent[k] >= 0)
            --count[tree.parent[k]];
        for (const int neighbour : graph[tree.order[k]]) {
            const int i = tree.inverse[neighbour];
            if (i <= k || first[k] <= last_first[i])
                continue;
            last_first[i] = first[k];
            ++count[k];
            if (last_leaf[i] >= 0)
                --count[root_of(ancestor, last_leaf[i])];
            last_leaf[i] = k;
        }
        if (tree.parent[k] >= 0)
            ancestor[k] = tree.parent[k];
    }
    for (int k = 0; k < n; ++k)
        if (tree.parent[k] >= 0)
            count[tree.parent[k]] += count[k];
    return count;
}

} // namespace

std::vector<int> postorder(const std::vector<int>& parent) {
    const int n = static_cast<int>(parent.size());
    std::vector<int> first_child(n, -1), sibling(n, -1), order, stack;
    for (int i = n - 1; i >= 0; --i)
        if (parent[i] >= 0) {
            sibling[i] = first_child[parent[i]];
            first_child[parent[i]] = i;
        }
    order.reserve(n);
    for (int root = 0; root < n; ++root) {
        if (parent[root] >= 0)
            continue;
        stack.push_back(root);
        while (!stack.empty()) {
            const int i = stack.back();
            if (first_child[i] >= 0) {
                stack.push_back(first_child[i]);
                first_child[i] = sibling[first_child[i]];
            } else {
                order.push_back(i);
                stack.pop_back();
            }
        }
    }
    return order;
}

EliminationTree elimination_tree(const Graph& graph, std::vector<int> order) {
    const int n = graph.size();
    const std::vector<int> parent = parents(graph, order, inverse_of(order));
    const std::vector<int> visit = postorder(parent);
    const std::vector<int> rank = inverse_of(visit);

    EliminationTree tree;
    tree.order.resize(n);
    tree.parent.resize(n);
    for (int k = 0; k < n; ++k) {
        tree.order[k] = order[visit[k]];
        tree.parent[k] = parent[visit[k]] < 0 ? -1 : rank[parent[visit[k]]];
    }
    tree.inverse = inverse_of(tree.order);
    tree.counts = column_counts(graph, tree);
    for (const int count : tree.counts)
        tree.work += 0.5 * count * (count + 1.0);
    return tree;
}

} // namespace lissom::solve
