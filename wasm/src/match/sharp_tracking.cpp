#include "lissom/match/sharp_tracking.h"

#include "lissom/match/smoothing_rings.h"
#include "lissom/mesh/operators.h"

#include <algorithm>

namespace lissom {

using Eigen::RowVector3d;

namespace {

constexpr double k_mean = 0.4; // of the ring, in where a vertex looks for its place
constexpr int k_fading = 8;    // sweeps by which moves of paths fade into the strip

} // namespace

SharpTracking::SharpTracking(const TriangleMesh& skin, const FitSurface& surface, const std::vector<Anchor>& held, const std::vector<char>& locked, const Options& options)
    : surface_(surface), held_(held), options_(options), rings_(vertex_rings(skin)), guard_(skin) {
    const std::vector<bool> border = boundary_vertices(skin);
    std::vector<char> seen(static_cast<std::size_t>(skin.vertex_count()), 0);
    std::vector<int> front;
    for (const Anchor& anchor : held_) {
        seen[anchor.vertex] = 1;
        front.push_back(anchor.vertex);
    }
    for (int ring = 0; ring < options_.strip; ++ring) {
        std::vector<int> next;
        for (const int v : front)
            for (const int w : rings_[v])
                if (!seen[w]) {
                    seen[w] = 1;
                    next.push_back(w);
                }
        for (const int v : next)
            if (!locked[v] && !border[v]) strip_.push_back(v);
        front = std::move(next);
    }
    std::sort(strip_.begin(), strip_.end());
}

void SharpTracking::approach(const Points& points, Points& moves) const {
    const double part = 1.0 / std::max(1, options_.approach - pass_);
    for (const Anchor& anchor : held_) moves.row(anchor.vertex) = part * (anchor.place.transpose() - points.row(anchor.vertex));
    for (int sweep = 0; sweep < k_fading; ++sweep) {
        const Points before = moves;
        for (const int v : strip_) moves.row(v) = ring_mean(before, rings_, v);
    }
}

void SharpTracking::settle(const TriangleMesh& skin, Points& moves) const {
    for (const Anchor& anchor : held_) moves.row(anchor.vertex) = anchor.place.transpose() - skin.points.row(anchor.vertex);
    const Points normals = vertex_normals(skin);
    for (const int v : strip_) {
        const RowVector3d p = skin.points.row(v), q = (1 - k_mean) * p + k_mean * ring_mean(skin.points, rings_, v);
        const auto place = surface_.nearest(q.transpose(), normals.row(v).transpose(), options_.least_cosine, options_.reach);
        if (place.triangle >= 0 && !place.on_border) moves.row(v) = place.point.transpose() - p;
    }
}

bool SharpTracking::step(TriangleMesh& skin) {
    if (pass_ >= passes()) return false;
    Points moves = Points::Zero(skin.points.rows(), 3);
    if (pass_ < options_.approach) approach(skin.points, moves);
    else settle(skin, moves);
    guard_.take(skin, moves);
    return ++pass_ < passes();
}

double SharpTracking::farthest(const Points& skin) const {
    double most = 0;
    for (const Anchor& anchor : held_) most = std::max(most, (skin.row(anchor.vertex) - anchor.place.transpose()).norm());
    return most;
}

} // namespace lissom
