#pragma once

#include "lissom/mesh/types.h"

#include <Eigen/Geometry>

#include <vector>

/// Closed ellipsoids that reach into one another, one mesh, and what the union's surface is.
struct LooseShape {
    struct Ellipsoid {
        Eigen::Vector3d middle, radii;
    };
    std::vector<Ellipsoid> ellipsoids;
    lissom::TriangleMesh mesh;

    /// How far inside one of the ellipsoids a place is, about; negative outside of all.
    [[nodiscard]] double depth(const Eigen::Vector3d& p) const;
    /// Places of the true outer surface, evenly.
    [[nodiscard]] lissom::Points outer_places(int count) const;
    /// Of the faceted outer surface, by samples.
    [[nodiscard]] double outer_area() const;
};

/// A toy bear of seven primitives: belly, head, ears, one for both arms, legs.
[[nodiscard]] LooseShape loose_bear(int levels);
