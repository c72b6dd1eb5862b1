#pragma once

#include "lissom/mesh/surface_paths.h"

#include <vector>

namespace lissom {

/// A closed way around a ring: it starts at the left copy of a vertex of the slit and ends at its right copy.
struct RingCycle {
    std::vector<int> path; ///< vertices of the slit ring; the last is the first's other copy
    double cost = 0;       ///< infinity: there is none
    int searches = 0;      ///< single-pair searches done
};

/// The cheapest way around a ring that crosses the slit once (Fu 3.4.3).
///
/// Fu searches from every vertex of the slit, O(M N log N). Cheapest ways from different vertices need not cross, so the
/// way from the middle one parts the ring in two, and either half of the others stays on its side: O(log M) passes
/// over the ring find the same minimum (Itai and Shiloach 1979; Reif 1983, for planar cuts).
/// @param graph       edges of the slit ring with their costs
/// @param left,right  the two copies of the slit's vertices, in order across the ring
[[nodiscard]] RingCycle cheapest_cycle(const WeightedGraph& graph, const std::vector<int>& left, const std::vector<int>& right);

/// The same by one search per vertex of the slit: what the fast one is tested against.
[[nodiscard]] RingCycle cheapest_cycle_by_all_searches(const WeightedGraph& graph, const std::vector<int>& left, const std::vector<int>& right);

} // namespace lissom
