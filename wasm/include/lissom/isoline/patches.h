#pragma once

#include "lissom/solve/sparse_cholesky.h"

#include <vector>

namespace lissom {

struct PatchOptions {
    int count = 150;            ///< patches beside those of region handles; fewer where there are fewer vertices
    int triangles = 4;          ///< sampled in each
    double position_share = 0.3; ///< of |dx| in the metric |dφ| + share · |dx| (D = 1)
};

/// A surface cut into patches that turn as one: carriers of rotations for the local step.
///
/// Each region handle is a patch of its own, whose rotation is known: patches [0, handles). The others are cells of
/// farthest points in the metric |dφ| + 0.3 |dx|. A paper's isoline (Isolines 4.3) joins loops on different limbs, whose mean turn is
/// none; a patch does not.
struct Patches {
    std::vector<int> of_vertex;              ///< per vertex; −1: on a piece without handle
    int count = 0;                           ///< handle patches included
    std::vector<std::vector<int>> triangles; ///< sampled in each patch, spread over it; none in handle patches
};

/// @param mesh    D = 1
/// @param fields  n×k; rows of zeros belong to no patch
/// @param region  per vertex the region handle whose rotation it takes, or −1
/// @param handles how many patches to keep for handles
[[nodiscard]] Patches cut_patches(const TriangleMesh& mesh, const Columns& fields, const std::vector<int>& region, int handles,
                                  const PatchOptions& options = {});

} // namespace lissom
