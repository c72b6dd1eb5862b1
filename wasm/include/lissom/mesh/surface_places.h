#pragma once

#include "lissom/mesh/types.h"

#include <vector>

namespace lissom {

/// Places on a surface, each by a triangle and the weights of its corners: what is known of the corners can be read there.
struct SurfacePlaces {
    std::vector<int> triangle; ///< −1: there is none
    Points weights;            ///< n×3, none negative, rows sum to 1

    [[nodiscard]] int size() const { return static_cast<int>(triangle.size()); }
    /// Where they are on a mesh with these triangles; n×3, the origin where there is none.
    [[nodiscard]] Points on(const TriangleMesh& mesh) const;
};

/// Where on a surface some points lie nearest.
/// @param points  n×3. Cost: a tree, then a walk of it for each.
[[nodiscard]] SurfacePlaces places_on(const TriangleMesh& surface, const Points& points);

} // namespace lissom
