#pragma once

#include "lissom/mesh/errors.h"

namespace lissom {

/// @throws InvalidInput `bad-option`  where the options do not hold what is asked of them
inline void demand(bool holds, const char* what) {
    if (!holds) throw InvalidInput("bad-option", what);
}

} // namespace lissom
