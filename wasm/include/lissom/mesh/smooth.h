#pragma once

#include <algorithm>

namespace lissom {

/// From 0 to 1 as t goes from 0 to 1, level at both ends and beyond them.
[[nodiscard]] inline double smooth(double t) {
    t = std::clamp(t, 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

} // namespace lissom
