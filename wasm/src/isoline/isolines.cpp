#include "lissom/isoline/isolines.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <utility>

namespace lissom {
namespace {

/// The crossed edge a segment ends on, as one key.
std::int64_t edge_key(int a, int b) {
    return (static_cast<std::int64_t>(std::min(a, b)) << 32) | static_cast<std::int64_t>(std::max(a, b));
}

/// Joins segments end to start. Starts whose edge no segment ends on begin a chain.
void walk(const std::vector<std::int64_t>& starts, const std::vector<std::int64_t>& ends, Isoline& line) {
    std::multimap<std::int64_t, int> leaving;
    for (int s = 0; s < static_cast<int>(starts.size()); ++s) leaving.emplace(starts[s], s);
    std::map<std::int64_t, int> arrivals;
    for (const std::int64_t e : ends) ++arrivals[e];
    std::vector<char> used(starts.size(), 0);
    const auto follow = [&](int s) {
        std::vector<int> path;
        for (int at = s; at >= 0;) {
            used[at] = 1;
            path.push_back(at);
            const auto [first, last] = leaving.equal_range(ends[at]);
            const auto next = std::find_if(first, last, [&](const auto& entry) { return !used[entry.second]; });
            at = next == last ? -1 : next->second;
        }
        return path;
    };
    std::vector<std::vector<int>> chains;
    for (int s = 0; s < static_cast<int>(starts.size()); ++s)
        if (!used[s] && arrivals.find(starts[s]) == arrivals.end()) chains.push_back(follow(s));
    for (int s = 0; s < static_cast<int>(starts.size()); ++s) {
        if (used[s]) continue;
        std::vector<int> path = follow(s);
        const bool comes_round = ends[path.back()] == starts[s];
        (comes_round ? line.loops : chains).push_back(std::move(path));
    }
    line.closed = static_cast<int>(line.loops.size());
    for (auto& chain : chains) line.loops.push_back(std::move(chain));
}

} // namespace

double Isoline::length() const {
    double sum = 0;
    for (const IsolineSegment& s : segments) sum += s.length;
    return sum;
}

Isoline isoline(const TriangleMesh& mesh, const Eigen::VectorXd& field, double value) {
    Isoline line;
    line.value = value;
    std::vector<std::int64_t> starts, ends;
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        const auto corner = [&](int k) { return mesh.triangles(t, k % 3); };
        const auto above = [&](int k) { return field[corner(k)] > value; };
        const int count = above(0) + above(1) + above(2);
        if (count == 0 || count == 3) continue;
        int lone = 0;
        while (above(lone) != (count == 1)) ++lone;
        const auto crossing = [&](int a, int b) -> Eigen::Vector3d {
            const double f = (value - field[a]) / (field[b] - field[a]);
            return mesh.points.row(a) + f * (mesh.points.row(b) - mesh.points.row(a));
        };
        const int at = corner(lone), next = corner(lone + 1), before = corner(lone + 2);
        // Walking with the larger values on the left: from the side towards `next` where the lone corner is above.
        const int first = count == 1 ? next : before, second = count == 1 ? before : next;
        IsolineSegment segment{t, crossing(at, first), crossing(at, second), 0};
        segment.length = (segment.to - segment.from).norm();
        line.segments.push_back(segment);
        starts.push_back(edge_key(at, first));
        ends.push_back(edge_key(at, second));
    }
    walk(starts, ends, line);
    return line;
}

} // namespace lissom
