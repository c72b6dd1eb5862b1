#include "lissom/mesh/weld.h"

#include "lissom/mesh/disjoint_sets.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

namespace lissom {

namespace {

using Key = std::array<std::uint64_t, 3>;

/// Numbers keys in the order in which they are first seen. Open addressing, as it is the hottest loop of import.
class KeyNumbers {
public:
    explicit KeyNumbers(std::size_t expected) : slots_(std::bit_ceil(2 * expected + 2), -1) { keys_.reserve(expected); }

    /// −1: not seen
    [[nodiscard]] int find(const Key& key) const { return slots_[slot(key)]; }
    int find_or_add(const Key& key) {
        int& number = slots_[slot(key)];
        if (number < 0) {
            number = static_cast<int>(keys_.size());
            keys_.push_back(key);
        }
        return number;
    }

private:
    [[nodiscard]] std::size_t slot(const Key& key) const {
        std::uint64_t h = 0;
        for (const std::uint64_t word : key) {
            h = (h ^ word) * 0x9e3779b97f4a7c15u;
            h ^= h >> 29;
        }
        const std::size_t mask = slots_.size() - 1;
        std::size_t at = (h ^ (h >> 32)) & mask;
        while (slots_[at] >= 0 && keys_[slots_[at]] != key)
            at = (at + 1) & mask;
        return at;
    }
    std::vector<int> slots_; ///< power of two, at most half full
    std::vector<Key> keys_;
};

} // namespace

std::vector<int> exact_twins(const Points& points, const std::vector<bool>& used) {
    KeyNumbers numbers(points.rows());
    std::vector<int> first, twins(points.rows(), -1);
    for (int v = 0; v < points.rows(); ++v) {
        if (!used[v])
            continue;
        Key key;
        for (int axis = 0; axis < 3; ++axis)
            key[axis] = Eigen::numext::bit_cast<std::uint64_t>(points(v, axis) + 0.0); // −0 + 0 is 0
        const int number = numbers.find_or_add(key);
        if (number == static_cast<int>(first.size()))
            first.push_back(v);
        twins[v] = first[number];
    }
    return twins;
}

std::vector<int> near_twins(const Points& points, std::span<const int> candidates, double tolerance) {
    const double cell = 8 * tolerance; // wide enough that a point's reach seldom crosses into the next cell
    const auto cell_of = [&](double x) {
        return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(x / cell)));
    };
    const int count = static_cast<int>(candidates.size());
    KeyNumbers numbers(count);
    std::vector<int> head, next(count, -1); // chains of the leaders in each cell
    DisjointSets groups(count);
    for (int i = 0; i < count; ++i) {
        const Eigen::RowVector3d p = points.row(candidates[i]);
        std::array<std::array<std::uint64_t, 2>, 3> reach;
        for (int axis = 0; axis < 3; ++axis)
            reach[axis] = {cell_of(p[axis] - tolerance), cell_of(p[axis] + tolerance)};
        bool joined = false;
        for (int corner = 0; corner < 8; ++corner) {
            const std::array<int, 3> high{corner & 1, corner >> 1 & 1, corner >> 2};
            Key key;
            bool is_new = true;
            for (int axis = 0; axis < 3; ++axis) {
                key[axis] = reach[axis][high[axis]];
                is_new = is_new && !(high[axis] && reach[axis][0] == reach[axis][1]);
            }
            const int number = is_new ? numbers.find(key) : -1;
            for (int j = number < 0 ? -1 : head[number]; j >= 0; j = next[j])
                if ((points.row(candidates[j]) - p).norm() <= tolerance) {
                    groups.join(i, j);
                    joined = true;
                }
        }
        if (joined) // its leaders stand for it, so a cell holds few points however many crowd there
            continue;
        const int number = numbers.find_or_add({cell_of(p[0]), cell_of(p[1]), cell_of(p[2])});
        if (number == static_cast<int>(head.size()))
            head.push_back(-1);
        next[i] = head[number];
        head[number] = i;
    }
    std::vector<int> twins(count);
    for (int i = 0; i < count; ++i)
        twins[i] = candidates[groups.find(i)];
    return twins;
}

std::vector<bool> repeated_triangles(const Triangles& triangles) {
    KeyNumbers numbers(triangles.rows());
    std::vector<bool> repeated(triangles.rows());
    int seen = 0;
    for (int t = 0; t < triangles.rows(); ++t) {
        Key key{};
        for (int k = 0; k < 3; ++k)
            key[k] = static_cast<std::uint64_t>(triangles(t, k));
        std::sort(key.begin(), key.end());
        repeated[t] = numbers.find_or_add(key) < seen;
        seen += repeated[t] ? 0 : 1;
    }
    return repeated;
}

} // namespace lissom
