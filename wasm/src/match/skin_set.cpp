#include "lissom/match/skin_set.h"

#include "lissom/match/smoothing_rings.h"
#include "lissom/mesh/operators.h"

#include "skin_editor.h"

#include <algorithm>
#include <cmath>

namespace lissom {

using Eigen::RowVector3d;

namespace {

constexpr double k_long = 1.5, k_short = 0.5; // of L: Criteria 1 and 2

struct Candidate {
    double ratio; ///< of its length to L
    int a, b;
};

/// The worst share of them, worst first.
void keep_worst(std::vector<Candidate>& candidates, double share, bool longest) {
    std::sort(candidates.begin(), candidates.end(), [&](const Candidate& p, const Candidate& q) {
        if (p.ratio != q.ratio) return longest ? p.ratio > q.ratio : p.ratio < q.ratio;
        return p.a != q.a ? p.a < q.a : p.b < q.b;
    });
    candidates.resize(static_cast<std::size_t>(std::ceil(share * static_cast<double>(candidates.size()))));
}

} // namespace

ConnectivityChange& ConnectivityChange::operator+=(const ConnectivityChange& more) {
    splits += more.splits;
    collapses += more.collapses;
    swaps += more.swaps;
    return *this;
}

ConnectivityChange improve_connectivity(SkinSet& skins, const ConnectivityOptions& options) {
    ConnectivityChange change;
    const double L = options.edge_length;
    SkinEditor editor(skins, k_long * L);
    std::vector<Candidate> candidates;
    const auto gather = [&](auto wanted) {
        candidates.clear();
        for (const auto& [a, b] : editor.edges())
            if (double ratio = 0; wanted(a, b, ratio)) candidates.push_back({ratio, a, b});
    };
    gather([&](int a, int b, double& ratio) { // Criterion 1
        for (int skin = 0; skin < skins.count(); ++skin) ratio = std::max(ratio, editor.length(a, b, skin) / L);
        return ratio > k_long;
    });
    keep_worst(candidates, options.share, true);
    for (const Candidate& c : candidates)
        if (editor.vertex_count() < options.most_vertices) change.splits += editor.split(c.a, c.b);

    gather([&](int a, int b, double& ratio) { // Criterion 2
        for (int skin = 0; skin < skins.count(); ++skin) {
            const double here = editor.length(a, b, skin) / L;
            if (!(here < k_short)) return false;
            ratio += here;
        }
        return true;
    });
    keep_worst(candidates, options.share, false);
    for (const Candidate& c : candidates)
        if (editor.alive(c.a) && editor.alive(c.b)) change.collapses += editor.collapse(c.a, c.b);

    for (const auto& [a, b] : editor.edges()) change.swaps += editor.swap_if_better(a, b); // Criterion 3
    if (change.any()) skins = editor.take();
    return change;
}

Points relaxed_tangentially(const SkinSet& skins, int skin, double share) {
    const TriangleMesh mesh = skins.mesh(skin);
    const VertexRings rings = smoothing_rings(mesh);
    const std::vector<bool> on_border = boundary_vertices(mesh);
    const Points normals = vertex_normals(mesh);
    Points points = mesh.points;
    for (int v = 0; v < mesh.vertex_count(); ++v) {
        if (skins.marker[v] >= 0) continue;
        RowVector3d move = share * (ring_mean(mesh.points, rings, v) - mesh.points.row(v));
        if (on_border[v]) { // along the border, by its two neighbours there; corners of more stay
            if (rings[v].size() != 2) continue;
            const RowVector3d along = (mesh.points.row(rings[v][1]) - mesh.points.row(rings[v][0])).stableNormalized();
            move = move.dot(along) * along;
        } else move -= move.dot(normals.row(v)) * normals.row(v);
        points.row(v) += move;
    }
    return points;
}

} // namespace lissom
