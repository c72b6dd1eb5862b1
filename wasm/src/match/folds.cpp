#include "lissom/match/folds.h"

#include "lissom/match/fit_surface.h"
#include "lissom/match/smoothing_rings.h"
#include "lissom/mesh/half_edges.h"

#include <algorithm>
#include <utility>

namespace lissom {

namespace {

constexpr int k_rounds_a_ring = 4, k_smoothings = 3;
constexpr double k_smoothing = 0.6;
/// How much of what is left of a vertex's step it keeps, round by round.
constexpr double k_kept[] = {0.5, 0.5, 0.25, 0.25, 0};
constexpr int k_guard_rounds = 12, k_guard_rounds_a_ring = 3;
/// Where triangles turn over: cosine of their normals before and after.
constexpr double k_turned_over = 0;

constexpr auto k_neighbours = IntersectionFinder::Neighbours::looked_at;

using Flags = std::vector<char>;

void grow(Flags& flags, const Triangles& triangles) {
    Flags grown = flags;
    for (int t = 0; t < triangles.rows(); ++t)
        for (const int v : triangles.row(t))
            if (flags[v]) {
                for (const int w : triangles.row(t)) grown[w] = 1;
                break;
            }
    flags.swap(grown);
}

Flags corners_of(const std::vector<int>& list, const Triangles& triangles, int vertices) {
    Flags flags(static_cast<std::size_t>(vertices), 0);
    for (const int t : list)
        for (const int v : triangles.row(t)) flags[v] = 1;
    return flags;
}

void tidy(std::vector<int>& list) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
}

} // namespace

TrianglePairs neighbouring_triangles(const TriangleMesh& mesh) {
    TrianglePairs pairs;
    for_each_edge(half_edges(mesh), [&](auto first, auto last) {
        if (last - first == 2 && first->forward != (first + 1)->forward) pairs.emplace_back(first->triangle, (first + 1)->triangle);
    });
    return pairs;
}

int count_folds(const TriangleMesh& mesh, const TrianglePairs& pairs, double least) {
    const Points normals = triangle_normals(mesh);
    return static_cast<int>(std::count_if(pairs.begin(), pairs.end(), [&](const auto& pair) { return normals.row(pair.first).dot(normals.row(pair.second)) < least; }));
}

Tangle tangle_of(const TriangleMesh& mesh, const TrianglePairs& pairs, IntersectionFinder& finder) {
    const SelfIntersections met = finder.find(mesh.points);
    Tangle tangle{static_cast<int>(met.triangles.size()), met.triangles};
    const Points normals = triangle_normals(mesh);
    for (const auto& [s, t] : pairs)
        if (normals.row(s).dot(normals.row(t)) < k_sharp_fold) tangle.triangles.insert(tangle.triangles.end(), {s, t});
    tidy(tangle.triangles);
    return tangle;
}

Tangle untangle(TriangleMesh& mesh, const std::vector<char>& locked, int rounds) {
    const TrianglePairs pairs = neighbouring_triangles(mesh);
    IntersectionFinder finder(mesh, k_neighbours);
    Tangle tangle = tangle_of(mesh, pairs, finder);
    if (tangle.triangles.empty()) return tangle;
    const VertexRings rings = smoothing_rings(mesh);
    for (int round = 0; round < rounds && !tangle.triangles.empty(); ++round) {
        Flags moving = corners_of(tangle.triangles, mesh.triangles, mesh.vertex_count());
        for (int ring = 0; ring <= round / k_rounds_a_ring; ++ring) grow(moving, mesh.triangles);
        for (int k = 0; k < k_smoothings; ++k) {
            const Points before = mesh.points;
            for (int v = 0; v < mesh.vertex_count(); ++v)
                if (moving[v] && !locked[v]) mesh.points.row(v) += k_smoothing * (ring_mean(before, rings, v) - before.row(v));
        }
        tangle = tangle_of(mesh, pairs, finder);
    }
    return tangle;
}

GuardedStep::GuardedStep(const TriangleMesh& mesh)
    : pairs_(neighbouring_triangles(mesh)), finder_(mesh, k_neighbours), around_(static_cast<std::size_t>(mesh.vertex_count())) {
    for (int t = 0; t < mesh.triangle_count(); ++t)
        for (const int v : mesh.triangles.row(t)) around_[v].push_back(t);
}

GuardedStep::Taken GuardedStep::take(TriangleMesh& mesh, const Points& moves) {
    const Points from = mesh.points, normals_before = triangle_normals(mesh);
    const int n = mesh.vertex_count();
    Flags tangled_before(static_cast<std::size_t>(mesh.triangle_count()), 0);
    if (from.rows() != last_.rows() || from != last_) met_ = finder_.find(from); // else as the last step left it
    for (const int t : met_.triangles) tangled_before[t] = 1;
    const auto folded = [](const Points& normals, const std::pair<int, int>& pair) { return normals.row(pair.first).dot(normals.row(pair.second)) < k_sharp_fold; };

    Eigen::VectorXd share = Eigen::VectorXd::Ones(n);
    std::vector<int> changed; // triangles to be looked at again; all of them in the first round
    Taken taken;
    for (int round = 0;; ++round) {
        mesh.points = from + share.asDiagonal() * moves;
        SelfIntersections met = round == 0 ? finder_.find(mesh.points) : finder_.find(mesh.points, changed);
        std::vector<int> harmed;
        for (const int t : met.triangles)
            if (!tangled_before[t]) harmed.push_back(t);
        const Points normals = triangle_normals(mesh);
        for (int t = 0; t < mesh.triangle_count(); ++t)
            if (normals.row(t).dot(normals_before.row(t)) < k_turned_over) harmed.push_back(t);
        for (const auto& pair : pairs_)
            if (folded(normals, pair) && !folded(normals_before, pair)) harmed.insert(harmed.end(), {pair.first, pair.second});
        if (harmed.empty()) {
            met_ = round == 0 ? std::move(met) : finder_.find(mesh.points);
            break;
        }
        if (round == k_guard_rounds) {
            mesh.points = from;
            taken.refused = true;
            break;
        }
        tidy(harmed);
        Flags slower = corners_of(harmed, mesh.triangles, n);
        for (int ring = 0; ring < round / k_guard_rounds_a_ring; ++ring) grow(slower, mesh.triangles);
        const double kept = k_kept[std::min<std::size_t>(static_cast<std::size_t>(round), std::size(k_kept) - 1)];
        changed.clear();
        for (int v = 0; v < n; ++v)
            if (slower[v] && share[v] > 0) {
                share[v] *= kept;
                changed.insert(changed.end(), around_[v].begin(), around_[v].end());
            }
        tidy(changed);
        // What still meets although it cannot go any slower must be looked at again, too.
        changed.insert(changed.end(), harmed.begin(), harmed.end());
        tidy(changed);
    }
    taken.shortened = static_cast<int>((share.array() < 1).count());
    taken.crossings = static_cast<int>(met_.triangles.size());
    last_ = mesh.points;
    return taken;
}

} // namespace lissom
