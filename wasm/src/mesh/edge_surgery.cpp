#include "lissom/mesh/edge_surgery.h"

#include <algorithm>
#include <iterator>

namespace lissom {

EdgeSurgery::EdgeSurgery(const Triangles& triangles, int vertices) : around_(static_cast<std::size_t>(vertices)) {
    for (int t = 0; t < triangles.rows(); ++t) {
        const Corners c{triangles(t, 0), triangles(t, 1), triangles(t, 2)};
        if (c[0] == c[1] || c[1] == c[2] || c[2] == c[0]) continue;
        triangles_.push_back(c);
        attach(static_cast<int>(triangles_.size()) - 1);
    }
    gone_.assign(triangles_.size(), 0);
    vertices_ = static_cast<int>(std::count_if(around_.begin(), around_.end(), [](const auto& list) { return !list.empty(); }));
}

void EdgeSurgery::attach(int triangle) {
    for (const int v : triangles_[triangle]) around_[v].push_back(triangle);
}

void EdgeSurgery::detach(int triangle) {
    for (const int v : triangles_[triangle]) std::erase(around_[v], triangle);
}

void EdgeSurgery::replace(int triangle, const Corners& corners) {
    detach(triangle);
    triangles_[triangle] = corners;
    attach(triangle);
}

std::vector<std::pair<int, int>> EdgeSurgery::edges() const {
    std::vector<std::pair<int, int>> all;
    std::vector<int> larger;
    for (int v = 0; v < numbered(); ++v) {
        larger.clear();
        for (const int t : around_[v])
            for (const int w : triangles_[t])
                if (w > v) larger.push_back(w);
        std::sort(larger.begin(), larger.end());
        larger.erase(std::unique(larger.begin(), larger.end()), larger.end());
        for (const int w : larger) all.emplace_back(v, w);
    }
    return all;
}

std::vector<int> EdgeSurgery::ring(int v) const {
    std::vector<int> all;
    for (const int t : around_[v])
        for (const int w : triangles_[t])
            if (w != v) all.push_back(w);
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
}

/// Around an inner vertex every neighbour stands in two triangles.
bool EdgeSurgery::on_border(int v) const { return ring(v).size() != around_[v].size(); }

EdgeSurgery::Sides EdgeSurgery::sides(int a, int b) const {
    Sides found;
    for (const int t : around_[a])
        for (int k = 0; k < 3; ++k) {
            const Corners& c = triangles_[t];
            const int from = c[k], to = c[(k + 1) % 3], corner = c[(k + 2) % 3];
            if (from == a && to == b) {
                found.sound = found.sound && found.left < 0;
                found.left = t;
                found.left_corner = corner;
            } else if (from == b && to == a) {
                found.sound = found.sound && found.right < 0;
                found.right = t;
                found.right_corner = corner;
            }
        }
    return found;
}

int EdgeSurgery::split(int a, int b) {
    const Sides at = sides(a, b);
    if (!at.sound || (at.left < 0 && at.right < 0)) return -1;
    const int middle = numbered();
    around_.emplace_back();
    ++vertices_;
    for (const int t : {at.left, at.right}) {
        if (t < 0) continue;
        Corners first = triangles_[t], second = first;
        std::replace(first.begin(), first.end(), b, middle);
        std::replace(second.begin(), second.end(), a, middle);
        replace(t, first);
        triangles_.push_back(second);
        gone_.push_back(0);
        attach(static_cast<int>(triangles_.size()) - 1);
    }
    return middle;
}

bool EdgeSurgery::may_collapse(int a, int b) const {
    const Sides at = sides(a, b);
    if (!at.sound || (at.left < 0 && at.right < 0)) return false;
    if (at.inner() && on_border(a) && on_border(b)) return false;
    const std::vector<int> ring_a = ring(a), ring_b = ring(b);
    std::vector<int> common;
    std::set_intersection(ring_a.begin(), ring_a.end(), ring_b.begin(), ring_b.end(), std::back_inserter(common));
    if (std::ssize(common) != (at.left >= 0) + (at.right >= 0)) return false;
    return std::none_of(common.begin(), common.end(), [&](int corner) { return around_[corner].size() <= (on_border(corner) ? 1u : 3u); });
}

void EdgeSurgery::collapse(int kept, int taken) {
    const Sides at = sides(kept, taken);
    for (const int t : {at.left, at.right})
        if (t >= 0) {
            detach(t);
            gone_[t] = 1;
        }
    for (const int t : std::vector<int>(around_[taken])) {
        Corners corners = triangles_[t];
        std::replace(corners.begin(), corners.end(), taken, kept);
        replace(t, corners);
    }
    --vertices_;
}

bool EdgeSurgery::may_swap(int a, int b) const {
    const Sides at = sides(a, b);
    if (!at.inner() || at.left_corner == at.right_corner) return false;
    if (around_[a].size() <= 3 || around_[b].size() <= 3) return false;
    const std::vector<int> near = ring(at.left_corner);
    return !std::binary_search(near.begin(), near.end(), at.right_corner);
}

void EdgeSurgery::swap(int a, int b) {
    const Sides at = sides(a, b);
    replace(at.left, {a, at.right_corner, at.left_corner});
    replace(at.right, {at.right_corner, b, at.left_corner});
}

std::pair<std::vector<int>, int> EdgeSurgery::numbering() const {
    std::vector<int> place(around_.size(), -1);
    int count = 0;
    for (std::size_t v = 0; v < around_.size(); ++v)
        if (!around_[v].empty()) place[v] = count++;
    return {std::move(place), count};
}

Triangles EdgeSurgery::triangles(const std::vector<int>& place) const {
    Triangles all(static_cast<Eigen::Index>(std::count(gone_.begin(), gone_.end(), 0)), 3);
    int row = 0;
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
        if (gone_[t]) continue;
        for (int k = 0; k < 3; ++k) all(row, k) = place[triangles_[t][k]];
        ++row;
    }
    return all;
}

} // namespace lissom
