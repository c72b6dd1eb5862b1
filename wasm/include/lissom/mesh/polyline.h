#pragma once

#include "lissom/mesh/types.h"

#include <vector>

namespace lissom {

using Polyline = std::vector<Eigen::Vector3d>; ///< in order, as it was drawn

/// The polyline in segments of equal length, as near to `step` as whole segments allow.
/// Fewer than two different points give an empty line.
[[nodiscard]] Polyline resampled(const Polyline& line, double step);

/// Length of a closed polyline through vertices.
[[nodiscard]] double loop_length(const Points& points, const std::vector<int>& loop);

} // namespace lissom
