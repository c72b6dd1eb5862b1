#include "lissom/merge/opened_target.h"

#include "lissom/mesh/errors.h"
#include "lissom/mesh/topology.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

namespace lissom {
namespace {

using Eigen::Vector2d;

constexpr double k_margin = 0.4; // of a vertex' mean edge: nearer ones would leave slivers beside the outline

double turn(const Vector2d& a, const Vector2d& b, const Vector2d& c) {
    return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

class Opener {
public:
    Opener(const TriangleMesh& target, const RegionMaps& maps, const PlanePoints& outline, const std::vector<PlanePlace>& places)
        : target_(target), maps_(maps), outline_(outline), places_(places), gone_(maps.disk_triangles.size(), 0) {}

    Part run() {
        check_outline();
        remove_under_outline();
        const std::vector<int> rim = tidy_rim();
        return assemble(rim);
    }

private:
    [[nodiscard]] Vector2d at(int i) const { return outline_.row(i % outline_.rows()).transpose(); }
    [[nodiscard]] Vector2d mapped(int v) const { return maps_.disk_map.row(v).transpose(); }

    void check_outline() const {
        const auto n = static_cast<int>(outline_.rows());
        for (int i = 0; i < n; ++i)
            for (int j = i + 2; j < n; ++j) {
                if (i == 0 && j == n - 1) continue;
                if (turn(at(i), at(i + 1), at(j)) * turn(at(i), at(i + 1), at(j + 1)) < 0 && turn(at(j), at(j + 1), at(i)) * turn(at(j), at(j + 1), at(i + 1)) < 0)
                    throw InvalidInput("outline-crosses-itself", "The source region's map folds over itself at the boundary. Paint the regions smaller or smoother.");
            }
    }

    [[nodiscard]] bool contains(const Vector2d& p) const {
        bool inside = false;
        for (int i = 0; i < outline_.rows(); ++i) {
            const Vector2d a = at(i), b = at(i + 1);
            if ((a.y() > p.y()) != (b.y() > p.y()) && p.x() < a.x() + (b.x() - a.x()) * (p.y() - a.y()) / (b.y() - a.y())) inside = !inside;
        }
        return inside;
    }
    [[nodiscard]] double distance(const Vector2d& p) const {
        double least = std::numeric_limits<double>::infinity();
        for (int i = 0; i < outline_.rows(); ++i) {
            const Vector2d a = at(i), e = at(i + 1) - a;
            const double f = e.squaredNorm() > 0 ? std::clamp((p - a).dot(e) / e.squaredNorm(), 0.0, 1.0) : 0;
            least = std::min(least, (a + f * e - p).norm());
        }
        return least;
    }

    void remove_under_outline() {
        const VertexRings rings = vertex_rings(maps_.disk);
        std::vector<char> doomed(static_cast<std::size_t>(maps_.disk.vertex_count()), 0);
        const Vector2d low = outline_.colwise().minCoeff().transpose(), high = outline_.colwise().maxCoeff().transpose();
        for (int v = 0; v < maps_.disk.vertex_count(); ++v) {
            double edge = 0;
            for (const int w : rings[v]) edge += (mapped(v) - mapped(w)).norm() / static_cast<double>(rings[v].size());
            const Vector2d p = mapped(v), reach = Vector2d::Constant(edge);
            if ((p - low + reach).minCoeff() < 0 || (high - p + reach).minCoeff() < 0) continue;
            doomed[v] = contains(p) || distance(p) < k_margin * edge;
        }
        for (std::size_t t = 0; t < gone_.size(); ++t)
            for (int c = 0; c < 3; ++c)
                if (doomed[maps_.disk.triangles(static_cast<Eigen::Index>(t), c)]) gone_[t] = 1;
        for (const PlanePlace& place : places_) gone_[place.triangle] = 1;
        // Edges of the outline that cross a triangle without a doomed corner.
        for (std::size_t t = 0; t < gone_.size(); ++t)
            for (int c = 0; c < 3 && !gone_[t]; ++c) {
                const Vector2d a = mapped(maps_.disk.triangles(static_cast<Eigen::Index>(t), c)), b = mapped(maps_.disk.triangles(static_cast<Eigen::Index>(t), (c + 1) % 3));
                if (std::min(a.x(), b.x()) > high.x() || std::max(a.x(), b.x()) < low.x() || std::min(a.y(), b.y()) > high.y() || std::max(a.y(), b.y()) < low.y()) continue;
                for (int i = 0; i < outline_.rows() && !gone_[t]; ++i)
                    gone_[t] = turn(a, b, at(i)) * turn(a, b, at(i + 1)) <= 0 && turn(at(i), at(i + 1), a) * turn(at(i), at(i + 1), b) <= 0;
            }
    }

    /// The border of what is removed, counter-clockwise. Grows the hole until that is one simple loop.
    [[nodiscard]] std::vector<int> tidy_rim() {
        for (int round = 0; round < 20; ++round) {
            std::vector<int> removed;
            for (std::size_t t = 0; t < gone_.size(); ++t)
                if (gone_[t]) removed.push_back(static_cast<int>(t));
            if (removed.empty() || removed.size() == gone_.size()) break;
            TriangleMesh hole{maps_.disk.points, Triangles(std::ssize(removed), 3)};
            for (std::size_t t = 0; t < removed.size(); ++t) hole.triangles.row(static_cast<Eigen::Index>(t)) = maps_.disk.triangles.row(removed[t]);
            const auto loops = boundary_loops(hole);
            std::set<int> bad;
            for (const int v : non_manifold_vertices(hole)) bad.insert(v);
            const std::set<int> border(maps_.border.begin(), maps_.border.end());
            bool at_border = false;
            for (const std::vector<int>& loop : loops)
                for (const int v : loop) at_border = at_border || border.contains(v);
            if (loops.size() == 1 && bad.empty() && !at_border) return loops.front();
            if (at_border) break;
            if (loops.size() > 1) // islands inside the hole: all but the longest loop
                for (const std::vector<int>& loop : loops)
                    if (&loop != &*std::max_element(loops.begin(), loops.end(), [](const auto& a, const auto& b) { return a.size() < b.size(); })) bad.insert(loop.begin(), loop.end());
            for (std::size_t t = 0; t < gone_.size(); ++t)
                for (int c = 0; c < 3; ++c)
                    if (bad.contains(maps_.disk.triangles(static_cast<Eigen::Index>(t), c))) gone_[t] = 1;
        }
        throw InvalidInput("target-region-too-small", "The boundary comes too near to the edge of the target region: no whole face is left around it. "
                                                      "Paint more of the target, or make the placement smaller.");
    }

    Part assemble(const std::vector<int>& rim) const {
        Part part;
        std::vector<char> removed(static_cast<std::size_t>(target_.triangle_count()), 0);
        for (std::size_t t = 0; t < gone_.size(); ++t)
            if (gone_[t]) removed[maps_.disk_triangles[t]] = 1;
        std::vector<int> place(static_cast<std::size_t>(target_.vertex_count()), -1);
        for (int t = 0; t < target_.triangle_count(); ++t)
            if (!removed[t])
                for (int c = 0; c < 3; ++c) place[target_.triangles(t, c)] = 0;
        for (int v = 0; v < target_.vertex_count(); ++v)
            if (place[v] == 0) {
                place[v] = static_cast<int>(part.origin.size());
                part.origin.push_back(Origin::of(v));
            }
        const int kept = static_cast<int>(part.origin.size()), n = static_cast<int>(outline_.rows());
        part.mesh.points.resize(kept + n, 3);
        for (int v = 0; v < kept; ++v) part.mesh.points.row(v) = target_.points.row(part.origin[v].vertex[0]);
        for (int i = 0; i < n; ++i) {
            const PlanePlace& p = places_[i];
            Origin origin;
            part.mesh.points.row(kept + i).setZero();
            for (int c = 0; c < 3; ++c) {
                origin.vertex[c] = maps_.disk_vertices[maps_.disk.triangles(p.triangle, c)];
                origin.weight[c] = p.weight[c];
                part.mesh.points.row(kept + i) += p.weight[c] * target_.points.row(origin.vertex[c]);
            }
            part.origin.push_back(origin);
        }
        PlanePoints outer(std::ssize(rim), 2);
        for (std::size_t k = 0; k < rim.size(); ++k) outer.row(static_cast<Eigen::Index>(k)) = mapped(rim[k]).transpose();
        const auto band = triangulate_band(outer, outline_);
        std::vector<Eigen::RowVector3i> triangles;
        for (int t = 0; t < target_.triangle_count(); ++t)
            if (!removed[t]) {
                triangles.emplace_back(place[target_.triangles(t, 0)], place[target_.triangles(t, 1)], place[target_.triangles(t, 2)]);
                part.triangle_origin.push_back(t);
                part.is_whole.push_back(1);
            }
        const auto vertex = [&](int k) { return k < std::ssize(rim) ? place[maps_.disk_vertices[rim[k]]] : kept + k - static_cast<int>(rim.size()); };
        for (const auto& [a, b, c] : band) {
            triangles.emplace_back(vertex(a), vertex(b), vertex(c));
            // A triangle of the band lies on several; the one under an outline corner stands for them.
            int home = places_.front().triangle;
            for (const int k : {a, b, c})
                if (k >= std::ssize(rim)) home = places_[static_cast<std::size_t>(k) - rim.size()].triangle;
            part.triangle_origin.push_back(maps_.disk_triangles[home]);
            part.is_whole.push_back(0);
        }
        part.mesh.triangles.resize(std::ssize(triangles), 3);
        for (std::size_t t = 0; t < triangles.size(); ++t) part.mesh.triangles.row(static_cast<Eigen::Index>(t)) = triangles[t];
        std::vector<int> loop{kept};
        for (int i = n - 1; i > 0; --i) loop.push_back(kept + i);
        part.loops.push_back(std::move(loop));
        return part;
    }

    const TriangleMesh& target_;
    const RegionMaps& maps_;
    const PlanePoints& outline_;
    const std::vector<PlanePlace>& places_;
    std::vector<char> gone_; ///< per disk triangle
};

} // namespace

Part open_target(const TriangleMesh& target, const RegionMaps& maps, const PlanePoints& outline, const std::vector<PlanePlace>& places) {
    return Opener(target, maps, outline, places).run();
}

} // namespace lissom
