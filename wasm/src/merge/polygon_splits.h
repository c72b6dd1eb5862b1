#pragma once

#include <array>
#include <utility>
#include <vector>

namespace lissom {

/// The triangles of a polygon of n corners whose best triangulation is known by its splits.
/// @param split_of  (i, j), i < j → the corner k between that makes a triangle with the chord i–j
template <typename SplitOf>
std::vector<std::array<int, 3>> triangles_of_splits(int n, SplitOf&& split_of) {
    std::vector<std::array<int, 3>> triangles;
    std::vector<std::pair<int, int>> open{{0, n - 1}};
    while (!open.empty()) {
        const auto [i, j] = open.back();
        open.pop_back();
        if (j - i < 2) continue;
        const int k = split_of(i, j);
        triangles.push_back({i, k, j});
        open.emplace_back(i, k);
        open.emplace_back(k, j);
    }
    return triangles;
}

} // namespace lissom
