#pragma once

#include "lissom/mesh/types.h"

#include <span>
#include <utility>
#include <vector>

namespace lissom {

/// Finds the points nearest to a place: a balanced k-d tree (Bentley 1975), split at the median across the longest side of
/// each box. Building costs n log n, a question about log n.
class PointTree {
public:
    /// @param points  n×3, finite; must outlive the tree
    explicit PointTree(const Points& points);

    /// The `count` nearest points, nearest first, equal distances by number. As many as there are where there are fewer.
    /// @param nearest  number and squared distance of each; what was there is forgotten
    void nearest(const Eigen::Vector3d& place, int count, std::vector<std::pair<int, double>>& nearest) const;

private:
    struct Node {
        int first = 0, last = 0; ///< of `order_`
        int axis = -1;           ///< −1: a leaf
        double split = 0;
        int right = 0;           ///< the left child follows its parent
    };

    int build(int first, int last);

    const Points& points_;
    std::vector<int> order_;
    std::vector<Node> nodes_;
};

} // namespace lissom
