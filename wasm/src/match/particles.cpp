#include "lissom/match/particles.h"

#include "lissom/match/smoothing_rings.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lissom {

using Eigen::RowVector3d;
using Eigen::Vector3d;

ParticleWeights ParticleWeights::at(int pass) { return {.smooth = std::max(0.02, 0.5 * std::exp(-pass / 20.0))}; }

Points repositioned(const TriangleMesh& skin, const FitSurface& surface, const std::vector<char>& held, const ParticleWeights& weights) {
    const double follow = 1 - weights.stay - weights.smooth; // γ
    const VertexRings rings = smoothing_rings(skin);
    Points places = skin.points;
    int hint = -1; // places nearest to neighbours in number are near
    for (int v = 0; v < skin.vertex_count(); ++v) {
        if (held[v]) continue;
        const RowVector3d here = skin.points.row(v);
        const auto tracked = surface.nearest(here.transpose(), Vector3d::Zero(), -1, std::numeric_limits<double>::infinity(), hint);
        hint = tracked.triangle;
        const RowVector3d target = tracked.triangle < 0 || tracked.ignored ? here : RowVector3d(here + weights.move * (tracked.point.transpose() - here)); // Eq 2
        places.row(v) = weights.stay * here + weights.smooth * ring_mean(skin.points, rings, v) + follow * target; // Eq 1
    }
    return places;
}

} // namespace lissom
