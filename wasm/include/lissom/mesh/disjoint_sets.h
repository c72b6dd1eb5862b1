#pragma once

#include <numeric>
#include <vector>

namespace lissom {

/// Groups that grow together (union–find). The smallest member names its group, so the outcome does not
/// depend on the order in which groups were joined.
class DisjointSets {
public:
    explicit DisjointSets(int count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }

    /// The smallest member of i's group.
    [[nodiscard]] int find(int i) {
        while (parent_[i] != i)
            i = parent_[i] = parent_[parent_[i]]; // path halving keeps later walks short
        return i;
    }
    void join(int i, int j) {
        i = find(i);
        j = find(j);
        parent_[i < j ? j : i] = i < j ? i : j;
    }

private:
    std::vector<int> parent_;
};

} // namespace lissom
