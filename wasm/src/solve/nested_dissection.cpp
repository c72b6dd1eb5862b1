#include "ordering.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace lissom::solve {

namespace {

constexpr int k_leaf = 128;     ///< nodes not worth cutting
constexpr int k_planes = 256;   ///< places tried along one axis
constexpr double k_margin = 0.2; ///< share of the nodes that each side keeps at least

enum class Side { left, right };

/// Where to cut: nodes with bin <= plane are left, those of them (or of the others) that touch the far side
/// are the separator.
struct Cut {
    double cost = INFINITY;
    int axis = 0, plane = 0;
    Side separator = Side::left;
};

class Dissection {
public:
    Dissection(const Graph& graph, const Points& coordinates)
        : graph_(graph), coordinates_(coordinates), part_(graph.size(), 0), bins_(graph.size()),
          local_(graph.size(), -1) {
        for (double& x : coordinates_.reshaped())
            if (!std::isfinite(x))
                x = 0;
    }

    std::vector<int> order() {
        std::vector<int> nodes(graph_.size());
        std::iota(nodes.begin(), nodes.end(), 0);
        dissect(nodes);
        return nodes;
    }

private:
    void dissect(std::span<int> nodes) {
        if (static_cast<int>(nodes.size()) <= k_leaf) {
            order_leaf(nodes);
            return;
        }
        const int id = part_[nodes.front()];
        const Cut cut = best_cut(nodes, id);
        if (!std::isfinite(cut.cost)) {
            order_leaf(nodes);
            return;
        }
        const int left = ++parts_, right = ++parts_, between = ++parts_;
        classify(nodes, id, cut, left, right, between);
        // Stable, so that the order depends on nothing but the input.
        const auto middle = std::stable_partition(nodes.begin(), nodes.end(),
                                                  [&](int i) { return part_[i] == left; });
        const auto end = std::stable_partition(middle, nodes.end(), [&](int i) { return part_[i] == right; });
        dissect({nodes.begin(), middle});
        dissect({middle, end});
    }

    /// Principal axes of the nodes, longest first, as bins of equal thickness.
    void fill_bins(std::span<const int> nodes) {
        Eigen::RowVector3d mean = Eigen::RowVector3d::Zero();
        for (const int i : nodes)
            mean += coordinates_.row(i);
        mean /= static_cast<double>(nodes.size());
        Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
        for (const int i : nodes) {
            const Eigen::RowVector3d x = coordinates_.row(i) - mean;
            covariance += x.transpose() * x;
        }
        const Eigen::Matrix3d axes =
            Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(covariance).eigenvectors().rowwise().reverse();
        Eigen::RowVector3d low = Eigen::RowVector3d::Constant(INFINITY), high = -low;
        for (const int i : nodes) {
            const Eigen::RowVector3d x = (coordinates_.row(i) - mean) * axes;
            low = low.cwiseMin(x);
            high = high.cwiseMax(x);
        }
        const Eigen::RowVector3d extent = high - low;
        for (const int i : nodes) {
            const Eigen::RowVector3d x = (coordinates_.row(i) - mean) * axes - low;
            for (int a = 0; a < 3; ++a) {
                const double share = extent[a] > 0 ? x[a] / extent[a] : 0;
                bins_[i][a] = static_cast<short>(std::clamp(static_cast<int>(share * k_planes), 0, k_planes - 1));
            }
        }
    }

    /// Tries every plane of every axis: a node lies in the separator of the planes between its own bin and
    /// its farthest neighbour's, so that all sizes come out of one pass over the edges.
    Cut best_cut(std::span<const int> nodes, int id) {
        fill_bins(nodes);
        using Counts = std::array<std::array<int, 3>, k_planes + 1>;
        Counts inside{}, left{}, right{};
        for (const int i : nodes) {
            std::array<short, 3> low = bins_[i], high = bins_[i];
            for (const int j : graph_[i]) {
                if (part_[j] != id)
                    continue;
                for (int a = 0; a < 3; ++a) {
                    low[a] = std::min(low[a], bins_[j][a]);
                    high[a] = std::max(high[a], bins_[j][a]);
                }
            }
            for (int a = 0; a < 3; ++a) {
                const int own = bins_[i][a];
                ++inside[own][a];
                ++left[own][a];
                --left[high[a]][a];
                ++right[low[a]][a];
                --right[own][a];
            }
        }
        const double n = static_cast<double>(nodes.size());
        Cut best;
        for (int a = 0; a < 3; ++a) {
            int below = 0, on_left = 0, on_right = 0;
            for (int plane = 0; plane < k_planes - 1; ++plane) {
                below += inside[plane][a];
                on_left += left[plane][a];
                on_right += right[plane][a];
                consider(best, {0, a, plane, Side::left}, on_left, (below - on_left) / n, (n - below) / n);
                consider(best, {0, a, plane, Side::right}, on_right, below / n, (n - below - on_right) / n);
            }
        }
        return best;
    }

    static void consider(Cut& best, Cut cut, int separator, double left, double right) {
        if (std::min(left, right) < k_margin)
            return;
        cut.cost = (separator + 1) / (left * right);
        if (cut.cost < best.cost)
            best = cut;
    }

    void classify(std::span<const int> nodes, int id, const Cut& cut, int left, int right, int between) {
        const auto is_left = [&](int i) { return bins_[i][cut.axis] <= cut.plane; };
        std::vector<int> separator;
        for (const int i : nodes) {
            if (is_left(i) != (cut.separator == Side::left))
                continue;
            for (const int j : graph_[i])
                if (part_[j] == id && is_left(j) != is_left(i)) {
                    separator.push_back(i);
                    break;
                }
        }
        for (const int i : nodes)
            part_[i] = is_left(i) ? left : right;
        for (const int i : separator)
            part_[i] = between;
    }

    void order_leaf(std::span<int> nodes) {
        const int id = part_[nodes.front()];
        const int n = static_cast<int>(nodes.size());
        for (int k = 0; k < n; ++k)
            local_[nodes[k]] = k;
        Graph leaf;
        leaf.offsets.push_back(0);
        for (const int i : nodes) {
            for (const int j : graph_[i])
                if (part_[j] == id)
                    leaf.neighbours.push_back(local_[j]);
            leaf.offsets.push_back(static_cast<int>(leaf.neighbours.size()));
        }
        std::vector<int> ordered = minimum_degree_order(leaf);
        for (int& k : ordered)
            k = nodes[k];
        std::copy(ordered.begin(), ordered.end(), nodes.begin());
    }

    const Graph& graph_;
    Points coordinates_;
    std::vector<int> part_; ///< which piece a node is in
    int parts_ = 0;
    std::vector<std::array<short, 3>> bins_; ///< along the axes of the piece being cut
    std::vector<int> local_;
};

} // namespace

std::vector<int> nested_dissection_order(const Graph& graph, const Points& coordinates) {
    return graph.size() == 0 ? std::vector<int>{} : Dissection(graph, coordinates).order();
}

} // namespace lissom::solve
