#include "lissom/mesh/polyline.h"

#include <algorithm>
#include <cmath>

namespace lissom {

using Eigen::Vector3d;

Polyline resampled(const Polyline& line, double step) {
    double length = 0;
    for (std::size_t i = 1; i < line.size(); ++i) length += (line[i] - line[i - 1]).norm();
    if (!(length > 0) || !std::isfinite(length)) return {};
    const int segments = std::max(1, static_cast<int>(std::lround(length / step)));
    Polyline out{line.front()};
    double walked = 0; // up to the start of the segment at hand
    std::size_t i = 1;
    for (int k = 1; k < segments; ++k) {
        const double wanted = length * k / segments;
        while (i + 1 < line.size() && walked + (line[i] - line[i - 1]).norm() < wanted) {
            walked += (line[i] - line[i - 1]).norm();
            ++i;
        }
        const Vector3d along = line[i] - line[i - 1];
        const double t = along.norm() > 0 ? (wanted - walked) / along.norm() : 0;
        out.push_back(line[i - 1] + std::min(1.0, t) * along);
    }
    out.push_back(line.back());
    return out;
}

double loop_length(const Points& points, const std::vector<int>& loop) {
    double length = 0;
    for (std::size_t i = 0; i < loop.size(); ++i) length += (points.row(loop[(i + 1) % loop.size()]) - points.row(loop[i])).norm();
    return length;
}

} // namespace lissom
