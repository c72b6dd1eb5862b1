#pragma once

#include "lissom/curve/surface.h"

#include <vector>

namespace lissom {

struct ProposedCurve {
    Points controls;            ///< n×3, source space; a child begins at its parent
    std::vector<double> radius; ///< per control point, source units
};

struct ProposedLink {
    int child, parent; ///< numbers of curves
    double at;         ///< parameter of the parent's curve, 0 or 1
};

/// Curves for a model with limbs, to begin with and to be edited. Links form trees.
struct ProposedSkeleton {
    std::vector<ProposedCurve> curves; ///< a parent before its children; the first is the thickest
    std::vector<ProposedLink> links;
};

/// Skeleton curves from level sets of the distance along the surface.
///
/// Distances run from a far tip of each piece of the model; bands of equal distance fall into rings, neighbouring rings form a graph (a
/// discrete Reeb graph), whose unbranched chains are limbs. Limbs shorter than twice their radius, or than the radius of what they grow from, are dropped,
/// what is left is joined again where it no longer branches. A limb's line goes through the centres of its rings, smoothed, and begins where it leaves
/// its parent's thickness. The thickest limb is the root; limbs that meet at its ends are its children, and so on.
/// After: Verroust and Lazarus, "Extracting skeletal curves from 3D scattered data", The Visual Computer 16, 2000.
/// Cost: one run of shortest paths; half a million vertices some seconds.
/// @throws InvalidInput `no-limbs`  nothing is clearly longer than it is thick
[[nodiscard]] ProposedSkeleton propose_curves(const CurveSurface& surface);

} // namespace lissom
