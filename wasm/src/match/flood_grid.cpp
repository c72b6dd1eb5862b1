#include "lissom/match/flood_grid.h"

#include "lissom/mesh/errors.h"
#include "lissom/mesh/operators.h"
#include "lissom/mesh/point_tree.h"
#include "lissom/mesh/surface_samples.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

namespace lissom {

using Eigen::Vector3d;
using Eigen::Vector3i;

namespace {

constexpr int k_samples = 20000, k_neighbours = 6;
constexpr double k_quantile = 0.95;
constexpr double k_least_cells = 1.5;      // of radius
constexpr double k_first = 0.8, k_raise = 1.2, k_last = 3; // of the spacing
constexpr double k_most_surface_cells = 60000;
constexpr int k_block = 8;                 // nodes along a side
constexpr int k_blocks_a_slice = 60;
/// Growth of the fill from radius to radius, by that of a surface that moves outwards, above which the flood had run inside.
constexpr double k_jump = 2.5;

} // namespace

void check_cells(int cells) {
    if (cells < 20 || cells > 400) throw InvalidInput("bad-option", "The number of cells is " + std::to_string(cells) + "; it must be between 20 and 400.");
}

FloodGrid::FloodGrid(const TriangleMesh& model, int cells) : tree_(model) {
    const double area = triangle_areas(model).sum();
    Points samples = model.points;
    if (area > 0) samples = sample_surface(model, k_samples).on(model);
    if (samples.rows() < 2 || !(diagonal(samples) > 0)) throw InvalidInput("flat-model", "There is nothing to wrap: the model is a single place. Choose another model.");
    measure(samples);
    const Eigen::RowVector3d low = samples.colwise().minCoeff(), high = samples.colwise().maxCoeff();
    // Scattered points have the area of the discs that they stand for.
    const double covered = area > 0 ? area : static_cast<double>(samples.rows()) * spacing_ * spacing_ * 0.5;
    const double longest = (high - low).maxCoeff();
    grid_.step = std::max(longest / cells, std::sqrt(covered / k_most_surface_cells));
    const double first = std::max(k_first * spacing_, k_least_cells * grid_.step);
    for (double r = first; r <= k_last * std::max(spacing_, first / k_first) * (1 + 1e-9); r *= k_raise) radii_.push_back(r);
    const double margin = radii_.back() + 2 * grid_.step;
    grid_.origin = (low.array() - margin).matrix().transpose();
    for (int k = 0; k < 3; ++k) grid_.size[k] = static_cast<int>(std::ceil((high[k] - low[k] + 2 * margin) / grid_.step)) + 1;
    for (int k = 0; k < 3; ++k) blocks_[k] = (grid_.size[k] + k_block - 1) / k_block;
    distances_.assign(static_cast<std::size_t>(grid_.count()), static_cast<float>(reach()));
}

/// The 95 % quantile of the distance to the sixth neighbour.
void FloodGrid::measure(const Points& samples) {
    const PointTree near(samples);
    std::vector<std::pair<int, double>> found;
    std::vector<double> lengths;
    for (Eigen::Index i = 0; i < samples.rows(); ++i) {
        near.nearest(samples.row(i).transpose(), k_neighbours + 1, found);
        lengths.push_back(std::sqrt(found.back().second));
    }
    const auto at = lengths.begin() + static_cast<std::ptrdiff_t>(k_quantile * static_cast<double>(lengths.size() - 1));
    std::nth_element(lengths.begin(), at, lengths.end());
    spacing_ = *at;
}

/// Halves a box of nodes until it is one node or wholly out of reach.
void FloodGrid::ask(const Vector3i& from, const Vector3i& to, int hint) {
    const Vector3i size = to - from;
    if ((size.array() <= 0).any()) return;
    const Vector3d middle = grid_.origin + grid_.step * (from + to - Vector3i::Ones()).cast<double>() / 2;
    const double around = grid_.step * (size - Vector3i::Ones()).cast<double>().norm() / 2;
    const auto found = tree_.nearest_where(middle, reach() + around, hint, [](int) { return true; });
    if (found.triangle < 0) return; // out of reach
    if (size.maxCoeff() == 1) {
        distances_[grid_.node(from.x(), from.y(), from.z())] = static_cast<float>(std::min(found.distance, reach()));
        return;
    }
    int axis = 0;
    size.maxCoeff(&axis);
    Vector3i cut_to = to, cut_from = from;
    cut_to[axis] = cut_from[axis] = from[axis] + size[axis] / 2;
    ask(from, cut_to, found.triangle);
    ask(cut_from, to, found.triangle);
}

void FloodGrid::ask_blocks() {
    const int all = blocks_.prod();
    for (int k = 0; k < k_blocks_a_slice && block_ < all; ++k, ++block_) {
        const Vector3i at(block_ % blocks_.x(), block_ / blocks_.x() % blocks_.y(), block_ / (blocks_.x() * blocks_.y()));
        ask(k_block * at, (k_block * (at + Vector3i::Ones())).cwiseMin(grid_.size), -1);
    }
}

std::vector<char> FloodGrid::reached(double r) const {
    std::vector<char> reached(distances_.size(), 0);
    std::vector<int> open;
    const auto reach_node = [&](int i) {
        if (reached[i] || !(distances_[i] > r)) return;
        reached[i] = 1;
        open.push_back(i);
    };
    for (int i = 0; i < grid_.count(); ++i) {
        const Vector3i c = grid_.cell(i);
        if ((c.array() == 0).any() || (c.array() == grid_.size.array() - 1).any()) reach_node(i);
    }
    while (!open.empty()) {
        const Vector3i c = grid_.cell(open.back());
        open.pop_back();
        for (int bits = 1; bits < 8; ++bits)
            for (const int sign : {-1, 1}) {
                const Vector3i d = c + sign * Vector3i(bits & 1, bits >> 1 & 1, bits >> 2);
                if ((d.array() >= 0).all() && (d.array() < grid_.size.array()).all()) reach_node(grid_.node(d.x(), d.y(), d.z()));
            }
    }
    return reached;
}

FloodGrid::Fill FloodGrid::fill_of(const std::vector<char>& reached) const {
    Fill fill{0, 0};
    const int steps[] = {1, grid_.size.x(), grid_.size.x() * grid_.size.y()};
    for (int i = 0; i < grid_.count(); ++i) {
        fill.nodes += !reached[i];
        const Vector3i c = grid_.cell(i);
        for (int k = 0; k < 3; ++k)
            if (c[k] + 1 < grid_.size[k]) fill.faces += reached[i] != reached[i + steps[k]];
    }
    fill.faces /= 1.5; // a surface that lies anyhow has so many more faces of cells than its area
    return fill;
}

void FloodGrid::find_sound() {
    for (std::size_t i = 0; i + 1 < radii_.size(); ++i) {
        const double step = (radii_[i + 1] - radii_[i]) / grid_.step, grown = fills_[i + 1].nodes - fills_[i].nodes;
        if (grown > k_jump * step * std::max(fills_[i].faces, fills_[i + 1].faces)) sound_ = static_cast<int>(i + 1);
    }
}

bool FloodGrid::step() {
    if (block_ < blocks_.prod()) {
        ask_blocks();
        return true;
    }
    if (fills_.size() < radii_.size()) {
        fills_.push_back(fill_of(reached(radii_[fills_.size()])));
        if (fills_.size() == radii_.size()) find_sound();
    }
    return fills_.size() < radii_.size();
}

double FloodGrid::fraction() const {
    constexpr double asked = 2.0 / 3; // of the time as measured
    return asked * block_ / blocks_.prod() + (1 - asked) * static_cast<double>(fills_.size()) / static_cast<double>(radii_.size());
}

} // namespace lissom
