#pragma once

#include "lissom/merge/stitch.h"

namespace lissom {

/// Flips edges beside the seam, never the seam's own, where a triangle cut there has an angle under 8 degrees and the
/// flip makes the least angle of the two triangles larger without bending the surface.
/// @param target,source  the parts that were stitched
void flip_thin_triangles(JoinedMesh& joined, const Part& target, const Part& source);

} // namespace lissom
