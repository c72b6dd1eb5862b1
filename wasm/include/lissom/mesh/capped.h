#pragma once

#include "lissom/mesh/types.h"

namespace lissom {

/// The mesh with a fan from its centre over every boundary loop: the loops' centres are the last vertices, the fans the
/// last triangles, and they face as the surface beside them does.
[[nodiscard]] TriangleMesh capped(const TriangleMesh& mesh);

} // namespace lissom
