#pragma once

#include "lissom/mesh/types.h"

namespace lissom {

/// @throws InvalidInput `wrong-size`, `vertex-out-of-range`, `non-finite-position` where two skins are not of one connectivity, or of none
void check_skins(const Triangles& triangles, const Points& from, const Points& to);

} // namespace lissom
