#pragma once

#include "lissom/merge/plane_map.h"

#include <span>
#include <vector>

namespace lissom {

/// How the source's map lies on the target's: x ↦ scale · turn(x) + shift.
struct Placement {
    Eigen::Vector2d shift = Eigen::Vector2d::Zero();
    double turn = 0; ///< degrees, counter-clockwise
    double scale = 1;

    [[nodiscard]] PlanePoints operator()(const PlanePoints& points) const;
};

/// The painted regions of optimal boundary merging and their plane maps (Fu 3.4.1). Maps keep the surfaces'
/// orientation, seen from outside; each has its centroid at the origin and area π.
struct RegionMaps {
    TriangleMesh ring;              ///< Ω₀ without the feature
    std::vector<int> ring_vertices; ///< source vertices of it
    std::vector<int> outer, inner;  ///< its borders ∂Ω₀ and ∂Ω_feature, ring vertices, the ring to the left
    PlanePoints ring_map;           ///< conformal, the feature's hole filled first

    TriangleMesh disk;              ///< Ω₁
    std::vector<int> disk_vertices, disk_triangles; ///< of the target
    std::vector<int> border;        ///< of Ω₁, disk vertices, the disk to the left
    PlanePoints disk_map;
};

/// Regions hold the triangles whose three vertices are painted.
///
/// @param region,feature  source vertices; the feature lies within the region and may have any topology
/// @param target_region   target vertices
/// @throws InvalidInput `no-feature`, `feature-outside-region`, `region-touches-feature`, `region-not-a-ring` (it has
///   holes, several pieces or handles of its own), `no-target-region`, `target-region-not-a-disk`
[[nodiscard]] RegionMaps map_regions(const TriangleMesh& source, std::span<const int> region, std::span<const int> feature,
                                     const TriangleMesh& target, std::span<const int> target_region);

} // namespace lissom
