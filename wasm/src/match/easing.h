#pragma once

#include <cmath>

namespace lissom {

/// From one value to another by equal factors: `at` in [0, 1].
inline double eased(double first, double last, double at) { return first * std::pow(last / first, at); }
inline double along(int step, int steps) { return steps > 1 ? static_cast<double>(step) / (steps - 1) : 1; }

} // namespace lissom
