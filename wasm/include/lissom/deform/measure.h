#pragma once

#include "lissom/mesh/working_mesh.h"

namespace lissom {

/// What an edit did to a surface, in numbers that do not depend on its unit of length.
struct Measures {
    double volume_ratio = 1;          ///< enclosed volume after / before; (area ratio)^1.5 where nothing is enclosed:
                                      ///< the surface is open or one-sided, or as good as flat
    double edge_rms = 0;              ///< √mean((l/l₀ − 1)²) over edges
    double worst_stretch = 1;         ///< the edge length ratio l/l₀ farthest from 1 (as |log|)
    int flipped_triangles = 0;        ///< normals turned by more than 90° against their neighbours' mean turn
    std::vector<float> vertex_stretch; ///< per SOURCE vertex: mean of l/l₀ − 1 over its edges; 0 where unused
};

/// @param positions n×3 source positions after the edit
/// @throws InvalidInput `wrong-size`, `non-finite-position`
[[nodiscard]] Measures measure(const WorkingMesh& working, const Points& positions);

} // namespace lissom
