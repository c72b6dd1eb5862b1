#pragma once

#include "lissom/mesh/working_mesh.h"

namespace lissom {

/// Where places near one skin lie on another of the same triangles: the nearest place's corners there, by the same weights.
/// @param from,to  skins of the same triangles. @param places  n×3, near `from`
/// @returns n×3 places on `to`; a place is left where it is if no triangle is to be found
/// @throws InvalidInput `wrong-size`, `index-out-of-range`
[[nodiscard]] Points carried_places(const TriangleMesh& from, const Points& to, const Points& places);

/// A guess of where a place of one model belongs on another: both at one size, laid onto each other by the markers so far (`align_markers`), then the
/// nearest place of the other that faces alike. With fewer than three markers models are taken to stand alike.
/// @param from_markers,to_markers  n×3, in the models' own spaces
/// @returns 1×3 on the other model's surface
/// @throws InvalidInput what `align_markers` says, `flat-model`
[[nodiscard]] Points guessed_place(const WorkingMesh& from, const WorkingMesh& to, const Points& from_markers, const Points& to_markers, const Eigen::Vector3d& place);

} // namespace lissom
