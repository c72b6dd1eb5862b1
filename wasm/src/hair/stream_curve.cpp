#include "lissom/hair/style.h"
#include "node_vectors.h"

namespace lissom {

using Eigen::Vector3d;

namespace {
constexpr int k_fade_segments = 4; // extrapolated segments over which the magnitude falls from 1 to 0
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
