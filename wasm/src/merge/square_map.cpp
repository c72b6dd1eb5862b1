// A strip over the unit square: where each of its vertices comes to lie.

#include "lissom/merge/transition.h"
#include "lissom/mesh/errors.h"
#include "lissom/mesh/surface_paths.h"

#include <algorithm>
#include <utility>

namespace lissom {
namespace {

/// Fractions of the length of a closed line, from its first vertex on.
std::vector<double> fractions(const Points& points, const std::vector<int>& line) {
    std::vector<double> at{0};
    for (std::size_t i = 0; i < line.size(); ++i) at.push_back(at.back() + (points.row(line[(i + 1) % line.size()]) - points.row(line[i])).norm());
    for (double& a : at) a /= at.back() > 0 ? at.back() : 1;
    return at;
}

/// The line from `first` on, in the direction asked for.
std::vector<int> turned_to(std::vector<int> line, int first, bool backwards) {
    if (backwards) std::reverse(line.begin(), line.end());
    std::rotate(line.begin(), std::find(line.begin(), line.end(), first), line.end());
    return line;
}

/// Bends fractions, ascending from 0 to 1, so that they pass through what is known of them, straight in between.
void through_anchors(std::vector<double>& u, std::vector<std::pair<double, double>> known) {
    std::sort(known.begin(), known.end());
    std::vector<std::pair<double, double>> kept{{0, 0}};
    for (const auto& [from, to] : known)
        if (from > kept.back().first && to > kept.back().second && from < 1 && to < 1) kept.emplace_back(from, to);
    kept.emplace_back(1, 1);
    for (double& x : u) {
        std::size_t k = 1;
        while (k + 1 < kept.size() && x > kept[k].first) ++k;
        const auto& [a, b] = kept[k - 1];
        const auto& [c, d] = kept[k];
        x = b + (d - b) * (x - a) / (c - a);
    }
}

} // namespace

int across_from(const Strip& strip, int start) {
    const std::vector<int> path = path_across(strip.mesh, strip.near, strip.far, start);
    return path.empty() ? -1 : path.back();
}

double fraction_from(const Strip& strip, int start, bool backwards, int near) {
    const std::vector<int> line = turned_to(strip.near, start, backwards);
    const auto at = std::find(line.begin(), line.end(), near) - line.begin();
    return fractions(strip.mesh.points, line)[static_cast<std::size_t>(at)];
}

SquareMap square_map(const Strip& strip, int start, bool backwards, const std::vector<SquareAnchor>& anchors) {
    const std::vector<int> path = path_across(strip.mesh, strip.near, strip.far, start);
    if (path.empty()) throw InvalidInput("transition-not-a-ring", "There is no way across the transition region from one of the keys. Choose another width.");
    const SlitRing slit = slit_ring(strip.mesh, path);
    std::vector<int> fixed;
    std::vector<Eigen::RowVector2d> where;
    std::vector<int> ends;
    for (const SquareAnchor& anchor : anchors) ends.push_back(across_from(strip, anchor.near));
    const auto walk = [&](const std::vector<int>& loop, int first, double v) {
        const std::vector<int> line = turned_to(loop, first, backwards);
        std::vector<double> u = fractions(strip.mesh.points, line);
        std::vector<std::pair<double, double>> known;
        for (std::size_t a = 0; a < anchors.size(); ++a) {
            const auto at = std::find(line.begin(), line.end(), v == 0 ? anchors[a].near : ends[a]) - line.begin();
            if (at > 0 && at < std::ssize(line)) known.emplace_back(u[static_cast<std::size_t>(at)], anchors[a].u);
        }
        through_anchors(u, std::move(known));
        for (std::size_t i = 1; i < line.size(); ++i) { // the first stands on the path, in two copies
            fixed.push_back(line[i]);
            where.emplace_back(u[i], v);
        }
    };
    walk(strip.near, path.front(), 0);
    walk(strip.far, path.back(), 1);
    // The surface lies to the left of the loop, so the path leads left and the walk begins on the path's right side.
    double length = 0, walked = 0;
    for (std::size_t k = 1; k < path.size(); ++k) length += (strip.mesh.points.row(path[k]) - strip.mesh.points.row(path[k - 1])).norm();
    for (std::size_t k = 0; k < path.size(); ++k) {
        if (k > 0) walked += (strip.mesh.points.row(path[k]) - strip.mesh.points.row(path[k - 1])).norm();
        const double v = length > 0 ? walked / length : static_cast<double>(k) / static_cast<double>(path.size() - 1);
        fixed.push_back(backwards ? slit.left[k] : slit.right[k]);
        where.emplace_back(0.0, v);
        fixed.push_back(backwards ? slit.right[k] : slit.left[k]);
        where.emplace_back(1.0, v);
    }
    PlanePoints places(std::ssize(where), 2);
    for (std::size_t k = 0; k < where.size(); ++k) places.row(static_cast<Eigen::Index>(k)) = where[k];
    return {slit.mesh.triangles, slit.original, tutte_map(slit.mesh, fixed, places)};
}

} // namespace lissom
