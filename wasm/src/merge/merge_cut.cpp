// The first half of preparing a merge: what of the two inputs takes part, and along which loops.

#include "merge_state.h"

#include "lissom/merge/opened_target.h"
#include "lissom/merge/refine.h"
#include "lissom/mesh/errors.h"
#include "lissom/mesh/facing.h"
#include "lissom/mesh/operators.h"
#include "lissom/mesh/polyline.h"
#include "lissom/mesh/topology.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lissom {
namespace {

/// Edges of a loop are at most this many times the other loop's mean edge (both against their loop's length).
constexpr double k_coarseness = 2.5;
/// A loop has at least √n/this vertices beside a region of n (Fu 2.5).
constexpr double k_region_share = 4;

void check_range(int v, const WorkingMesh& working, const std::string& name) {
    if (v < 0 || v >= std::ssize(working.working_of_source))
        throw InvalidInput("vertex-out-of-range", "The " + name + " has no vertex " + std::to_string(v) + "; it has " +
                                                      std::to_string(working.working_of_source.size()) + ".");
}

BoundaryLoop in_working(const BoundaryLoop& loop, const WorkingMesh& working, const std::string& name) {
    BoundaryLoop result{named_vertices(loop.vertices, working, name), painted_vertices(loop.keep, working, name)};
    // A file may repeat a vertex where its texture is cut: the same place, named twice in a row.
    auto& v = result.vertices;
    v.erase(std::unique(v.begin(), v.end()), v.end());
    while (v.size() > 1 && v.front() == v.back()) v.pop_back();
    return result;
}

} // namespace

std::vector<int> painted_vertices(std::span<const int> vertices, const WorkingMesh& working, const std::string& name) {
    std::vector<int> result;
    for (const int v : vertices) {
        check_range(v, working, name);
        if (working.working_of_source[v] >= 0) result.push_back(working.working_of_source[v]);
    }
    return result;
}

std::vector<int> named_vertices(const std::vector<int>& vertices, const WorkingMesh& working, const std::string& name) {
    std::vector<int> result;
    for (const int v : vertices) {
        check_range(v, working, name);
        if (working.working_of_source[v] < 0)
            throw InvalidInput("vertex-unused", "Vertex " + std::to_string(v) + " of the " + name + " belongs to no face. Choose another.");
        result.push_back(working.working_of_source[v]);
    }
    return result;
}

void MergeSession::State::cut(std::span<const MergeBoundary> boundaries) {
    if (boundaries.empty()) throw InvalidInput("no-boundary", "There is no pair of boundaries to join. Choose one on each model.");
    std::vector<BoundaryLoop> source_loops, target_loops;
    for (const MergeBoundary& boundary : boundaries) {
        source_loops.push_back(in_working(boundary.source, source, "source"));
        target_loops.push_back(in_working(boundary.target, target, "target"));
    }
    source_part = cut_part(source.mesh, source_loops, "source");
    target_part = cut_part(target.mesh, target_loops, "target");
    if (options.transition) cut_transitions();
}

void MergeSession::State::cut_transitions() {
    const Transition& transition = *options.transition;
    if (!(transition.source_width > 0) || !(transition.target_width > 0) || !(transition.weight >= 0))
        throw InvalidInput("bad-option", "The widths of the transition must be above 0, and its weight not below 0.");
    for (int k = 0; k < std::ssize(source_part.loops); ++k) {
        Part rest;
        source_strips.push_back(cut_strip(source_part, k, transition.source_width / source.scale, "source", rest));
        target_strips.push_back(cut_strip(target_part, k, transition.target_width / target.scale, "target", rest));
        target_part = std::move(rest);
    }
    std::vector<char> taken(source_part.origin.size(), 0);
    for (const std::vector<int>& loop : source_part.loops)
        for (const int v : loop) taken[v] = 1;
    for (int k = 0; k < std::ssize(source_strips); ++k)
        for (int v = 0; v < std::ssize(source_strips[k].part_vertex); ++v)
            if (const int p = source_strips[k].part_vertex[v]; p >= 0 && !std::exchange(taken[p], 1)) blended.emplace_back(k, v);

    target_curvature = (cotangent_laplacian(target.mesh) * target.mesh.points).array().colwise() / vertex_areas(target.mesh).array();
    // The Laplacian of a vertex on an opening sees one side only: its neighbours' inside stand in for it.
    const std::vector<bool> open = boundary_vertices(target.mesh);
    const VertexRings rings = vertex_rings(target.mesh);
    for (int v = 0; v < target.mesh.vertex_count(); ++v) {
        if (!open[v]) continue;
        int count = 0;
        Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
        for (const int n : rings[v])
            if (!open[n]) {
                sum += target_curvature.row(n);
                ++count;
            }
        target_curvature.row(v) = count > 0 ? Eigen::RowVector3d(sum / count) : Eigen::RowVector3d(Eigen::RowVector3d::Zero());
    }
}

void MergeSession::State::find_boundary(const PaintedRegions& regions) {
    const std::vector<int> feature = painted_vertices(regions.feature, source, "source");
    // Maps keep what they see from outside, so a source that faces inward is mapped turned over.
    TriangleMesh facing_out = source.mesh;
    if (facing(source.mesh) * facing(target.mesh) < 0) facing_out.triangles.col(1).swap(facing_out.triangles.col(2));
    const RegionMaps maps = map_regions(facing_out, painted_vertices(regions.source_region, source, "source"), feature, target.mesh,
                                        painted_vertices(regions.target_region, target, "target"));
    placement = regions.placement ? *regions.placement : best_placement(maps);
    const OptimalBoundary found = optimal_boundary(maps, *placement, regions.rounds);
    energies = found.energies;
    source_part = cut_part(source.mesh, std::vector<BoundaryLoop>{{found.loop, feature}}, "source");
    target_part = open_target(target.mesh, maps, found.outline, found.places);
    is_matched = true;
}

void MergeSession::State::refine() {
    int added = 0;
    const double region = std::sqrt(static_cast<double>(source_part.mesh.vertex_count())) / k_region_share;
    for (int k = 0; k < std::ssize(source_part.loops); ++k) {
        const auto sources = static_cast<double>(source_part.loops[k].size()), targets = static_cast<double>(target_part.loops[k].size());
        const double length = loop_length(source_part.mesh.points, source_part.loops[k]);
        added += refine_loop(source_part, k, length * std::min(k_coarseness / targets, 2 / region));
        added += refine_loop(target_part, k, loop_length(target_part.mesh.points, target_part.loops[k]) * k_coarseness / sources);
    }
    if (added > 0) warnings.push_back({"boundary-refined", added, {}, true});
}

} // namespace lissom
