#include "lissom/curve/propose.h"

#include "lissom/curve/region.h"
#include "lissom/curve/spline.h"
#include "lissom/mesh/disjoint_sets.h"
#include "lissom/mesh/errors.h"
#include "lissom/mesh/operators.h"
#include "lissom/mesh/polyline.h"
#include "lissom/mesh/surface_paths.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>
#include <utility>

namespace lissom {

using Eigen::Vector3d;

namespace {

constexpr int k_bands = 80;          // along the longest way
constexpr double k_shortest = 2;     // limbs are kept from this many radii of their own, and from half as many of what they grow from
constexpr double k_slender = 5;      // some limb must be so many times longer than its radius: a ball's 3, a cube's 4
constexpr int k_smoothing = 4;       // sweeps over the centres of rings

/// One ring: a connected part of a band.
struct Ring {
    Vector3d centre = Vector3d::Zero();
    double radius = 0; ///< mean distance of its vertices from its centre
    int vertices = 0;
    std::set<int> beside; ///< rings next to it
};

/// A chain of rings; its ends are rings where it branches or ends.
struct Limb {
    std::vector<int> rings;
    double length = 0, radius = 0;
};

/// Distance of every vertex from a far tip of its piece.
std::vector<double> far_distances(const TriangleMesh& mesh, const VertexRings& rings) {
    const WeightedGraph graph = edge_graph(mesh);
    const Components pieces = components(rings);
    std::vector<int> first(static_cast<std::size_t>(pieces.count), -1);
    for (int v = 0; v < mesh.vertex_count(); ++v)
        if (first[pieces.of_vertex[v]] < 0) first[pieces.of_vertex[v]] = v;
    const std::vector<double> rough = shortest_paths(graph, first).distance;
    std::vector<int> tips = first;
    for (int v = 0; v < mesh.vertex_count(); ++v)
        if (int& tip = tips[pieces.of_vertex[v]]; rough[v] > rough[tip]) tip = v;
    return shortest_paths(graph, tips).distance;
}

std::vector<Ring> rings_of(const TriangleMesh& mesh, const VertexRings& neighbours) {
    const std::vector<double> distance = far_distances(mesh, neighbours);
    const double longest = *std::max_element(distance.begin(), distance.end());
    const double width = std::max(longest / k_bands, 2 * mean_edge_length(mesh));
    const auto band = [&](int v) { return static_cast<int>(distance[v] / width); };
    DisjointSets sets(mesh.vertex_count());
    for (int v = 0; v < mesh.vertex_count(); ++v)
        for (const int w : neighbours[v])
            if (w < v && band(v) == band(w)) sets.join(v, w);
    std::vector<int> ring_of(static_cast<std::size_t>(mesh.vertex_count()), -1);
    std::vector<Ring> rings;
    for (int v = 0; v < mesh.vertex_count(); ++v) {
        int& ring = ring_of[sets.find(v)];
        if (ring < 0) {
            ring = static_cast<int>(rings.size());
            rings.emplace_back();
        }
        ring_of[v] = ring;
        rings[ring].centre += mesh.points.row(v).transpose();
        ++rings[ring].vertices;
    }
    for (Ring& ring : rings) ring.centre /= ring.vertices;
    for (int v = 0; v < mesh.vertex_count(); ++v) {
        Ring& ring = rings[ring_of[v]];
        ring.radius += (mesh.points.row(v).transpose() - ring.centre).norm() / ring.vertices;
        for (const int w : neighbours[v])
            if (ring_of[w] != ring_of[v]) ring.beside.insert(ring_of[w]);
    }
    return rings;
}

/// The unbranched chains of the graph, each with the rings it ends on.
std::vector<Limb> limbs_of(const std::vector<Ring>& rings) {
    std::vector<Limb> limbs;
    std::set<std::pair<int, int>> walked;
    const auto walk = [&](int from, int to) {
        Limb limb{.rings = {from, to}};
        walked.insert({from, to});
        while (rings[limb.rings.back()].beside.size() == 2) {
            const int last = limb.rings.back(), before = limb.rings[limb.rings.size() - 2];
            const int next = *rings[last].beside.begin() == before ? *rings[last].beside.rbegin() : *rings[last].beside.begin();
            walked.insert({last, next});
            limb.rings.push_back(next);
            if (next == from) break; // a closed loop
        }
        walked.insert({limb.rings.back(), limb.rings[limb.rings.size() - 2]});
        double radius = 0;
        for (std::size_t i = 0; i < limb.rings.size(); ++i) {
            if (i > 0) limb.length += (rings[limb.rings[i]].centre - rings[limb.rings[i - 1]].centre).norm();
            radius += rings[limb.rings[i]].radius;
        }
        limb.radius = radius / static_cast<double>(limb.rings.size());
        limbs.push_back(std::move(limb));
    };
    for (int r = 0; r < static_cast<int>(rings.size()); ++r)
        if (rings[r].beside.size() != 2)
            for (const int next : rings[r].beside)
                if (!walked.contains({r, next})) walk(r, next);
    for (int r = 0; r < static_cast<int>(rings.size()); ++r) // loops without a branch
        if (rings[r].beside.size() == 2)
            if (const int next = *rings[r].beside.begin(); !walked.contains({r, next}) && !walked.contains({next, r})) walk(r, next);
    return limbs;
}

/// Drops short limbs that end freely, the shortest first, one at a time: what is left may grow together.
void prune(std::vector<Ring>& rings) {
    for (;;) {
        const std::vector<Limb> limbs = limbs_of(rings);
        const Limb* worst = nullptr;
        double least = k_shortest;
        for (const Limb& limb : limbs) {
            const int a = limb.rings.front(), b = limb.rings.back();
            const bool free_a = rings[a].beside.size() == 1, free_b = rings[b].beside.size() == 1;
            if (free_a == free_b) continue;
            const double ratio = limb.length / std::max({limb.radius, rings[free_a ? b : a].radius / 2, 1e-12});
            if (ratio < least) {
                least = ratio;
                worst = &limb;
            }
        }
        if (!worst) return;
        const bool free_front = rings[worst->rings.front()].beside.size() == 1;
        std::vector<int> chain = worst->rings;
        if (!free_front) std::reverse(chain.begin(), chain.end());
        for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
            rings[chain[i]].beside.clear();
            rings[chain[i + 1]].beside.erase(chain[i]);
        }
    }
}

/// Control points of a limb: the centres of its rings, smoothed, from where it leaves its parent's thickness.
Points controls_of(const std::vector<Ring>& rings, const std::vector<int>& chain, bool is_child) {
    Polyline line;
    for (const int r : chain) line.push_back(rings[r].centre);
    for (int sweep = 0; sweep < k_smoothing; ++sweep) {
        const Polyline before = line;
        for (std::size_t i = 1; i + 1 < line.size(); ++i) line[i] = (before[i - 1] + 2 * before[i] + before[i + 1]) / 4;
    }
    if (is_child) {
        std::size_t skip = 0;
        const double thick = rings[chain.front()].radius;
        while (skip + 4 < line.size() && (line[skip] - line.front()).norm() < thick && rings[chain[skip + 1]].radius < thick) ++skip;
        line.erase(line.begin(), line.begin() + static_cast<std::ptrdiff_t>(skip));
    }
    double length = 0, radius = 0;
    for (std::size_t i = 0; i < line.size(); ++i) {
        length += i > 0 ? (line[i] - line[i - 1]).norm() : 0;
        radius += rings[chain[chain.size() - line.size() + i]].radius / static_cast<double>(line.size());
    }
    // A control point every three radii, four to twelve of them.
    const int count = std::clamp(static_cast<int>(std::lround(length / (3 * std::max(radius, 1e-12)))) + 1, 4, 12);
    const Polyline even = resampled(line, length / (count - 1));
    Points controls(std::ssize(even), 3);
    for (std::size_t i = 0; i < even.size(); ++i) controls.row(static_cast<Eigen::Index>(i)) = even[i].transpose();
    return controls;
}

} // namespace

ProposedSkeleton propose_curves(const CurveSurface& surface) {
    std::vector<Ring> rings = rings_of(surface.mesh(), surface.rings());
    prune(rings);
    std::vector<Limb> limbs;
    for (Limb& limb : limbs_of(rings))
        if (limb.rings.size() >= 4) limbs.push_back(std::move(limb));
    if (std::none_of(limbs.begin(), limbs.end(), [](const Limb& limb) { return limb.length > k_slender * limb.radius; }))
        throw InvalidInput("no-limbs", "No part of the model is longer than it is thick, so there is nothing to propose. Draw a curve yourself.");
    std::stable_sort(limbs.begin(), limbs.end(), [](const Limb& a, const Limb& b) { return a.radius > b.radius; });

    ProposedSkeleton skeleton;
    const auto add = [&](const std::vector<int>& chain, bool is_child) {
        ProposedCurve curve{.controls = controls_of(rings, chain, is_child), .radius = {}};
        for (Eigen::Index i = 0; i < curve.controls.rows(); ++i)
            curve.controls.row(i) = surface.working().to_source(Vector3d(curve.controls.row(i))).transpose();
        curve.radius = curve_radius(surface, SplineCurve(curve.controls));
        skeleton.curves.push_back(std::move(curve));
        return static_cast<int>(skeleton.curves.size()) - 1;
    };
    // From each root outwards: what meets at a limb's end and is not taken yet becomes its child.
    std::vector<char> taken(limbs.size(), 0);
    for (std::size_t root = 0; root < limbs.size(); ++root) {
        if (taken[root]) continue;
        taken[root] = 1;
        struct End {
            int ring, curve;
            double at;
        };
        const int first = add(limbs[root].rings, false);
        std::vector<End> open{{limbs[root].rings.front(), first, 0}, {limbs[root].rings.back(), first, 1}};
        for (std::size_t i = 0; i < open.size(); ++i)
            for (std::size_t l = 0; l < limbs.size(); ++l) {
                const End end = open[i];
                if (taken[l] || (limbs[l].rings.front() != end.ring && limbs[l].rings.back() != end.ring)) continue;
                taken[l] = 1;
                std::vector<int> chain = limbs[l].rings;
                if (chain.front() != end.ring) std::reverse(chain.begin(), chain.end());
                const int child = add(chain, true);
                skeleton.links.push_back({child, end.curve, end.at});
                open.push_back({chain.back(), child, 1});
            }
    }
    return skeleton;
}

} // namespace lissom
