#pragma once

#include "lissom/mesh/surface_places.h"

#include <cstdint>

namespace lissom {

/// `count` samples, each standing for the same area: one in each of as many equal shares of it in the order of the triangles, inside
/// triangles by a sequence that fills them evenly. Depends on the seed alone, neither on where the surface stands nor on its size.
/// @returns none where there is no area
[[nodiscard]] SurfacePlaces sample_surface(const TriangleMesh& mesh, int count, std::uint64_t seed = 0);

} // namespace lissom
