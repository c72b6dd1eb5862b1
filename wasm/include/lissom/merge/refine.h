#pragma once

#include "lissom/merge/part.h"

namespace lissom {

/// Bisects triangles until no edge of the loop is longer than `longest`, working inward from the loop no farther than
/// needed: longest edges first (Rivara 1984), so that no angle falls below half the least there was. Vertices and
/// loop vertices keep their numbers, new ones come last; ties fall to the smaller vertex.
/// Fu 2.5: boundaries with few vertices beside a large region are refined first.
/// @returns how many vertices were added
int refine_loop(Part& part, int loop, double longest);

} // namespace lissom
