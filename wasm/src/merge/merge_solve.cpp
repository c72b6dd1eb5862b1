// One merge: partners on the loops, what they ask of the source, and the source deformed.

#include "merge_state.h"

#include "lissom/merge/loop_frames.h"
#include "lissom/mesh/errors.h"
#include "lissom/mesh/operators.h"
#include "lissom/mesh/similarity.h"

#include <algorithm>

namespace lissom {

namespace {
using Eigen::Affine3d;
using Eigen::Vector3d;
} // namespace

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
            const int a = source_place[named_vertices({s}, source, "source").front()], b = target_place[named_vertices({t}, target, "target").front()];
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
        local.emplace_back(source_place[named_vertices({s}, source, "source").front()], on_boundary(named_vertices({t}, target, "target").front()));
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
        const int own_start = start(own, source.working_of_source[s]), other_start = start(other, target.working_of_source[t]);
        std::vector<SquareAnchor> own_anchors, other_anchors; // the other keys come to lie at the same u in both
        for (std::size_t a = 1; a < keys[k].size(); ++a) {
            const int near = start(own, source.working_of_source[keys[k][a].first]);
            const double u = fraction_from(own, own_start, turned, near);
            own_anchors.push_back({near, u});
            other_anchors.push_back({start(other, target.working_of_source[keys[k][a].second]), u});
        }
        const SquareMap own_map = square_map(own, own_start, turned, own_anchors);
        const SquareMap other_map = square_map(other, other_start, true, other_anchors);
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

} // namespace lissom
