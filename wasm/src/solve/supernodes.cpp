#include "supernodes.h"

#include <algorithm>
#include <numeric>

namespace lissom::solve {

namespace {

/// A supernode while the partition is still being decided. Columns are those of the elimination tree.
struct Block {
    int begin = 0, end = 0; ///< its own columns, before merging
    int parent = -1;
    int width = 0;     ///< columns, with those of merged children
    int front = 0;     ///< columns + rows below
    double zeros = 0;  ///< explicit zeros in the panel
    int merged_into = -1;
};

double panel_entries(double width, double front) { return width * front - 0.5 * width * (width - 1); }

/// Runs of columns k, k+1, … where each has the rows of the one before, less its diagonal.
std::vector<Block> exact_blocks(const EliminationTree& tree) {
    const int n = static_cast<int>(tree.order.size());
    std::vector<Block> blocks;
    std::vector<int> block_of(n);
    for (int k = 0; k < n; ++k) {
        const bool continues = k > 0 && tree.parent[k - 1] == k && tree.counts[k - 1] == tree.counts[k] + 1;
        if (!continues) {
            Block block;
            block.begin = k;
            block.front = tree.counts[k];
            blocks.push_back(block);
        }
        block_of[k] = static_cast<int>(blocks.size()) - 1;
        blocks.back().end = k + 1;
        ++blocks.back().width;
    }
    for (Block& block : blocks) {
        const int above = tree.parent[block.end - 1];
        block.parent = above < 0 ? -1 : block_of[above];
    }
    return blocks;
}

/// True where one panel of these columns is cheaper than two, although a share of it is zero. Narrow panels
/// pay for themselves: their cost is overhead, not arithmetic.
bool worth_merging(double width, double zero_share) {
    return width <= 4 || zero_share < (width <= 16 ? 0.3 : width <= 48 ? 0.1 : 0.03);
}

void amalgamate(std::vector<Block>& blocks) {
    const int count = static_cast<int>(blocks.size());
    std::vector<std::vector<int>> children(count);
    for (int b = 0; b < count; ++b) {
        Block& block = blocks[b];
        // Widest first: a child that shares most of its rows should not find the panel filled with zeros.
        std::stable_sort(children[b].begin(), children[b].end(),
                         [&](int x, int y) { return blocks[x].front > blocks[y].front; });
        for (const int c : children[b]) {
            Block& child = blocks[c];
            const double width = child.width + block.width;
            const double front = child.width + block.front;
            const double whole = panel_entries(width, front);
            const double zeros = whole - (panel_entries(child.width, child.front) - child.zeros) -
                                 (panel_entries(block.width, block.front) - block.zeros);
            if (!worth_merging(width, zeros / whole))
                continue;
            block.width += child.width;
            block.front += child.width;
            block.zeros = zeros;
            child.merged_into = b;
        }
        if (block.parent >= 0)
            children[block.parent].push_back(b);
    }
}

/// Children are visited so that the pending updates of the multifrontal method stay few: the child whose
/// subtree needs most room beyond what it leaves behind goes first (Liu, "On the storage requirement in the
/// out-of-core multifrontal method", ACM TOMS 12(3), 1986).
std::vector<int> thrifty_postorder(const std::vector<int>& parent, const std::vector<double>& update_size) {
    const int count = static_cast<int>(parent.size());
    std::vector<std::vector<int>> children(count);
    std::vector<double> peak(count, 0);
    std::vector<int> roots;
    for (int s = 0; s < count; ++s) {
        std::stable_sort(children[s].begin(), children[s].end(),
                         [&](int x, int y) { return peak[x] - update_size[x] > peak[y] - update_size[y]; });
        double kept = 0;
        for (const int c : children[s]) {
            peak[s] = std::max(peak[s], kept + peak[c]);
            kept += update_size[c];
        }
        peak[s] = std::max(peak[s], kept + update_size[s]);
        (parent[s] < 0 ? roots : children[parent[s]]).push_back(s);
    }
    std::vector<int> order, stack(roots);
    order.reserve(count);
    while (!stack.empty()) { // parents first with children reversed, then turned round
        const int s = stack.back();
        stack.pop_back();
        order.push_back(s);
        stack.insert(stack.end(), children[s].begin(), children[s].end());
    }
    std::reverse(order.begin(), order.end());
    return order;
}

/// Lays the merged blocks out as supernodes: new column numbers, widths, parents, depths.
Supernodes lay_out(const EliminationTree& tree, const std::vector<Block>& blocks) {
    const int count = static_cast<int>(blocks.size());
    std::vector<int> owner(count), kept;
    for (int b = count - 1; b >= 0; --b)
        owner[b] = blocks[b].merged_into < 0 ? b : owner[blocks[b].merged_into];
    std::vector<int> index(count, -1);
    for (int b = 0; b < count; ++b)
        if (owner[b] == b) {
            index[b] = static_cast<int>(kept.size());
            kept.push_back(b);
        }
    std::vector<std::vector<int>> members(kept.size());
    for (int b = 0; b < count; ++b)
        members[index[owner[b]]].push_back(b);

    std::vector<int> parent(kept.size());
    std::vector<double> update_size(kept.size());
    for (std::size_t i = 0; i < kept.size(); ++i) {
        const Block& block = blocks[kept[i]];
        const double height = block.front - block.width;
        parent[i] = block.parent < 0 ? -1 : index[owner[block.parent]];
        update_size[i] = 0.5 * height * height;
    }
    const std::vector<int> visit = thrifty_postorder(parent, update_size);
    std::vector<int> rank(visit.size());
    for (std::size_t s = 0; s < visit.size(); ++s)
        rank[visit[s]] = static_cast<int>(s);

    Supernodes out;
    const int n = static_cast<int>(tree.order.size());
    out.order.reserve(n);
    out.first.push_back(0);
    for (const int i : visit) {
        for (const int b : members[i])
            for (int k = blocks[b].begin; k < blocks[b].end; ++k)
                out.order.push_back(tree.order[k]);
        out.first.push_back(static_cast<int>(out.order.size()));
        out.parent.push_back(parent[i] < 0 ? -1 : rank[parent[i]]);
    }
    out.inverse.resize(n);
    for (int k = 0; k < n; ++k)
        out.inverse[out.order[k]] = k;
    out.depth.assign(out.parent.size(), 0);
    for (int s = out.count() - 1; s >= 0; --s)
        if (out.parent[s] >= 0)
            out.depth[s] = out.depth[out.parent[s]] + 1;
    out.first_descendant.resize(out.parent.size());
    std::iota(out.first_descendant.begin(), out.first_descendant.end(), 0);
    for (int s = 0; s < out.count(); ++s)
        if (const int p = out.parent[s]; p >= 0)
            out.first_descendant[p] = std::min(out.first_descendant[p], out.first_descendant[s]);
    return out;
}

/// Rows of a supernode: those of A's columns and of its children, beyond its own columns.
void find_rows(const Graph& graph, Supernodes& out) {
    const int count = out.count();
    std::vector<int> seen(out.order.size(), -1), first_child(count, -1), sibling(count, -1);
    for (int s = count - 1; s >= 0; --s)
        if (out.parent[s] >= 0) {
            sibling[s] = first_child[out.parent[s]];
            first_child[out.parent[s]] = s;
        }
    out.row_offsets.assign(1, 0);
    for (int s = 0; s < count; ++s) {
        const int end = out.first[s + 1];
        const auto add = [&](int row) {
            if (row >= end && seen[row] != s) {
                seen[row] = s;
                out.rows.push_back(row);
            }
        };
        for (int k = out.first[s]; k < end; ++k)
            for (const int neighbour : graph[out.order[k]])
                add(out.inverse[neighbour]);
        for (int c = first_child[s]; c >= 0; c = sibling[c])
            for (std::size_t t = out.row_offsets[c]; t < out.row_offsets[c + 1]; ++t)
                add(out.rows[t]);
        std::sort(out.rows.begin() + static_cast<std::ptrdiff_t>(out.row_offsets[s]), out.rows.end());
        out.row_offsets.push_back(out.rows.size());
    }
}

void find_places(Supernodes& out) {
    out.place.resize(out.rows.size());
    for (int s = 0; s < out.count(); ++s) {
        const int p = out.parent[s];
        if (p < 0)
            continue;
        const int* above = out.rows_of(p);
        int found = 0;
        for (std::size_t t = out.row_offsets[s]; t < out.row_offsets[s + 1]; ++t) {
            const int row = out.rows[t];
            if (row < out.first[p + 1]) {
                out.place[t] = row - out.first[p];
            } else {
                while (above[found] != row)
                    ++found;
                out.place[t] = out.width(p) + found;
            }
        }
    }
}

} // namespace

Supernodes supernodes(const Graph& graph, const EliminationTree& tree) {
    std::vector<Block> blocks = exact_blocks(tree);
    amalgamate(blocks);
    Supernodes out = lay_out(tree, blocks);
    find_rows(graph, out);
    find_places(out);
    return out;
}

} // namespace lissom::solve
