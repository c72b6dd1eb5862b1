#include "lissom/match/skin_carrier.h"

#include "lissom/mesh/chance.h"
#include "lissom/mesh/operators.h"

#include "easing.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lissom {

namespace {

constexpr CarrySchedule k_marked{0.12, 12, 0.15, 0.06, 0.3}, k_unmarked{0.2, 8, 0.4, 0.1, 0};
constexpr int k_fewest_markers = 3; // to turn by
constexpr double k_first_stiffness = 5, k_next_stiffness = 0.3, k_last_stiffness = 0.02;
constexpr int k_most_asked = 6000; // vertices, and samples, that the finest graph is carried by; each coarser one by half as many
constexpr int k_most_nodes = 3000;

} // namespace

CarrySchedule carry_schedule(int markers) { return markers < k_fewest_markers ? k_unmarked : k_marked; }

GraphLevels::GraphLevels(const TriangleMesh& skin, double radius, int count, std::uint64_t seed)
    : edges_(edge_graph(skin)), radius_(radius),
      // So many nodes that a finer graph would not be worth its factor: their number falls with the square of the radius.
      least_(std::sqrt(triangle_areas(skin).sum() / (0.7 * k_most_nodes))), count_(count), seed_(seed) {}

const NodeGraph& GraphLevels::operator[](int level) {
    while (std::ssize(graphs_) <= level) graphs_.emplace_back(edges_, std::max(radius_ * std::pow(0.5, static_cast<double>(graphs_.size())), least_), seed_);
    return graphs_[static_cast<std::size_t>(level)];
}

SkinCarrier::SkinCarrier(Points rest, const Triangles& triangles, GraphLevels& graphs, const FitSurface& surface, CarryGuides guides, const CarrySchedule& schedule, std::uint64_t seed)
    : rest_(std::move(rest)), points_(rest_), triangles_(triangles), graphs_(graphs), surface_(surface), guides_(std::move(guides)), schedule_(schedule), seed_(seed) {}

void SkinCarrier::begin_level(int level) {
    asked_ = std::min(k_most_asked, 2 * static_cast<int>(points_.rows())) >> (graphs_.count() - 1 - level);
    correspondences_.emplace(surface_, sample_surface(surface_.mesh(), asked_, seed_), surface_.has_facing());
    affine_.emplace(rest_, triangles_, graphs_[level], points_);
}

bool SkinCarrier::step() {
    if (iteration_ == steps()) return false;
    const int n = static_cast<int>(points_.rows());
    const int level = iteration_ / schedule_.iterations, k = iteration_ % schedule_.iterations;
    if (k == 0) begin_level(level);
    const CorrespondenceRules rules{schedule_.least_cosine, eased(schedule_.first_reach, schedule_.last_reach, along(iteration_, steps()))};
    // A node has enough of some vertices.
    const double share = std::min(1.0, static_cast<double>(asked_) / n);
    std::vector<char> left_out = guides_.left_out;
    for (int v = 0; v < n; ++v) left_out[v] = left_out[v] || chance(seed_, static_cast<std::uint64_t>(v), 1) >= share;
    std::vector<Pull> pulls = correspondences_->find({points_, triangles_}, rules, left_out, guides_.masked);
    for (Pull pull : guides_.pulls) {
        pull.weight *= share;
        pulls.push_back(pull);
    }
    if (!pulls.empty()) {
        points_ = affine_->solve(pulls, eased(level == 0 ? k_first_stiffness : k_next_stiffness, k_last_stiffness, along(k, schedule_.iterations)));
        energy_ = affine_->energy();
    }
    if (++iteration_ < steps()) return true;
    affine_.reset();
    correspondences_.reset();
    return false;
}

} // namespace lissom
