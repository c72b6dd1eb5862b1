#pragma once

#include "lissom/merge/region_maps.h"
#include "lissom/mesh/similarity.h"

namespace lissom {

struct OptimalBoundary {
    std::vector<int> loop;             ///< source vertices in order, the feature to the left
    std::vector<PlanePlace> places;    ///< of each, on the disk Ω₁ (triangles of `RegionMaps::disk`)
    PlanePoints outline;               ///< of each, in the disk's plane
    std::vector<double> energies;      ///< E(∂Ω₀, T) first, then after each round; never rises
    Similarity map;                    ///< the last T
};

/// Where the source's map lies well by itself: its border within the disk, turned so that E(∂Ω₀, T) is least of 72 turns.
[[nodiscard]] Placement best_placement(const RegionMaps& maps);

/// The boundary that changes least but for a similarity when it is carried to the target (Fu 3.4.2, 3.4.3):
///
///     E(∂Ω, T) = Σ_e √(‖T e − e*‖² + ‖T n − n*‖²) · length(e)
///
/// where n is the surface's normal at the edge, as long as the edge, and n* that at its image, as long as T n. Eq 3.1
/// has the edges alone; then a boundary may run where the source stands steeply on the target, and the merge, which
/// turns normals into normals, distorts it there. Fu 3.5 asks for local frames in the energy.
///
/// Alternates T for the boundary and the boundary for T (a cheapest cycle). T starts from the closed form that
/// the thesis uses and is then improved for E itself by reweighting, and taken only where it is better, so the energy
/// cannot rise.
/// @throws InvalidInput `placement-outside`  the region's border leaves the target region
[[nodiscard]] OptimalBoundary optimal_boundary(const RegionMaps& maps, const Placement& placement, int rounds = 50);

} // namespace lissom
