#include "ordering.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace lissom::solve {

namespace {

constexpr int k_leaf = 64;       ///< nodes not worth cutting
constexpr int k_directions = 8;  ///< across which planes are tried
constexpr int k_planes = 256;    ///< places tried along one direction
constexpr double k_margin = 0.2; ///< share of the nodes that each side keeps at least

typedef short Bins __attribute__((vector_size(2 * k_directions)));
using Directions = Eigen::Matrix<double, 3, k_directions>;
using Projections = Eigen::Matrix<double, 1, k_directions>;

enum class Side { left, right };

/// Where to cut: nodes with bin <= plane are left, those of them (or of the others) that touch the far side
/// are the separator.
struct Cut {
    double cost = INFINITY;
    int direction = 0, plane = 0;
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

    /// Pieces of a surface are flat more often than not: all directions but one lie in the plane of the
    /// two longer principal axes.
    [[nodiscard]] Directions directions(std::span<const int> nodes, const Eigen::RowVector3d& mean) const {
        Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
        for (const int i : nodes) {
            const Eigen::RowVector3d x = coordinates_.row(i) - mean;
            covariance += x.transpose() * x;
        }
        const Eigen::Matrix3d axes = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(covariance).eigenvectors();
        Directions out;
        for (int d = 0; d < k_directions - 1; ++d) {
            const double angle = M_PI * d / (k_directions - 1);
            out.col(d) = std::cos(angle) * axes.col(2) + std::sin(angle) * axes.col(1);
        }
        out.col(k_directions - 1) = axes.col(0);
        return out;
    }

    /// Sorts the nodes into slices of equal thickness across every direction.
    void fill_bins(std::span<const int> nodes) {
        Eigen::RowVector3d mean = Eigen::RowVector3d::Zero();
        for (const int i : nodes)
            mean += coordinates_.row(i);
        mean /= static_cast<double>(nodes.size());
        const Directions across = directions(nodes, mean);
        Projections low = Projections::Constant(INFINITY), high = -low;
        for (const int i : nodes) {
            const Projections x = (coordinates_.row(i) - mean) * across;
            low = low.cwiseMin(x);
            high = high.cwiseMax(x);
        }
        const Projections extent = high - low;
        for (const int i : nodes) {
            const Projections x = (coordinates_.row(i) - mean) * across - low;
            for (int d = 0; d < k_directions; ++d) {
                const double share = extent[d] > 0 ? x[d] / extent[d] : 0;
                bins_[i][d] = static_cast<short>(std::clamp(share * k_planes, 0.0, k_planes - 1.0));
            }
        }
    }

    /// Tries every plane: a node lies in the separator of the planes between its own bin and
    /// its farthest neighbour's, so that all sizes come out of one pass over the edges.
    Cut best_cut(std::span<const int> nodes, int id) {
        fill_bins(nodes);
        using Counts = std::array<std::array<int, k_directions>, k_planes + 1>;
        Counts inside{}, left{}, right{};
        for (const int i : nodes) {
            Bins low = bins_[i], high = bins_[i];
            for (const int j : graph_[i]) {
                if (part_[j] != id)
                    continue;
                const Bins other = bins_[j];
                low = other < low ? other : low;
                high = other > high ? other : high;
            }
            for (int d = 0; d < k_directions; ++d) {
                const int own = bins_[i][d];
                ++inside[own][d];
                ++left[own][d];
                --left[high[d]][d];
                ++right[low[d]][d];
                --right[own][d];
            }
        }
        const double n = static_cast<double>(nodes.size());
        Cut best;
        for (int d = 0; d < k_directions; ++d) {
            int below = 0, on_left = 0, on_right = 0;
            for (int plane = 0; plane < k_planes - 1; ++plane) {
                below += inside[plane][d];
                on_left += left[plane][d];
                on_right += right[plane][d];
                consider(best, {0, d, plane, Side::left}, on_left, (below - on_left) / n, (n - below) / n);
                consider(best, {0, d, plane, Side::right}, on_right, below / n, (n - below - on_right) / n);
            }
        }
        return best;
    }

    static void consider(Cut& best, Cut cut, int separator, double left, double right) {
        if (std::min(left, right) < k_margin)
            return;
        cut.cost = (separator + 1) / std::sqrt(left * right);
        if (cut.cost < best.cost)
            best = cut;
    }

    void classify(std::span<const int> nodes, int id, const Cut& cut, int left, int right, int between) {
        const auto is_left = [&](int i) { return bins_[i][cut.direction] <= cut.plane; };
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
    std::vector<Bins> bins_; ///< of the piece being cut
    std::vector<int> local_;
};

} // namespace

std::vector<int> nested_dissection_order(const Graph& graph, const Points& coordinates) {
    return graph.size() == 0 ? std::vector<int>{} : Dissection(graph, coordinates).order();
}

} // namespace lissom::solve
