#include "lissom/mesh/disjoint_sets.h"

#include "shapes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <utility>

using lissom::DisjointSets;

TEST_CASE("everything is alone at first, and joining what is joined changes nothing") {
    DisjointSets sets(4);
    for (int i = 0; i < 4; ++i) CHECK(sets.find(i) == i);
    sets.join(3, 1);
    sets.join(1, 3);
    sets.join(2, 2);
    CHECK(sets.find(3) == 1);
    CHECK(sets.find(1) == 1);
    CHECK(sets.find(0) == 0);
    CHECK(sets.find(2) == 2);
}

TEST_CASE("groups and their names do not depend on the order of joining (seeds 1 to 20)") {
    const int n = 60;
    std::vector<std::pair<int, int>> joins;
    for (int i = 0; i < n; ++i) joins.emplace_back(i, (i * 17 + 5) % n / 4 * 4);
    // What is joined, by flooding labels until nothing changes.
    std::vector<int> label(n);
    std::iota(label.begin(), label.end(), 0);
    for (bool changed = true; changed;) {
        changed = false;
        for (const auto& [a, b] : joins)
            if (label[a] != label[b]) {
                label[a] = label[b] = std::min(label[a], label[b]);
                changed = true;
            }
    }
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        CAPTURE(seed);
        DisjointSets sets(n);
        for (const int k : shapes::permutation(n, seed)) sets.join(joins[k].first, joins[k].second);
        for (int i = 0; i < n; ++i) CHECK(sets.find(i) == label[i]);
    }
}
