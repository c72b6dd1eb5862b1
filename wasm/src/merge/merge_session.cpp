#include "lissom/merge/merge_session.h"

#include "lissom/deform/deform_session.h"
#include "lissom/merge/boundary_correspondence.h"
#include "lissom/merge/facing.h"
#include "lissom/merge/loop_frames.h"
#include "lissom/merge/opened_target.h"
#include "lissom/merge/refine.h"
#include "lissom/merge/similarity.h"
#include "lissom/merge/transition.h"
#include "lissom/mesh/errors.h"
#include "lissom/mesh/operators.h"
#include "lissom/mesh/topology.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <set>
#include <string>

namespace lissom {
namespace {

using Eigen::Affine3d;
using Eigen::Vector3d;

/// Edges of a loop are at most this many times the other loop's mean edge (both against their loop's length).
constexpr double k_coarseness = 2.5;
/// A loop has at least √n/this vertices beside a region of n (Fu 2.5).
constexpr double k_region_share = 4;

class Seconds {
public:
    double lap() {
        const auto now = std::chrono::steady_clock::now();
        return std::chrono::duration<double>(now - std::exchange(last_, now)).count();
    }

private:
    std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

/// File vertices to working vertices; each once.
std::vector<int> to_working(const std::vector<int>& vertices, const WorkingMesh& working, const std::string& name) {
    std::vector<int> result;
    for (const int v : vertices) {
        if (v < 0 || v >= std::ssize(working.working_of_source))
            throw InvalidInput("vertex-out-of-range", "The " + name + " has no vertex " + std::to_string(v) + "; it has " +
                                                          std::to_string(working.working_of_source.size()) + ".");
        if (working.working_of_source[v] < 0)
            throw InvalidInput("vertex-unused", "Vertex " + std::to_string(v) + " of the " + name + " belongs to no face. Choose another.");
        result.push_back(working.working_of_source[v]);
    }
    return result;
}

BoundaryLoop to_working(const BoundaryLoop& loop, const WorkingMesh& working, const std::string& name) {
    BoundaryLoop result{to_working(loop.vertices, working, name), {}};
    // A file may repeat a vertex where its texture is cut: the same place, named twice in a row.
    auto& v = result.vertices;
    v.erase(std::unique(v.begin(), v.end()), v.end());
    while (v.size() > 1 && v.front() == v.back()) v.pop_back();
    for (const int k : loop.keep)
        if (k >= 0 && k < std::ssize(working.working_of_source) && working.working_of_source[k] >= 0) result.keep.push_back(working.working_of_source[k]);
    return result;
}

std::vector<int> inverse(const Part& part, int working_vertices) {
    std::vector<int> place(static_cast<std::size_t>(working_vertices), -1);
    for (int v = 0; v < std::ssize(part.origin); ++v)
        if (part.origin[v].is_vertex()) place[part.origin[v].vertex[0]] = v;
    return place;
}

/// The pose that a loop's own shape decides: its middle at the origin, its first vertex along x, its area's normal near z,
/// its length 1.
Affine3d canonical_pose(const Points& points, const std::vector<int>& loop) {
    Points ring(std::ssize(loop), 3);
    for (std::size_t i = 0; i < loop.size(); ++i) ring.row(static_cast<Eigen::Index>(i)) = points.row(loop[i]);
    const Eigen::RowVector3d middle = ring.colwise().mean();
    ring.rowwise() -= middle;
    const double length = loop_length(points, loop);
    const double size = length > 0 ? length : 1;
    Vector3d area = Vector3d::Zero();
    for (Eigen::Index i = 0; i < ring.rows(); ++i) area += Vector3d(ring.row(i)).cross(Vector3d(ring.row((i + 1) % ring.rows())));
    Eigen::Index farthest = 0; // the first vertex, unless it stands in the middle
    if (!(ring.row(0).norm() > 1e-3 * size)) ring.rowwise().norm().maxCoeff(&farthest);
    Vector3d x = ring.row(farthest).transpose();
    Vector3d z = area;
    if (!(area.norm() > 1e-6 * size * size)) z = Vector3d(ring.row((farthest + ring.rows() / 3) % ring.rows())).cross(x);
    Affine3d pose = Affine3d::Identity();
    if (x.norm() > 0 && z.norm() > 0) {
        z.normalize();
        x -= x.dot(z) * z;
        if (x.norm() > 0) {
            x.normalize();
            Eigen::Matrix3d frame;
            frame.row(0) = x.transpose();
            frame.row(1) = z.cross(x).transpose();
            frame.row(2) = z.transpose();
            pose.linear() = frame / size;
        }
    }
    pose.translation() = -pose.linear() * middle.transpose();
    return pose;
}

Points images(const Affine3d& map, const Points& points) {
    return (points * map.linear().transpose()).rowwise() + map.translation().transpose();
}

WorkingMesh as_working(const TriangleMesh& mesh) {
    PolygonMesh polygons{mesh.points, {0}, {}};
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        for (int c = 0; c < 3; ++c) polygons.corners.push_back(mesh.triangles(t, c));
        polygons.offsets.push_back(3 * (t + 1));
    }
    return make_working_mesh(polygons);
}

} // namespace

struct MergeSession::State {
    const WorkingMesh& source;
    const WorkingMesh& target;
    MergeOptions options;
    Part source_part{}, target_part{};
    std::vector<int> source_place{}, target_place{}; ///< part vertex of each working vertex; −1: cut off
    Points source_normals{}, target_normals{};
    bool looks_turned = false; ///< source and target face opposite ways, as far as their volumes tell
    std::unique_ptr<WorkingMesh> posed{}; ///< the source part, in the pose that is solved in
    std::optional<DeformSession> deform{};
    std::vector<std::pair<int, int>> first_handle{}; ///< of each loop: handles of its vertices, one each
    std::vector<MergeHandle> fixed{};
    std::vector<int> loose{}; ///< part vertices of pieces that nothing holds
    std::vector<Strip> source_strips{}, target_strips{}; ///< of each loop, where there are transitions
    std::vector<std::pair<int, int>> blended{};          ///< loop and strip vertex of each blended vertex
    Points target_curvature{};                           ///< per target working vertex, the curvature normal
    std::vector<Finding> warnings{};
    double prepare_seconds = 0;
    std::vector<double> energies{};
    std::optional<Placement> placement{};
    bool is_matched = false; ///< the loops' vertices are partners one by one, in order from the first

    void cut(std::span<const MergeBoundary> boundaries);
    void find_boundary(const PaintedRegions& regions);
    void cut_transitions();
    void refine();
    void prepare(std::span<const int> roi, std::span<const MergeHandle> handles);
    [[nodiscard]] std::vector<LoopMatch> match(std::span<const MergeKeys> keys, bool turned, std::vector<MergeKeys>& used, std::vector<Finding>& found) const;
    [[nodiscard]] LoopMatch match_beyond_strip(std::size_t k, const std::vector<int>& loop, MergeKeys& keys) const;
    [[nodiscard]] Points details(std::span<const MergeKeys> keys, bool turned, double scale) const;
    [[nodiscard]] Points deform_source(const std::vector<LoopMatch>& matches, std::span<const MergeKeys> keys, bool turned, bool settle, double& seconds) const;
};

void MergeSession::State::cut(std::span<const MergeBoundary> boundaries) {
    if (boundaries.empty()) throw InvalidInput("no-boundary", "There is no pair of boundaries to join. Choose one on each model.");
    std::vector<BoundaryLoop> source_loops, target_loops;
    for (const MergeBoundary& boundary : boundaries) {
        source_loops.push_back(to_working(boundary.source, source, "source"));
        target_loops.push_back(to_working(boundary.target, target, "target"));
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
    const std::vector<int> feature = to_working(regions.feature, source, "source");
    // Maps keep what they see from outside, so a source that faces inward is mapped turned over.
    TriangleMesh facing_out = source.mesh;
    if (facing(source.mesh) * facing(target.mesh) < 0) facing_out.triangles.col(1).swap(facing_out.triangles.col(2));
    const RegionMaps maps = map_regions(facing_out, to_working(regions.source_region, source, "source"), feature, target.mesh,
                                        to_working(regions.target_region, target, "target"));
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

void MergeSession::State::prepare(std::span<const int> roi, std::span<const MergeHandle> handles) {
    const bool independent = options.mode == MergeMode::independent;
    source_place = inverse(source_part, source.mesh.vertex_count());
    target_place = inverse(target_part, target.mesh.vertex_count());
    if (independent) {
        source_part.mesh.points = images(canonical_pose(source_part.mesh.points, source_part.loops.front()), source_part.mesh.points);
    } else {
        for (int v = 0; v < source_part.mesh.vertex_count(); ++v)
            source_part.mesh.points.row(v) =
                target.to_working(Vector3d(options.placement * source.to_source(source_part.mesh.points.row(v).transpose()))).transpose();
    }
    source_normals = vertex_normals(source_part.mesh);
    target_normals = vertex_normals(target_part.mesh);
    looks_turned = facing(source.mesh) * facing(target.mesh) < 0;

    posed = std::make_unique<WorkingMesh>(as_working(source_part.mesh));
    std::vector<DeformHandle> held;
    std::set<int> taken;
    for (const std::vector<int>& loop : source_part.loops)
        for (const int v : loop) {
            held.push_back({false, {v}});
            taken.insert(v);
        }
    if (!independent)
        for (const MergeHandle& handle : handles) {
            DeformHandle group;
            for (const int w : to_working(handle.vertices, source, "source"))
                if (const int v = source_place[w]; v >= 0 && taken.insert(v).second) group.vertices.push_back(v);
            if (group.vertices.empty()) continue;
            held.push_back(std::move(group));
            fixed.push_back(handle);
        }
    std::vector<int> movable;
    if (independent || roi.empty()) {
        for (int v = 0; v < source_part.mesh.vertex_count(); ++v) movable.push_back(v);
    } else {
        std::vector<char> inside(static_cast<std::size_t>(source.mesh.vertex_count()), 0);
        for (const int w : to_working({roi.begin(), roi.end()}, source, "source")) inside[w] = 1;
        for (int v = 0; v < source_part.mesh.vertex_count(); ++v)
            if (const Origin& o = source_part.origin[v]; inside[o.vertex[0]] && inside[o.vertex[1]] && inside[o.vertex[2]]) movable.push_back(v);
    }
    DeformOptions solving{.remove_shear = true, .scale_details = true, .coherence_ring = options.coherence_ring};
    if (options.transition) {
        solving.blend_weight = options.transition->weight;
        for (const auto& [k, v] : blended) // 1 at the seam, where the target's detail continues, 0 at the far edge
            solving.blended.push_back({source_strips[k].part_vertex[v],
                                       std::clamp(1 - source_strips[k].distance[v] * source.scale / options.transition->source_width, 0.0, 1.0)});
    }
    deform.emplace(*posed, movable, held, std::move(solving));
    for (const Finding& w : deform->warnings())
        if (w.code == "nothing-free") warnings.push_back(w);

    if (!independent) return;
    const Components pieces = components(vertex_rings(source_part.mesh));
    std::set<int> reached;
    for (const std::vector<int>& loop : source_part.loops) reached.insert(pieces.of_vertex[loop.front()]);
    for (int v = 0; v < source_part.mesh.vertex_count(); ++v)
        if (!reached.contains(pieces.of_vertex[v])) loose.push_back(v);
    if (!loose.empty()) warnings.push_back({"piece-without-boundary", pieces.count - static_cast<int>(reached.size()), {}, true});
}

std::vector<LoopMatch> MergeSession::State::match(std::span<const MergeKeys> keys, bool turned, std::vector<MergeKeys>& used,
                                                  std::vector<Finding>& found) const {
    std::vector<LoopMatch> matches;
    for (std::size_t k = 0; k < source_part.loops.size(); ++k) {
        std::vector<int> loop = source_part.loops[k];
        if (turned) std::reverse(loop.begin() + 1, loop.end());
        if (is_matched) {
            matches.push_back(match_one_by_one(loop, target_part.loops[k]));
            used.emplace_back();
            continue;
        }
        MergeKeys local;
        used.push_back(keys[k]);
        if (!target_strips.empty()) {
            matches.push_back(match_beyond_strip(k, loop, used.back()));
            if (keys[k].empty()) found.push_back({"key-found", 1, {static_cast<int>(k)}, true});
            continue;
        }
        for (const auto& [s, t] : keys[k]) {
            const int a = source_place[to_working({s}, source, "source").front()], b = target_place[to_working({t}, target, "target").front()];
            local.emplace_back(a, b);
            if (a < 0 || b < 0)
                throw InvalidInput("key-not-on-boundary", "Key (" + std::to_string(s) + ", " + std::to_string(t) + ") is not on the boundaries. Place it on both.");
        }
        if (local.empty()) {
            local.push_back(best_key(source_part.mesh.points, loop, target_part.mesh.points, target_part.loops[k]));
            const Origin &s = source_part.origin[local[0].first], &t = target_part.origin[local[0].second];
            used.back().emplace_back(source.source_of_working[s.vertex[0]], target.source_of_working[t.vertex[0]]);
            found.push_back({"key-found", 1, {static_cast<int>(k)}, true});
        }
        matches.push_back(match_loops(source_part.mesh.points, loop, target_part.mesh.points, target_part.loops[k], local));
    }
    return matches;
}

/// Keys name vertices of the target's boundary; the loop to be met lies across the strip from there.
LoopMatch MergeSession::State::match_beyond_strip(std::size_t k, const std::vector<int>& loop, MergeKeys& keys) const {
    const Strip& strip = target_strips[k];
    const auto on_boundary = [&](int working) {
        for (const int v : strip.near)
            if (strip.origin[v].is_vertex() && strip.origin[v].vertex[0] == working) return v;
        throw InvalidInput("key-not-on-boundary", "A key names target vertex " + std::to_string(target.source_of_working[working]) + ", which is not on the boundary. Place the key on it.");
    };
    MergeKeys local, beyond;
    if (keys.empty()) {
        const auto [s, t] = best_key(source_part.mesh.points, loop, strip.mesh.points, strip.near);
        keys.emplace_back(source.source_of_working[source_part.origin[s].vertex[0]], target.source_of_working[strip.origin[t].vertex[0]]);
    }
    for (const auto& [s, t] : keys)
        local.emplace_back(source_place[to_working({s}, source, "source").front()], on_boundary(to_working({t}, target, "target").front()));
    (void)match_loops(source_part.mesh.points, loop, strip.mesh.points, strip.near, local); // says what is wrong with the keys as given
    for (const auto& [s, t] : local)
        if (const int end = across_from(strip, t); end >= 0) {
            const auto at = std::find(strip.far.begin(), strip.far.end(), end) - strip.far.begin();
            beyond.emplace_back(s, strip.far_in_rest[static_cast<std::size_t>(at)]);
        }
    try {
        return match_loops(source_part.mesh.points, loop, target_part.mesh.points, target_part.loops[k], beyond);
    } catch (const InvalidInput&) { // paths across may run together: then the first key alone tells the turn
        beyond.resize(std::min<std::size_t>(beyond.size(), 1));
        return match_loops(source_part.mesh.points, loop, target_part.mesh.points, target_part.loops[k], beyond);
    }
}

/// L v that the target's detail asks for at each blended vertex: its curvature normal at the partner in the other
/// strip (both over the unit square), times the area that the source's vertex will have.
Points MergeSession::State::details(std::span<const MergeKeys> keys, bool turned, double scale) const {
    const Eigen::VectorXd areas = vertex_areas(source_part.mesh);
    Points result = Points::Zero(std::ssize(blended), 3);
    for (int k = 0; k < std::ssize(source_strips); ++k) {
        const Strip &own = source_strips[k], &other = target_strips[k];
        const auto start = [&](const Strip& strip, int working) {
            for (const int v : strip.near)
                if (strip.origin[v].is_vertex() && strip.origin[v].vertex[0] == working) return v;
            return strip.near.front();
        };
        const auto [s, t] = keys[k].front();
        const SquareMap own_map = square_map(own, start(own, source.working_of_source[s]), turned);
        const SquareMap other_map = square_map(other, start(other, target.working_of_source[t]), true);
        const PlaneLocator locator(other_map.points, other_map.triangles);
        for (std::size_t b = 0; b < blended.size(); ++b) {
            if (blended[b].first != k) continue;
            const int v = blended[b].second; // the first copy of a vertex on the cut keeps its number
            // The strips overlap: where the source's begins, the target's ends.
            const PlanePlace place = locator.locate({own_map.points(v, 0), 1 - own_map.points(v, 1)}, true);
            if (place.triangle < 0) continue;
            Eigen::RowVector3d curvature = Eigen::RowVector3d::Zero();
            for (int c = 0; c < 3; ++c) {
                const Origin& origin = other.origin[other_map.original[other_map.triangles(place.triangle, c)]];
                for (int o = 0; o < 3; ++o) curvature += place.weight[c] * origin.weight[o] * target_curvature.row(origin.vertex[o]);
            }
            result.row(static_cast<Eigen::Index>(b)) = scale * scale * areas[own.part_vertex[v]] * curvature;
        }
    }
    return result;
}

Points MergeSession::State::deform_source(const std::vector<LoopMatch>& matches, std::span<const MergeKeys> keys, bool turned, bool settle, double& seconds) const {
    std::vector<Affine3d> maps;
    Points rest(0, 3), there(0, 3);
    const Points normals = turned ? Points(-source_normals) : source_normals;
    for (std::size_t k = 0; k < matches.size(); ++k) {
        const LoopMatch& m = matches[k];
        const LoopImage image = image_of_loop(m, source_part.mesh.points, normals, target_part.mesh.points, target_normals);
        std::vector<int> place_of(source_part.origin.size(), -1);
        for (std::size_t i = 0; i < m.source.size(); ++i) place_of[m.source[i]] = static_cast<int>(i);
        for (const int v : source_part.loops[k]) { // in the order in which the handles were made
            const int i = place_of[v];
            Affine3d map = Affine3d::Identity();
            // Fu 3.3.2: the placed source keeps its local frames; only the size of its boundary is fitted.
            map.linear() = image.scale[i] * (options.mode == MergeMode::independent ? image.rotation[i] : Eigen::Matrix3d::Identity());
            map.translation() = image.positions.row(i).transpose() - map.linear() * source_part.mesh.points.row(v).transpose();
            maps.push_back(map);
            rest.conservativeResize(rest.rows() + 1, 3);
            there.conservativeResize(rest.rows(), 3);
            rest.row(rest.rows() - 1) = source_part.mesh.points.row(v);
            there.row(rest.rows() - 1) = image.positions.row(i);
        }
    }
    for (const MergeHandle& handle : fixed) maps.push_back(target.to_working(handle.map));
    Points wanted;
    if (!blended.empty()) wanted = details(keys, turned, options.mode == MergeMode::independent ? fit_similarity(rest, there).scale : 1);
    DeformResult moved = deform->deform(maps, settle, blended.empty() ? nullptr : &wanted);
    seconds = moved.solve_seconds + moved.rotate_seconds + moved.reconstruct_seconds;
    if (!loose.empty()) {
        const Affine3d whole = fit_similarity(rest, there).affine();
        for (const int v : loose) moved.positions.row(v) = (whole * Vector3d(source_part.mesh.points.row(v))).transpose();
    }
    // To the last bit on the target's loop: the solve returns it but for rounding.
    int h = 0;
    for (const std::vector<int>& loop : source_part.loops)
        for (const int v : loop) moved.positions.row(v) = there.row(h++);
    return moved.positions;
}

MergeSession::MergeSession(const WorkingMesh& source, const WorkingMesh& target, std::span<const MergeBoundary> boundaries, MergeOptions options,
                           std::span<const int> roi, std::span<const MergeHandle> handles)
    : state_(new State{.source = source, .target = target, .options = options}) {
    Seconds watch;
    state_->cut(boundaries);
    state_->refine();
    state_->prepare(roi, handles);
    state_->prepare_seconds = watch.lap();
}

MergeSession::MergeSession(const WorkingMesh& source, const WorkingMesh& target, const PaintedRegions& regions, MergeOptions options)
    : state_(new State{.source = source, .target = target, .options = options}) {
    Seconds watch;
    state_->find_boundary(regions);
    state_->prepare({}, {});
    state_->prepare_seconds = watch.lap();
}

MergeSession::~MergeSession() = default;
MergeSession::MergeSession(MergeSession&&) noexcept = default;

bool MergeSession::step() {
    const bool more = state_->deform->step();
    if (!more)
        for (const Finding& w : state_->deform->warnings())
            if (w.code == "factor-shifted") state_->warnings.push_back(w);
    return more;
}
double MergeSession::fraction() const { return state_->deform->fraction(); }

MergeResult MergeSession::merge(std::span<const MergeKeys> keys, bool settle) const {
    const State& s = *state_;
    if (keys.size() != s.source_part.loops.size())
        throw InvalidInput("boundary-count", "There are " + std::to_string(s.source_part.loops.size()) + " pairs of boundaries but keys for " +
                                                 std::to_string(keys.size()) + ".");
    Seconds watch;
    MergeResult result;
    std::vector<LoopMatch> matches;
    result.source_turned = s.looks_turned;
    try {
        matches = s.match(keys, result.source_turned, result.keys, result.warnings);
    } catch (const InvalidInput& error) {
        if (error.code() != k_keys_reversed) throw;
        result.source_turned = !result.source_turned; // three keys know better than volumes
        result.keys.clear();
        result.warnings.clear();
        matches = s.match(keys, result.source_turned, result.keys, result.warnings);
    }
    if (result.source_turned) result.warnings.push_back({"source-turned", 1, {}, true});

    const Points positions = s.deform_source(matches, result.keys, result.source_turned, settle, result.solve_seconds);
    watch.lap();
    JoinedMesh joined = stitch(s.target_part, s.source_part, result.source_turned, positions, matches);
    std::vector<char> moved(static_cast<std::size_t>(joined.target_vertices), 0);
    if (s.options.smoothing > 0) {
        smooth_seam(joined, s.options.smoothing);
        for (const std::vector<int>& seam : joined.seams)
            for (const int v : seam)
                if (v < joined.target_vertices) moved[v] = 1;
    }
    result.seam = seam_figures(joined);
    result.model = to_files(joined, s.target_part, s.target, s.source_part, s.source, moved);
    result.stitch_seconds = watch.lap();
    return result;
}

const std::vector<double>& MergeSession::energies() const { return state_->energies; }
const std::optional<Placement>& MergeSession::placement() const { return state_->placement; }
int MergeSession::free_vertices() const { return state_->deform->free_vertices(); }
int MergeSession::degenerate_vertices() const { return state_->deform->degenerate_vertices(); }
double MergeSession::prepare_seconds() const { return state_->prepare_seconds; }
double MergeSession::factor_seconds() const { return state_->deform->factor_seconds(); }
double MergeSession::memory_bytes() const { return state_->deform->memory_bytes(); }
const std::vector<Finding>& MergeSession::warnings() const { return state_->warnings; }

} // namespace lissom
