#pragma once

#include "lissom/mesh/types.h"

#include <vector>

namespace lissom {

/// Where on a surface some points lie nearest: what is known of its corners can be read there.
struct SurfacePlaces {
    std::vector<int> triangle; ///< −1: there is none
    Points weights;            ///< n×3 of its corners, none negative, rows sum to 1
};

/// @param points  n×3. Cost: a tree, then a walk of it for each.
[[nodiscard]] SurfacePlaces places_on(const TriangleMesh& surface, const Points& points);

} // namespace lissom
