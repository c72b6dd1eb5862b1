#include "lissom/mesh/delaunay.h"

#include "lissom/mesh/half_edges.h"

#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <deque>

namespace lissom {
namespace {

using Eigen::Vector3d;

/// On a curved surface flips could go round in a circle; on a plane one edge is flipped a few times at most.
constexpr int k_flips_per_edge = 10;
/// cot α + cot β below which an edge gains enough by a flip to be worth it.
constexpr double k_slack = 1e-9;
/// Cosine between each new triangle and the two old ones together.
constexpr double k_flat = 0.9;

class Flipper {
public:
    explicit Flipper(TriangleMesh& mesh) : mesh_(mesh), beyond_(static_cast<std::size_t>(3 * mesh.triangle_count()), -1) {
        const auto sides = half_edges(mesh);
        for_each_edge(sides, [&](auto first, auto last) {
            if (last - first != 2 || first->forward == (first + 1)->forward) return;
            const int s = 3 * first->triangle + first->corner, t = 3 * (first + 1)->triangle + (first + 1)->corner;
            beyond_[s] = t;
            beyond_[t] = s;
            queue_.push_back(s);
        });
    }

    int run() {
        const std::size_t most = k_flips_per_edge * queue_.size();
        std::size_t flips = 0;
        while (!queue_.empty() && flips < most) {
            const int side = queue_.front();
            queue_.pop_front();
            if (flip(side)) ++flips;
        }
        return static_cast<int>(flips);
    }

private:
    static int next(int side) { return side - side % 3 + (side + 1) % 3; }
    static int last(int side) { return next(next(side)); }
    [[nodiscard]] int vertex(int side) const { return mesh_.triangles(side / 3, side % 3); }
    [[nodiscard]] Vector3d point(int side) const { return mesh_.points.row(vertex(side)).transpose(); }

    /// Of the angle that faces a side; a corner without an angle faces an edge as bad as can be.
    [[nodiscard]] double cotangent(int side) const {
        const Vector3d a = point(side) - point(last(side)), b = point(next(side)) - point(last(side));
        const double sine = a.cross(b).norm();
        return sine > 0 ? a.dot(b) / sine : -INFINITY;
    }

    /// Whether an edge joins the vertex that a side starts from with another one.
    [[nodiscard]] bool joined(int side, int with) const {
        for (const bool onwards : {true, false}) { // a fan with an end has two ways to it
            int at = side;
            do {
                if (vertex(next(at)) == with || vertex(last(at)) == with) return true;
                const int over = onwards ? beyond_[last(at)] : beyond_[at];
                if (over < 0) break;
                at = onwards ? over : next(over);
            } while (at != side);
            if (at == side) break;
        }
        return false;
    }

    bool flip(int side) {
        const int other = beyond_[side];
        if (other < 0 || cotangent(side) + cotangent(other) >= -k_slack) return false;
        // Triangles (a, b, p) and (b, a, q) become (a, q, p) and (q, b, p).
        const int t = side / 3, u = other / 3;
        const int a = vertex(side), b = vertex(other), p = vertex(last(side)), q = vertex(last(other));
        if (t == u || p == q || joined(last(side), q)) return false;
        const auto normal = [&](int i, int j, int k) -> Vector3d {
            const Vector3d from = mesh_.points.row(i).transpose();
            return (mesh_.points.row(j).transpose() - from).cross(mesh_.points.row(k).transpose() - from);
        };
        const Vector3d before = normal(a, b, p) + normal(b, a, q), first = normal(a, q, p), second = normal(q, b, p);
        for (const Vector3d& after : {first, second})
            if (after.dot(before) <= k_flat * after.norm() * before.norm()) return false;
        const std::array<int, 4> around{beyond_[next(side)], beyond_[last(side)], beyond_[next(other)], beyond_[last(other)]}; // bp, pa, aq, qb
        mesh_.triangles.row(t) << a, q, p;
        mesh_.triangles.row(u) << q, b, p;
        pair(3 * t, around[2]);     // aq
        pair(3 * t + 2, around[1]); // pa
        pair(3 * u, around[3]);     // qb
        pair(3 * u + 1, around[0]); // bp
        pair(3 * t + 1, 3 * u + 2); // qp, pq
        for (const int again : {3 * t, 3 * t + 2, 3 * u, 3 * u + 1})
            if (beyond_[again] >= 0) queue_.push_back(again);
        return true;
    }

    void pair(int side, int other) {
        beyond_[side] = other;
        if (other >= 0) beyond_[other] = side;
    }

    TriangleMesh& mesh_;
    std::vector<int> beyond_; ///< the same edge seen from the other side, of sides 3 · triangle + corner; −1: left alone
    std::deque<int> queue_;
};

} // namespace

int flip_to_delaunay(TriangleMesh& mesh) { return Flipper(mesh).run(); }

} // namespace lissom
