#include "lissom/hair/style.h"
#include "node_vectors.h"

#include <cmath>

namespace lissom {

using Eigen::Vector3d;

namespace {
constexpr int k_fade_segments = 4; // extrapolated segments over which the magnitude falls from 1 to 0
}

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

void add_stream(NodeVectors& out, const StreamCurve& curve) {
    const Polyline line = resampled(curve.points, out.grid().step);
    for (std::size_t i = 1; i < line.size(); ++i)
        out.add_around((line[i] + line[i - 1]) / 2, (line[i] - line[i - 1]).normalized());
    if (!curve.fade || line.size() < 2) return;
    const Vector3d along = line.back() - line[line.size() - 2];
    for (int k = 1; k <= k_fade_segments; ++k)
        out.add_around(line.back() + (k - 0.5) * along, along.normalized() * (1 - static_cast<double>(k) / k_fade_segments));
}

} // namespace lissom
