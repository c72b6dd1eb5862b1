#include "lissom/merge/stitch.h"

#include "polygon_splits.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace lissom {
namespace {

using Eigen::Vector3d;

/// Differences of angle (radians) below this do not decide: what is left of the solve's rounding must not either.
constexpr double k_tie = 1e-4;
/// Corners of a cut triangle up to which its best triangulation is searched for: n³/6 triangles are looked at, 7 ms for 64.
/// The triangles of a match of even keys have ten.
constexpr int k_searched = 64;

double angle_at(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
    return std::atan2((b - a).cross(c - a).norm(), (b - a).dot(c - a));
}

/// Least angle, or −1 and less for a triangle that faces away.
double worth(const Vector3d& a, const Vector3d& b, const Vector3d& c, const Vector3d& normal) {
    const double least = std::min({angle_at(a, b, c), angle_at(b, c, a), angle_at(c, a, b)});
    return (b - a).cross(c - a).dot(normal) < 0 ? -1 - least : least;
}

/// What one edge of a triangle receives, in the direction in which the triangle runs.
struct Inserted {
    int vertex;
    double fraction;
};
using Insertions = std::map<std::pair<int, int>, std::vector<Inserted>>;

class Stitcher {
public:
    Stitcher(const Part& target, const Part& source, bool turned, const Points& positions, std::span<const LoopMatch> matches)
        : target_(target), source_(source), turned_(turned), matches_(matches) {
        out_.target_vertices = target.mesh.vertex_count();
        out_.mesh.points.resize(target.mesh.vertex_count() + source.mesh.vertex_count(), 3);
        out_.mesh.points << target.mesh.points, positions;
        for (int v = 0; v < source.mesh.vertex_count(); ++v) out_.vertex_of_source.push_back(out_.target_vertices + v);
    }

    JoinedMesh run() {
        for (const LoopMatch& match : matches_)
            for (const SeamPoint& point : match.points)
                if (point.source >= 0 && point.target >= 0) out_.vertex_of_source[match.source[point.source]] = match.target[point.target];
        for (const LoopMatch& match : matches_) insert(match);
        for (auto* insertions : {&into_target_, &into_source_})
            for (auto& [edge, list] : *insertions)
                std::stable_sort(list.begin(), list.end(), [](const Inserted& a, const Inserted& b) { return a.fraction < b.fraction; });
        add(target_, false, into_target_);
        add(source_, true, into_source_);
        out_.mesh.triangles.resize(std::ssize(triangles_), 3);
        for (std::size_t t = 0; t < triangles_.size(); ++t) out_.mesh.triangles.row(t) = triangles_[t];
        return std::move(out_);
    }

private:
    void insert(const LoopMatch& match) {
        auto& seam = out_.seams.emplace_back();
        const auto n = match.source.size(), m = match.target.size();
        for (const SeamPoint& point : match.points) {
            const int vertex = point.target >= 0 ? match.target[point.target] : out_.vertex_of_source[match.source[point.source]];
            seam.push_back(vertex);
            if (point.source < 0) {
                const int a = match.source[point.source_edge], b = match.source[(point.source_edge + 1) % n];
                into_source_[{a, b}].push_back({vertex, point.source_fraction});
            }
            if (point.target < 0) { // the target's triangles run the other way
                const int a = match.target[(point.target_edge + 1) % m], b = match.target[point.target_edge];
                into_target_[{a, b}].push_back({vertex, 1 - point.target_fraction});
            }
        }
    }

    void add(const Part& part, bool from_source, const Insertions& insertions) {
        std::set<int> ends;
        for (const auto& [edge, list] : insertions) ends.insert(edge.first);
        for (int t = 0; t < part.mesh.triangle_count(); ++t) {
            std::array<int, 3> corner{part.mesh.triangles(t, 0), part.mesh.triangles(t, 1), part.mesh.triangles(t, 2)};
            if (from_source && turned_) std::swap(corner[1], corner[2]);
            bool cut = false;
            for (int c = 0; c < 3; ++c) cut = cut || (ends.contains(corner[c]) && insertions.contains({corner[c], corner[(c + 1) % 3]}));
            if (cut) cut_up(part, t, corner, from_source, insertions);
            else append({joined(corner[0], from_source), joined(corner[1], from_source), joined(corner[2], from_source)}, from_source, t, -1);
        }
    }

    void cut_up(const Part& part, int t, const std::array<int, 3>& corner, bool from_source, const Insertions& insertions) {
        std::vector<int> vertices;
        std::vector<Origin> origins;
        std::vector<Vector3d> polygon;
        for (int c = 0; c < 3; ++c) {
            const int a = corner[c], b = corner[(c + 1) % 3];
            vertices.push_back(joined(a, from_source));
            origins.push_back(part.origin[a]);
            if (const auto list = insertions.find({a, b}); list != insertions.end())
                for (const auto& [vertex, fraction] : list->second) {
                    vertices.push_back(vertex);
                    origins.push_back(between(part.origin[a], part.origin[b], fraction));
                }
        }
        for (const int v : vertices) polygon.push_back(out_.mesh.points.row(v).transpose());
        const auto point = [&](int c) -> Vector3d { return out_.mesh.points.row(joined(corner[c], from_source)).transpose(); };
        const Vector3d normal = (point(1) - point(0)).cross(point(2) - point(0));
        const bool is_long = std::ssize(polygon) > k_searched;
        for (const auto& [a, b, c] : is_long ? zipped(polygon, longest_side(corner, from_source, vertices), normal) : widest_triangulation(polygon, normal)) {
            out_.made_corners.push_back({origins[a], origins[b], origins[c]});
            append({vertices[a], vertices[b], vertices[c]}, from_source, t, static_cast<int>(out_.made_corners.size()) - 1);
        }
    }

    /// Where the side with most insertions begins and ends among the corners of the cut triangle.
    [[nodiscard]] std::pair<int, int> longest_side(const std::array<int, 3>& corner, bool from_source, const std::vector<int>& vertices) const {
        std::array<int, 4> at{0, 0, 0, static_cast<int>(vertices.size())};
        for (int c = 1; c < 3; ++c)
            at[c] = static_cast<int>(std::find(vertices.begin() + at[c - 1] + 1, vertices.end(), joined(corner[c], from_source)) - vertices.begin());
        int best = 0;
        for (int c = 1; c < 3; ++c)
            if (at[c + 1] - at[c] > at[best + 1] - at[best]) best = c;
        return {at[best], at[best + 1] % at[3]};
    }

    [[nodiscard]] int joined(int v, bool from_source) const { return from_source ? out_.vertex_of_source[v] : v; }

    void append(const Eigen::RowVector3i& triangle, bool from_source, int part_triangle, int made) {
        triangles_.push_back(triangle);
        out_.from_source.push_back(from_source);
        out_.part_triangle.push_back(part_triangle);
        out_.made.push_back(made);
        out_.is_new.push_back(made >= 0 || !(from_source ? source_ : target_).is_whole[part_triangle]);
    }

    const Part& target_;
    const Part& source_;
    const bool turned_;
    std::span<const LoopMatch> matches_;
    Insertions into_target_, into_source_;
    std::vector<Eigen::RowVector3i> triangles_;
    JoinedMesh out_;
};

} // namespace

std::vector<std::array<int, 3>> widest_triangulation(const std::vector<Vector3d>& polygon, const Vector3d& normal) {
    const int n = static_cast<int>(polygon.size());
    // Klincsek's dynamic programme: best[i][j] is the worth of the polygon i … j, cut at split[i][j].
    std::vector<double> best(static_cast<std::size_t>(n * n), std::numeric_limits<double>::infinity());
    std::vector<int> split(static_cast<std::size_t>(n * n), -1);
    for (int span = 2; span < n; ++span)
        for (int i = 0; i + span < n; ++i) {
            const int j = i + span;
            double most = -std::numeric_limits<double>::infinity();
            for (int k = i + 1; k < j; ++k) {
                const double value = std::min({best[i * n + k], best[k * n + j], worth(polygon[i], polygon[k], polygon[j], normal)});
                if (split[i * n + j] < 0 || value > most + k_tie) {
                    most = value;
                    split[i * n + j] = k;
                }
            }
            best[i * n + j] = most;
        }
    return triangles_of_splits(n, [&](int i, int j) { return split[i * n + j]; });
}

std::vector<std::array<int, 3>> zipped(const std::vector<Vector3d>& polygon, std::pair<int, int> side, const Vector3d& normal) {
    const int n = static_cast<int>(polygon.size()), last = (side.second - side.first + n) % n;
    const auto at = [&](int k) { return (side.first + k) % n; };
    const auto value = [&](int a, int b, int c) { return worth(polygon[at(a)], polygon[at(b)], polygon[at(c)], normal); };
    // What is left is near … far. The two meet in the triangle at the side's far end, and never before it: between
    // corners of one straight side there is no area.
    std::vector<std::array<int, 3>> triangles{{at(0), at(1), at(n - 1)}};
    for (int near = 1, far = n - 1; far - near > 1;) {
        const bool may_rise = near < last - 1, may_fall = far > last + 1;
        if (may_rise && (!may_fall || value(near, near + 1, far) >= value(near, far - 1, far) - k_tie)) {
            triangles.push_back({at(near), at(near + 1), at(far)});
            ++near;
        } else {
            triangles.push_back({at(near), at(far - 1), at(far)});
            --far;
        }
    }
    return triangles;
}

JoinedMesh stitch(const Part& target, const Part& source, bool source_turned, const Points& positions, std::span<const LoopMatch> matches) {
    return Stitcher(target, source, source_turned, positions, matches).run();
}

} // namespace lissom
