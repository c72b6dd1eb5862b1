#pragma once

// How well the sharp curves of a model lie on edges of a skin.

#include "lissom/match/sharp_paths.h"

namespace sharp_truth {

struct Error {
    double mean, most;
};
/// Distances of places all along the lines from the edges of the paths on the skin, as shares of a diagonal.
[[nodiscard]] Error error(const std::vector<lissom::SharpLine>& lines, const lissom::Points& skin, const std::vector<lissom::SharpPath>& paths, double diagonal);

/// Whether every path is a chain of the skin's edges and no vertex is in two but at their ends.
[[nodiscard]] bool are_single(const lissom::TriangleMesh& skin, const std::vector<lissom::SharpPath>& paths);

} // namespace sharp_truth
