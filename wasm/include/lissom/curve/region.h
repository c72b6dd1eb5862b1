#pragma once

#include "lissom/curve/spline.h"
#include "lissom/curve/surface.h"

#include <vector>

namespace lissom {

/// What of a model follows a curve, in source vertices, each list ascending. Vertices in none of them stay at rest.
struct CurveRegion {
    std::vector<int> vertices;           ///< follow the curve itself
    std::vector<double> places;          ///< of each of them: its place t along the curve, to about a fiftieth of a span
    std::vector<int> startSide, endSide; ///< the rest that touches that end: follows its frame
    std::vector<int> between;            ///< the rest that touches both ends: to be blended between their frames
};

enum class RegionMethod {
    local, ///< near the curve: limited distance, end disks, flood from everything that was hit
    planes ///< the thesis's: between two infinite planes, flood from the two end triangles (Blanco 3.1.2, Alg. 2)
};

struct RegionOptions {
    double kappa = 1.5;                ///< reach in local radii, > 0
    RegionMethod method = RegionMethod::local;
    std::vector<int> hits = {};        ///< working triangles that the stroke met; empty: those nearest to the curve
};

/// Finds the region of a curve at rest.
///
/// A vertex is inside where its nearest point of the curve is not an end, or is one and the vertex lies on the inner side of the disk
/// there, and its distance is less than κ r(t). The region is what is inside and hangs together with the seeds; of
/// pieces of the model without a seed, all that is inside. What remains is sorted by where it touches the region: pieces that touch it
/// along the side only belong to it too (a spike on a tail); pieces of the model without any vertex inside belong to
/// the end beyond which they lie, or to none.
///
/// Measured (17 limbs with strokes along them): precision 0.61–0.96 where two infinite planes reach 0.07–0.5, equal recall; κ = 1.5 beats 1.9
/// and 2.5. Where a stroke begins deep in a trunk the region takes some of that: let it be seen and trimmed.
/// Cost: the nearest of some tens of samples of the curve per vertex near it, a walk over the rest; half a million vertices some tenths of a second.
/// @param radius  per control point, source units; empty: measured by curve_radius
/// @returns no vertices at all where none is near the curve
/// @throws InvalidInput `curve-radius` (not one positive number per control point), `curve-reach` (κ not positive)
[[nodiscard]] CurveRegion curve_region(const CurveSurface& surface, const SplineCurve& rest, const std::vector<double>& radius, const RegionOptions& options = {});

/// The same from a model alone.
[[nodiscard]] CurveRegion curve_region(const WorkingMesh& model, const SplineCurve& rest, const std::vector<double>& radius = {}, double kappa = 1.5);

/// The local radius at each control point, from the section across the curve there: that of a circle of the same area, for a curve inside
/// a limb, but no more than 1.8 times the way to the nearest side (the section of a trunk at a branch); for a curve on a limb as
/// much as reaches its far side (0.7 of the way there); half the section's length on an open sheet. Source units.
[[nodiscard]] std::vector<double> curve_radius(const CurveSurface& surface, const SplineCurve& curve);

} // namespace lissom
