#pragma once

#include "lissom/mesh/types.h"

#include <cstdint>
#include <vector>

namespace lissom {

/// Places spread evenly over a surface, each by a triangle and the weights of its corners.
struct SurfaceSamples {
    std::vector<int> triangle;
    Points weights; ///< n×3, rows sum to 1

    [[nodiscard]] int size() const { return static_cast<int>(triangle.size()); }
    /// Where they are on a mesh with these triangles; n×3.
    [[nodiscard]] Points on(const TriangleMesh& mesh) const;
};

/// `count` samples, each standing for the same area: one in each of as many equal shares of it in the order of the triangles, inside
/// triangles by a sequence that fills them evenly. Depends on the seed alone, neither on where the surface stands nor on its size.
/// @returns none where there is no area
[[nodiscard]] SurfaceSamples sample_surface(const TriangleMesh& mesh, int count, std::uint64_t seed = 0);

} // namespace lissom
