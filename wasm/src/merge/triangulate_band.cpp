#include "lissom/merge/opened_target.h"
#include "lissom/mesh/triangulate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>
#include <utility>

namespace lissom {
namespace {

using Eigen::Vector2d;

double turn(const Vector2d& a, const Vector2d& b, const Vector2d& c) {
    return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

bool cross_properly(const Vector2d& a, const Vector2d& b, const Vector2d& c, const Vector2d& d) {
    return turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0;
}

double angle(const Vector2d& at, const Vector2d& b, const Vector2d& c) {
    return std::atan2(std::abs(turn(at, b, c)), (b - at).dot(c - at));
}

class Band {
public:
    Band(const PlanePoints& outer, const PlanePoints& inner) : outer_(static_cast<int>(outer.rows())) {
        for (int i = 0; i < outer.rows(); ++i) points_.push_back(outer.row(i).transpose());
        for (int i = 0; i < inner.rows(); ++i) points_.push_back(inner.row(i).transpose());
    }

    std::vector<std::array<int, 3>> run() {
        const auto [o, i] = bridge();
        const int inner = static_cast<int>(points_.size()) - outer_;
        std::vector<int> walk; // around the outer polygon, over the bridge, around the inner one backwards, and back
        for (int k = 0; k <= outer_; ++k) walk.push_back((o + k) % outer_);
        for (int k = 0; k <= inner; ++k) walk.push_back(outer_ + ((i - outer_ - k) % inner + inner) % inner);
        PolygonMesh polygon{Points::Zero(std::ssize(walk), 3), {0, static_cast<int>(walk.size())}, {}};
        for (std::size_t k = 0; k < walk.size(); ++k) {
            polygon.points.row(static_cast<Eigen::Index>(k)).head<2>() = points_[walk[k]].transpose();
            polygon.corners.push_back(static_cast<int>(k));
        }
        const Triangulation cut = triangulate(polygon);
        for (int t = 0; t < cut.triangles.rows(); ++t) {
            std::array<int, 3> triangle{walk[cut.triangles(t, 0)], walk[cut.triangles(t, 1)], walk[cut.triangles(t, 2)]};
            if (triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0]) continue;
            triangles_.push_back(triangle);
        }
        flip();
        return triangles_;
    }

private:
    /// The shortest line from the outer to the inner polygon that crosses neither.
    [[nodiscard]] std::pair<int, int> bridge() const {
        std::vector<std::tuple<double, int, int>> lines;
        for (int o = 0; o < outer_; ++o)
            for (int i = outer_; i < std::ssize(points_); ++i) lines.emplace_back((points_[o] - points_[i]).norm(), o, i);
        std::sort(lines.begin(), lines.end());
        for (const auto& [length, o, i] : lines) {
            bool clear = true;
            for (int k = 0; k < std::ssize(points_) && clear; ++k) clear = !cross_properly(points_[o], points_[i], points_[k], points_[after(k)]);
            if (clear) return {o, i};
        }
        return {std::get<1>(lines.front()), std::get<2>(lines.front())};
    }
    [[nodiscard]] int after(int k) const {
        if (k < outer_) return (k + 1) % outer_;
        return k + 1 < std::ssize(points_) ? k + 1 : outer_;
    }

    /// Lawson's flips: an inner edge is turned where that makes the least angle larger, until none is left.
    void flip() {
        for (int round = 0; round < 100; ++round) {
            std::map<std::pair<int, int>, int> at; // directed edge → triangle
            for (int t = 0; t < std::ssize(triangles_); ++t)
                for (int c = 0; c < 3; ++c) at[{triangles_[t][c], triangles_[t][(c + 1) % 3]}] = t;
            bool changed = false;
            std::vector<char> touched(triangles_.size(), 0);
            for (const auto& [edge, t] : at) {
                const auto beyond = at.find({edge.second, edge.first});
                if (edge.first > edge.second || beyond == at.end() || touched[t] || touched[beyond->second]) continue;
                const int u = beyond->second, a = edge.first, b = edge.second, c = opposite(t, a, b), d = opposite(u, b, a);
                const bool convex = turn(points_[c], points_[a], points_[d]) > 0 && turn(points_[d], points_[b], points_[c]) > 0;
                if (!convex || at.contains({c, d}) || at.contains({d, c})) continue;
                const double now = std::min(least(a, b, c), least(b, a, d)), then = std::min(least(a, d, c), least(d, b, c));
                if (!(then > now + 1e-6)) continue;
                triangles_[t] = {a, d, c};
                triangles_[u] = {d, b, c};
                touched[t] = touched[u] = 1;
                changed = true;
            }
            if (!changed) break;
        }
    }
    [[nodiscard]] int opposite(int t, int a, int b) const {
        for (const int v : triangles_[t])
            if (v != a && v != b) return v;
        return a;
    }
    [[nodiscard]] double least(int a, int b, int c) const {
        return std::min({angle(points_[a], points_[b], points_[c]), angle(points_[b], points_[c], points_[a]), angle(points_[c], points_[a], points_[b])});
    }

    const int outer_;
    std::vector<Vector2d> points_;
    std::vector<std::array<int, 3>> triangles_;
};

} // namespace

std::vector<std::array<int, 3>> triangulate_band(const PlanePoints& outer, const PlanePoints& inner) {
    return Band(outer, inner).run();
}

} // namespace lissom
