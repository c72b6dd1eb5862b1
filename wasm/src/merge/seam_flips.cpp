#include "lissom/merge/seam_flips.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

namespace lissom {
namespace {

using Eigen::Vector3d;

constexpr double k_thin = 8 * std::numbers::pi / 180; // triangles whose least angle is below are worth a flip
constexpr double k_gain = 1e-3;                       // radians: what is left of the solve's rounding decides nothing

class Flipper {
public:
    Flipper(JoinedMesh& joined, const Part& target, const Part& source) : joined_(joined), target_(target), source_(source) {
        for (int t = 0; t < joined.mesh.triangle_count(); ++t)
            for (int c = 0; c < 3; ++c) ++runs_[edge(t, c)], at_[edge(t, c)] = t;
    }

    void run() {
        for (int round = 0; round < 10; ++round) {
            bool changed = false;
            for (int t = 0; t < joined_.mesh.triangle_count(); ++t)
                if (joined_.is_new[t] && least(corners(t)) < k_thin) changed = improve(t) || changed;
            if (!changed) return;
        }
    }

private:
    using Corners = std::array<int, 3>;

    [[nodiscard]] std::pair<int, int> edge(int t, int c) const { return {joined_.mesh.triangles(t, c), joined_.mesh.triangles(t, (c + 1) % 3)}; }
    [[nodiscard]] Corners corners(int t) const { return {joined_.mesh.triangles(t, 0), joined_.mesh.triangles(t, 1), joined_.mesh.triangles(t, 2)}; }
    [[nodiscard]] Vector3d point(int v) const { return joined_.mesh.points.row(v).transpose(); }
    [[nodiscard]] Vector3d normal(const Corners& c) const { return (point(c[1]) - point(c[0])).cross(point(c[2]) - point(c[0])); }
    [[nodiscard]] double least(const Corners& c) const {
        double angle = std::numbers::pi;
        for (int k = 0; k < 3; ++k) {
            const Vector3d a = point(c[(k + 1) % 3]) - point(c[k]), b = point(c[(k + 2) % 3]) - point(c[k]);
            angle = std::min(angle, std::atan2(a.cross(b).norm(), a.dot(b)));
        }
        return angle;
    }

    /// Where each corner lies on its input.
    [[nodiscard]] std::array<Origin, 3> origins(int t) const {
        if (joined_.made[t] >= 0) return joined_.made_corners[joined_.made[t]];
        const Part& part = joined_.from_source[t] ? source_ : target_;
        std::array<Origin, 3> result;
        for (int c = 0; c < 3; ++c)
            for (int k = 0; k < 3; ++k) {
                const int v = part.mesh.triangles(joined_.part_triangle[t], k);
                if ((joined_.from_source[t] ? joined_.vertex_of_source[v] : v) == joined_.mesh.triangles(t, c)) result[c] = part.origin[v];
            }
        return result;
    }

    void put(int t, const Corners& c, const std::array<Origin, 3>& origin) {
        joined_.mesh.triangles.row(t) << c[0], c[1], c[2];
        if (joined_.made[t] < 0) {
            joined_.made[t] = static_cast<int>(joined_.made_corners.size());
            joined_.made_corners.emplace_back();
        }
        joined_.made_corners[joined_.made[t]] = origin;
        joined_.is_new[t] = 1;
        for (int k = 0; k < 3; ++k) at_[edge(t, k)] = t;
    }

    /// Flips the edge of t that gains most, if any does.
    bool improve(int t) {
        int best = -1;
        double most = least(corners(t)) + k_gain;
        for (int c = 0; c < 3; ++c)
            if (const double gain = after_flip(t, c); gain > most) {
                most = gain;
                best = c;
            }
        if (best < 0) return false;
        const auto [a, b] = edge(t, best);
        const int u = at_.at({b, a});
        const int ct = (best + 2) % 3, cu = opposite(u, a, b);
        const std::array<Origin, 3> ot = origins(t), ou = origins(u);
        const int p = joined_.mesh.triangles(t, ct), q = joined_.mesh.triangles(u, cu);
        runs_.erase({a, b});
        runs_.erase({b, a});
        at_.erase({a, b});
        at_.erase({b, a});
        put(t, {a, q, p}, {ot[best], ou[cu], ot[ct]});
        put(u, {q, b, p}, {ou[cu], ot[(best + 1) % 3], ot[ct]});
        runs_[{p, q}] = runs_[{q, p}] = 1;
        return true;
    }

    [[nodiscard]] int opposite(int u, int a, int b) const {
        for (int c = 0; c < 3; ++c)
            if (joined_.mesh.triangles(u, c) != a && joined_.mesh.triangles(u, c) != b) return c;
        return 0;
    }

    /// The least angle of the two triangles after the flip of edge c; −1 where it must stay.
    [[nodiscard]] double after_flip(int t, int c) const {
        const auto [a, b] = edge(t, c);
        const auto beyond = at_.find({b, a});
        if (beyond == at_.end() || runs_.at({a, b}) != 1 || runs_.at({b, a}) != 1) return -1;
        const int u = beyond->second;
        if (joined_.from_source[t] != joined_.from_source[u]) return -1; // the seam itself
        const int p = joined_.mesh.triangles(t, (c + 2) % 3), q = joined_.mesh.triangles(u, opposite(u, a, b));
        if (p == q || runs_.contains({p, q}) || runs_.contains({q, p})) return -1;
        const Vector3d before = normal(corners(t)) + normal(corners(u)), first = normal({a, q, p}), second = normal({q, b, p});
        if (first.dot(before) <= 0.7 * first.norm() * before.norm() || second.dot(before) <= 0.7 * second.norm() * before.norm()) return -1;
        return std::min(least({a, q, p}), least({q, b, p}));
    }

    JoinedMesh& joined_;
    const Part &target_, &source_;
    std::map<std::pair<int, int>, int> at_;   ///< triangle that runs along a directed edge
    std::map<std::pair<int, int>, int> runs_; ///< how many do
};

} // namespace

void flip_thin_triangles(JoinedMesh& joined, const Part& target, const Part& source) {
    Flipper(joined, target, source).run();
}

} // namespace lissom
