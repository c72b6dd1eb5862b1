#include "lissom/match/skin_set.h"

#include "lissom/match/smoothing_rings.h"
#include "lissom/mesh/operators.h"
#include "lissom/mesh/topology.h"

#include "skin_editor.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lissom {

using Eigen::RowVector3d;

namespace {

constexpr double k_long = 1.5, k_short = 0.5; // of L: Criteria 1 and 2
constexpr double k_least_factor = 1.0 / 3, k_most_factor = 2;
constexpr int k_curvature_smoothings = 2;

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

std::vector<double> length_factors(const SkinSet& skins) {
    const int n = skins.vertex_count();
    if (n == 0 || skins.count() == 0) return {};
    const VertexRings rings = vertex_rings(skins.mesh(0));
    Eigen::VectorXd curvature = Eigen::VectorXd::Zero(n), areas = Eigen::VectorXd::Zero(n);
    for (int k = 0; k < skins.count(); ++k) {
        const TriangleMesh mesh = skins.mesh(k);
        const Points normals = vertex_normals(mesh);
        areas += vertex_areas(mesh);
        for (int v = 0; v < n; ++v) {
            double turned = 0, length = 0;
            for (const int w : rings[v]) {
                turned += (normals.row(w) - normals.row(v)).squaredNorm();
                length += (mesh.points.row(w) - mesh.points.row(v)).squaredNorm();
            }
            if (length > 0) curvature[v] = std::max(curvature[v], std::sqrt(turned / length));
        }
    }
    for (int pass = 0; pass < k_curvature_smoothings; ++pass) {
        const Eigen::VectorXd before = curvature;
        for (int v = 0; v < n; ++v)
            for (const int w : rings[v]) curvature[v] += (before[w] - before[v]) / (static_cast<double>(rings[v].size()) + 1);
    }
    const double mean = curvature.dot(areas) / areas.sum();
    std::vector<double> factors;
    for (const double here : curvature) factors.push_back(here > 0 ? std::clamp(std::sqrt(mean / here), k_least_factor, k_most_factor) : mean > 0 ? k_most_factor : 1);
    return factors;
}

ConnectivityChange improve_connectivity(SkinSet& skins, const ConnectivityOptions& options) {
    ConnectivityChange change;
    std::vector<double> lengths(static_cast<std::size_t>(skins.vertex_count()), options.edge_length);
    if (options.adapt > 0) {
        const std::vector<double> factors = length_factors(skins);
        for (std::size_t v = 0; v < factors.size(); ++v) lengths[v] *= std::pow(factors[v], options.adapt);
    }
    SkinEditor editor(skins, std::move(lengths), k_long);
    std::vector<Candidate> candidates;
    const auto gather = [&](auto wanted) {
        candidates.clear();
        for (const auto& [a, b] : editor.edges())
            if (double ratio = 0; wanted(a, b, ratio)) candidates.push_back({ratio, a, b});
    };
    gather([&](int a, int b, double& ratio) { // Criterion 1
        for (int skin = 0; skin < skins.count(); ++skin) ratio = std::max(ratio, editor.ratio(a, b, skin));
        return ratio > k_long;
    });
    keep_worst(candidates, options.share, true);
    for (const Candidate& c : candidates)
        if (editor.vertex_count() < options.most_vertices) change.splits += editor.split(c.a, c.b);

    gather([&](int a, int b, double& ratio) { // Criterion 2
        for (int skin = 0; skin < skins.count(); ++skin) {
            const double here = editor.ratio(a, b, skin);
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
        if (skins.marker[v] >= 0 || (skin == 0 && skins.curves && skins.curves->tied(v))) continue;
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
