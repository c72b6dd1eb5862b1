#include "lissom/curve/profile.h"

#include <algorithm>
#include <cmath>

namespace lissom {

MonotoneProfile::MonotoneProfile(std::vector<double> places, std::vector<double> values)
    : places_(std::move(places)), values_(std::move(values)), slopes_(values_.size(), 0.0) {
    const int n = static_cast<int>(values_.size());
    std::vector<double> rise(std::max(n - 1, 0));
    for (int i = 0; i + 1 < n; ++i) {
        const double width = places_[i + 1] - places_[i];
        rise[i] = width > 0 ? (values_[i + 1] - values_[i]) / width : 0;
    }
    for (int i = 0; i < n; ++i) {
        if (i > 0 && i < n - 1) slopes_[i] = rise[i - 1] * rise[i] > 0 ? (rise[i - 1] + rise[i]) / 2 : 0;
    }
    for (int i = 0; i + 1 < n; ++i) { // within a circle of radius 3 the cubic is monotone (Fritsch and Carlson, S₁)
        if (rise[i] == 0) {
            slopes_[i] = slopes_[i + 1] = 0;
            continue;
        }
        const double a = slopes_[i] / rise[i], b = slopes_[i + 1] / rise[i], size = std::hypot(a, b);
        if (size > 3) {
            slopes_[i] = 3 * a / size * rise[i];
            slopes_[i + 1] = 3 * b / size * rise[i];
        }
    }
}

double MonotoneProfile::at(double place) const {
    if (place <= places_.front()) return values_.front();
    if (place >= places_.back()) return values_.back();
    const int i = static_cast<int>(std::upper_bound(places_.begin(), places_.end(), place) - places_.begin()) - 1;
    const double width = places_[i + 1] - places_[i], u = (place - places_[i]) / width;
    const double u2 = u * u, u3 = u2 * u;
    return (2 * u3 - 3 * u2 + 1) * values_[i] + (3 * u2 - 2 * u3) * values_[i + 1] + width * ((u3 - 2 * u2 + u) * slopes_[i] + (u3 - u2) * slopes_[i + 1]);
}

} // namespace lissom
