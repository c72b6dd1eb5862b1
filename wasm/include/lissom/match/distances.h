#pragma once

#include "lissom/mesh/types.h"

#include <vector>

namespace lissom {

/// How far two surfaces are apart, in their unit.
struct SurfaceDistances {
    double mean_there = 0, mean_back = 0; ///< from the first to the second, from the second to the first
    double most = 0;                      ///< 99 of 100 samples are nearer than this, the larger of both ways
};

/// By `samples` samples each way, each standing for the same area. NaN where one has no area.
/// @param first_out,second_out  one flag per triangle, or none: nothing is measured from there, though to there it may be
[[nodiscard]] SurfaceDistances surface_distances(const TriangleMesh& first, const TriangleMesh& second, int samples = 20000, const std::vector<char>& first_out = {},
                                                 const std::vector<char>& second_out = {});

/// The triangles that are not flagged, of all vertices.
[[nodiscard]] TriangleMesh without_triangles(const TriangleMesh& mesh, const std::vector<char>& out);

/// √12 times the root mean square distance of the surface from its middle: the diagonal of the bounding box for a line and for a sphere, but
/// the same however the surface is turned and triangulated. 0 without area.
struct SurfaceSize {
    Eigen::RowVector3d middle = Eigen::RowVector3d::Zero(); ///< centre of the area
    double size = 0;
};
[[nodiscard]] SurfaceSize surface_size(const TriangleMesh& mesh);

} // namespace lissom
