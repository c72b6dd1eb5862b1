#pragma once

#include "lissom/mesh/types.h"

#include <array>
#include <vector>

namespace lissom {

/// The triangulation of a closed polyline in space of least area (Barequet and Sharir 1995; Fu 3.4.1), by dynamic
/// programming: n³/6 steps and n² numbers. Of loops of more than 512 corners every other one is cut off first, as often
/// as it takes. Each triangle runs along the loop.
/// @returns places in the loop, three a triangle
[[nodiscard]] std::vector<std::array<int, 3>> least_area_filling(const Points& points, const std::vector<int>& loop);

} // namespace lissom
