#include "lissom/mesh/point_tree.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <numeric>

namespace lissom {

namespace {

constexpr int k_leaf = 8;

} // namespace

PointTree::PointTree(const Points& points) : points_(points), order_(points.rows()) {
    std::iota(order_.begin(), order_.end(), 0);
    if (!order_.empty()) build(0, static_cast<int>(order_.size()));
}

int PointTree::build(int first, int last) {
    const int at = static_cast<int>(nodes_.size());
    nodes_.push_back({.first = first, .last = last});
    if (last - first <= k_leaf) return at;
    Eigen::AlignedBox3d box;
    for (int i = first; i < last; ++i) box.extend(Eigen::Vector3d(points_.row(order_[i])));
    Eigen::Index axis = 0;
    if (!(box.sizes().maxCoeff(&axis) > 0)) return at; // all in one place
    const int middle = (first + last) / 2;
    std::nth_element(order_.begin() + first, order_.begin() + middle, order_.begin() + last, [&](int a, int b) {
        const double x = points_(a, axis), y = points_(b, axis);
        return x != y ? x < y : a < b;
    });
    nodes_[at].axis = static_cast<int>(axis);
    nodes_[at].split = points_(order_[middle], axis);
    build(first, middle);
    const int right = build(middle, last);
    nodes_[at].right = right;
    return at;
}

void PointTree::nearest(const Eigen::Vector3d& place, int count, std::vector<std::pair<int, double>>& nearest) const {
    nearest.clear();
    if (nodes_.empty() || count <= 0) return;
    const auto closer = [](const std::pair<int, double>& a, const std::pair<int, double>& b) {
        return a.second != b.second ? a.second < b.second : a.first < b.first;
    };
    // A heap whose top is the farthest of those held.
    const auto search = [&](const auto& self, int at) -> void {
        const Node& node = nodes_[at];
        if (node.axis < 0) {
            for (int i = node.first; i < node.last; ++i) {
                const int v = order_[i];
                const std::pair<int, double> found{v, (points_.row(v).transpose() - place).squaredNorm()};
                if (std::ssize(nearest) < count) {
                    nearest.push_back(found);
                    std::push_heap(nearest.begin(), nearest.end(), closer);
                } else if (closer(found, nearest.front())) {
                    std::pop_heap(nearest.begin(), nearest.end(), closer);
                    nearest.back() = found;
                    std::push_heap(nearest.begin(), nearest.end(), closer);
                }
            }
            return;
        }
        const double beside = place[node.axis] - node.split;
        const int near = beside < 0 ? at + 1 : node.right, far = beside < 0 ? node.right : at + 1;
        self(self, near);
        if (std::ssize(nearest) < count || beside * beside <= nearest.front().second) self(self, far);
    };
    search(search, 0);
    std::sort_heap(nearest.begin(), nearest.end(), closer);
}

} // namespace lissom
