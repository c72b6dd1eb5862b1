#pragma once

#include "lissom/mesh/grid.h"

#include <span>

namespace lissom {

enum class UpAxis { x, y, z };

/// Where hair can be: fixed for a head as long as its style is edited (Fu 4.6).
struct HairVolume {
    double head_height = 1; ///< head units; what the sizes of hair are measured by
    UpAxis up = UpAxis::y;
    Grid field;             ///< nodes of the vector field
    Grid distance;          ///< finer, closer round the head
    TriangleMesh head;      ///< the triangles that matter to hair: all of a head, a body's from the chest up
};

/// The volume round a head, by its scalp and its bounding box: 0.45 head heights wider on every side, 0.25 higher,
/// 0.8 lower, for hair hangs. Of a mesh much larger than its scalp (a body) only what lies near the scalp counts.
///
/// @param scalp       vertices that hair grows on
/// @param resolution  nodes of the field along the longest side, 16..96
/// @throws InvalidInput `scalp-empty`, `scalp-vertex`, `bad-resolution`, `scalp-too-small` (below 1e-10 of the distance of the farthest vertex)
[[nodiscard]] HairVolume hair_volume(const TriangleMesh& mesh, std::span<const int> scalp, int resolution,
                                     UpAxis up = UpAxis::y);

} // namespace lissom
