#pragma once

#include "lissom/mesh/types.h"

namespace lissom {

/// Flips edges until the two angles that face each are together at most half a turn, so that its cotangent weight is not
/// negative and no needle is left that a flip can mend. Stay as they are: edges without exactly two triangles that agree
/// about their sides, and those whose flip would fold or bend the surface by more than some 25 degrees.
///
/// Cost: linear but for long runs of flips, which are cut short. Deterministic.
/// @returns how many were flipped
int flip_to_delaunay(TriangleMesh& mesh);

} // namespace lissom
