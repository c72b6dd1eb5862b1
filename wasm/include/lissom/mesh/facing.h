#pragma once

#include "lissom/mesh/types.h"

namespace lissom {

/// +1 where the surface faces outward, −1 where it faces inward, 0 where its shape does not tell (it is nearly flat, or
/// one-sided): by the volume enclosed once every opening is closed by a fan.
[[nodiscard]] int facing(const TriangleMesh& mesh);

} // namespace lissom
