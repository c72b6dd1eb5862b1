#pragma once

#include "lissom/merge/stitch.h"

namespace lissom {

/// How a seam looks, in degrees; 0 where there is nothing to measure.
struct SeamFigures {
    int vertices = 0;            ///< on all seams
    double median_dihedral = 0;  ///< of the edges along the seam: 0 is flat
    double high_dihedral = 0;    ///< 90 % of them lie below
    double max_dihedral = 0;
    double own_high_dihedral = 0; ///< 90 % of all other edges lie below
    double least_angle = 180;    ///< of the triangles cut or made for the seam
};

[[nodiscard]] SeamFigures seam_figures(const JoinedMesh& joined);

/// Moves the seam's vertices (and no others) towards the mean of their neighbours, weighted by nearness, `iterations`
/// times: the umbrella operator (Kobbelt et al. 1998; scale-dependent weights: Desbrun et al. 1999).
void smooth_seam(JoinedMesh& joined, int iterations);

} // namespace lissom
