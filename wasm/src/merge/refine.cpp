#include "lissom/merge/refine.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace lissom {
namespace {

constexpr double k_tie = 1e-9; // lengths this close (relative) are equal, so that rounding decides nothing

class Refiner {
public:
    explicit Refiner(Part& part) : part_(part) {
        for (int v = 0; v < part.mesh.vertex_count(); ++v) points_.push_back(part.mesh.points.row(v));
        for (int t = 0; t < part.mesh.triangle_count(); ++t) {
            triangles_.push_back(part.mesh.triangles.row(t));
            for (int c = 0; c < 3; ++c)
                if (const Edge e{triangles_[t][c], triangles_[t][(c + 1) % 3]}; !at_.emplace(e, t).second) frozen_.insert(key(e.first, e.second));
        }
    }

    void shorten(std::vector<int>& loop, double longest) {
        for (std::size_t i = 0; i < loop.size();) {
            const int a = loop[i], b = loop[(i + 1) % loop.size()];
            if (const auto known = middle_.find(key(a, b)); known != middle_.end()) {
                loop.insert(loop.begin() + static_cast<std::ptrdiff_t>(i) + 1, known->second);
                continue;
            }
            if (frozen_.contains(key(a, b)) || !(length(a, b) > longest * (1 + k_tie)) || !has_middle(a, b)) {
                ++i;
                continue;
            }
            bisect_toward(a, b);
        }
    }

    int finish() {
        for (std::vector<int>& loop : part_.loops) // a path may have ended at another loop
            for (std::size_t i = 0; i < loop.size();)
                if (const auto known = middle_.find(key(loop[i], loop[(i + 1) % loop.size()])); known != middle_.end())
                    loop.insert(loop.begin() + static_cast<std::ptrdiff_t>(i) + 1, known->second);
                else ++i;
        const int added = static_cast<int>(points_.size()) - part_.mesh.vertex_count();
        part_.mesh.points.resize(std::ssize(points_), 3);
        for (std::size_t v = 0; v < points_.size(); ++v) part_.mesh.points.row(v) = points_[v];
        part_.mesh.triangles.resize(std::ssize(triangles_), 3);
        for (std::size_t t = 0; t < triangles_.size(); ++t) part_.mesh.triangles.row(t) = triangles_[t];
        return added;
    }

private:
    using Edge = std::pair<int, int>;

    [[nodiscard]] double length(int a, int b) const { return (points_[a] - points_[b]).norm(); }
    /// Ends that are neighbours in double precision have none: half of such an edge is as long as the whole.
    [[nodiscard]] bool has_middle(int a, int b) const {
        const Eigen::RowVector3d middle = 0.5 * (points_[a] + points_[b]);
        return middle != points_[a] && middle != points_[b];
    }

    /// The longest edge of a triangle, as it runs there.
    [[nodiscard]] Edge longest_edge(int t) const {
        int best = -1;
        for (int c = 0; c < 3; ++c) {
            if (frozen_.contains(key(triangles_[t][c], triangles_[t][(c + 1) % 3]))) continue;
            if (best < 0) {
                best = c;
                continue;
            }
            const double here = length(triangles_[t][c], triangles_[t][(c + 1) % 3]);
            const double there = length(triangles_[t][best], triangles_[t][(best + 1) % 3]);
            if (here > there * (1 + k_tie)) best = c;
            else if (here > there * (1 - k_tie) && key(triangles_[t][c], triangles_[t][(c + 1) % 3]) < key(triangles_[t][best], triangles_[t][(best + 1) % 3])) best = c;
        }
        return {triangles_[t][best], triangles_[t][(best + 1) % 3]};
    }
    [[nodiscard]] static Edge key(int a, int b) { return std::minmax(a, b); }

    /// One bisection on the way to that of (a, b): ever longer edges lead away from it, the last of them is bisected,
    /// and the next way is shorter. Lengths that are equal but for rounding could lead in a circle: a way of as many
    /// triangles as there are ends where it is.
    void bisect_toward(int a, int b) {
        const auto own = at_.find({a, b});
        int t = own != at_.end() ? own->second : at_.at({b, a});
        for (std::size_t way = 1;; ++way) {
            const auto [p, q] = longest_edge(t);
            if (key(p, q) == key(a, b) || way > triangles_.size()) return bisect(p, q);
            const auto beyond = at_.find({q, p});
            if (beyond == at_.end()) return bisect(p, q);
            const auto [r, s] = longest_edge(beyond->second);
            if (key(r, s) == key(p, q)) return bisect(p, q);
            t = beyond->second;
        }
    }

    void bisect(int p, int q) {
        const int middle = static_cast<int>(points_.size());
        middle_[key(p, q)] = middle;
        points_.push_back(0.5 * (points_[p] + points_[q]));
        part_.origin.push_back(between(part_.origin[std::min(p, q)], part_.origin[std::max(p, q)], 0.5));
        for (const auto& [from, to] : {Edge{p, q}, Edge{q, p}}) {
            const auto found = at_.find({from, to});
            if (found == at_.end()) continue;
            const int t = found->second;
            at_.erase(found);
            const int c = triangles_[t][0] == from ? 0 : triangles_[t][1] == from ? 1 : 2;
            const int apex = triangles_[t][(c + 2) % 3];
            const int other = static_cast<int>(triangles_.size());
            triangles_[t] = Eigen::RowVector3i(from, middle, apex);
            triangles_.push_back(Eigen::RowVector3i(middle, to, apex));
            part_.triangle_origin.push_back(part_.triangle_origin[t]);
            part_.is_whole[t] = 0;
            part_.is_whole.push_back(0);
            at_[{from, middle}] = at_[{middle, apex}] = t;
            at_[{middle, to}] = at_[{to, apex}] = at_[{apex, middle}] = other;
        }
    }

    Part& part_;
    std::vector<Eigen::RowVector3d> points_;
    std::vector<Eigen::RowVector3i> triangles_;
    std::map<Edge, int> at_;     ///< triangle that runs from → to
    std::map<Edge, int> middle_; ///< of edges that were bisected
    std::set<Edge> frozen_;      ///< edges of three triangles and such: bisecting them would tear the surface
};

} // namespace

int refine_loop(Part& part, int loop, double longest) {
    const std::vector<int>& vertices = part.loops[loop];
    bool needed = false;
    for (std::size_t i = 0; i < vertices.size(); ++i)
        needed = needed || (part.mesh.points.row(vertices[(i + 1) % vertices.size()]) - part.mesh.points.row(vertices[i])).norm() > longest * (1 + k_tie);
    if (!needed) return 0;
    Refiner refiner(part);
    refiner.shorten(part.loops[loop], longest);
    return refiner.finish();
}

} // namespace lissom
