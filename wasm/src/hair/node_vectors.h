#pragma once

#include "lissom/hair/field_solver.h"

#include <map>
#include <vector>

namespace lissom {

/// Weighted mean vectors at nodes: what one kind of style primitive asks for.
class NodeVectors {
public:
    explicit NodeVectors(const Grid& grid) : grid_(grid) {}

    void add(int node, const Eigen::Vector3d& vector, double weight = 1) {
        Sum& sum = sums_[node];
        sum.vector += weight * vector;
        sum.weight += weight;
    }

    /// To the eight corners of p's cell, by nearness; nothing where p lies outside the grid.
    void add_around(const Eigen::Vector3d& p, const Eigen::Vector3d& vector) {
        if (!grid_.contains(p)) return;
        const Cell cell = cell_of(grid_, p);
        for (int k = 0; k < 8; ++k) add(cell.nodes[k], vector, cell.weights[k] + 1e-3);
    }

    /// Writes the means into `out`, over what is there.
    void write(std::map<int, Eigen::Vector3d>& out) const {
        for (const auto& [node, sum] : sums_) out[node] = sum.vector / sum.weight;
    }

    [[nodiscard]] const Grid& grid() const { return grid_; }

private:
    struct Sum {
        Eigen::Vector3d vector = Eigen::Vector3d::Zero();
        double weight = 0;
    };
    Grid grid_;
    std::map<int, Sum> sums_;
};

/// Calls visit(node, position) for every node within `radius` of the segment's bounding box.
template <typename Visit>
void for_nodes_near(const Grid& grid, const Eigen::Vector3d& a, const Eigen::Vector3d& b, double radius, Visit&& visit) {
    // Both ends of both: of places far beyond the grid no whole number could be made.
    const Eigen::Array3d last = (grid.size.array() - 1).cast<double>();
    const Eigen::Vector3d low = grid.local(a.cwiseMin(b).array() - radius).array().ceil().max(0.0).min(last + 1);
    const Eigen::Vector3d high = grid.local(a.cwiseMax(b).array() + radius).array().floor().max(-1.0).min(last);
    for (int z = static_cast<int>(low.z()); z <= static_cast<int>(high.z()); ++z)
        for (int y = static_cast<int>(low.y()); y <= static_cast<int>(high.y()); ++y)
            for (int x = static_cast<int>(low.x()); x <= static_cast<int>(high.x()); ++x) {
                const int node = grid.node(x, y, z);
                visit(node, grid.position(node));
            }
}

void add_stream(NodeVectors& out, const struct StreamCurve& curve);
void add_parting(NodeVectors& out, const struct DividingCurve& curve, const class HeadDistance& head);
void add_ponytail(NodeVectors& out, const struct Ponytail& tail);

} // namespace lissom
