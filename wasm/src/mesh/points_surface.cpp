#include "lissom/mesh/points_surface.h"

#include "lissom/mesh/orientation.h"
#include "lissom/mesh/point_tree.h"
#include "lissom/mesh/topology.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <unordered_map>
#include <utility>
#include <vector>

namespace lissom {

using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

/// Neighbours that are looked at: on an even surface six touch a point, and uneven samples have twice as many in between.
constexpr int k_neighbours = 18;
/// A neighbour farther away than so many times the usual one is beyond a border.
constexpr double k_farthest = 3;
/// Seen along the plane, a neighbour has at least this much of its distance.
constexpr double k_aside = 0.3;
/// A fan open by more than this has a border there.
constexpr double k_widest = 0.8 * std::numbers::pi;
/// How much longer some directions count than others. Points in rows have no preferred diagonal, and on a curved surface the planes
/// of their corners do not agree by a few hundredths: this decides for all of them.
constexpr double k_bias = 0.04;

/// Height per longest side below which a triangle is a line.
constexpr double k_flat = 1e-3;
/// Cosine between two faces over one edge, seen along it, above which they lie on one another: under 70 degrees.
constexpr double k_folded = 0.34;

using Corners = std::array<int, 3>;

/// The first point in each place, ascending.
std::vector<int> places(const Points& points) {
    std::vector<int> order(points.rows());
    std::iota(order.begin(), order.end(), 0);
    const auto key = [&](int v) { return std::array{points(v, 0), points(v, 1), points(v, 2)}; };
    std::sort(order.begin(), order.end(), [&](int a, int b) { return key(a) != key(b) ? key(a) < key(b) : a < b; });
    std::vector<int> first;
    for (std::size_t i = 0; i < order.size(); ++i)
        if (i == 0 || key(order[i]) != key(order[i - 1])) first.push_back(order[i]);
    std::sort(first.begin(), first.end());
    return first;
}

/// A corner of a cell, and whose side begins there.
struct CellCorner {
    Vector2d place;
    int side; ///< −1: nobody's
};

/// Cuts off what lies beyond n · x = d. @param whose  the side that the cut makes
void cut(std::vector<CellCorner>& cell, const Vector2d& n, double d, int whose, std::vector<CellCorner>& out) {
    out.clear();
    for (std::size_t i = 0; i < cell.size(); ++i) {
        const CellCorner &a = cell[i], &b = cell[(i + 1) % cell.size()];
        const double x = n.dot(a.place) - d, y = n.dot(b.place) - d;
        if (x <= 0) out.push_back(a);
        if ((x <= 0) == (y <= 0)) continue;
        const Vector2d met = a.place + x / (x - y) * (b.place - a.place);
        out.push_back({met, x <= 0 ? whose : a.side});
    }
    cell.swap(out);
}

/// Fans around every point, one after the other.
class Fans {
public:
    explicit Fans(const Points& points) : points_(points), tree_(points) {
        // Seen along the cloud's own axes, so that it does not matter how the cloud stands.
        const Eigen::RowVector3d mean = points.colwise().mean();
        const Points arms = points.rowwise() - mean;
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes;
        const double size = arms.rowwise().norm().maxCoeff();
        axes.computeDirect(Eigen::Matrix3d(arms.transpose() * arms / (size * size)));
        Eigen::Matrix3d frame = axes.eigenvectors();
        for (int k = 0; k < 3; ++k)
            if ((arms * frame.col(k) / size).array().cube().sum() < 0) frame.col(k) *= -1;
        one_ = frame * Vector3d(0.839, 0.421, 0.345);
        other_ = frame * Vector3d(-0.281, 0.877, 0.390);
    }

    /// Triangles that have point v as their first corner, in turn about it.
    void around(int v, std::vector<Corners>& fan) {
        fan.clear();
        const Vector3d place = points_.row(v);
        tree_.nearest(place, k_neighbours + 1, found_);
        std::erase_if(found_, [v](const auto& each) { return each.first == v; });
        if (found_.size() < 2) return;
        lay_flat(place);
        const double reach = std::sqrt(found_.back().second);
        cell_ = {{{-reach, -reach}, -1}, {{reach, -reach}, -1}, {{reach, reach}, -1}, {{-reach, reach}, -1}};
        for (std::size_t i = 0; i < found_.size(); ++i) {
            const double length = flat_[i].norm();
            if (length == 0) continue;
            // Its side of the line between the two, in a metric that counts some directions longer.
            const Vector3d arm = Vector3d(points_.row(found_[i].first)) - place;
            const double d = (length * length + k_bias * one_.dot(arm) * other_.dot(arm)) / (2 * length);
            cut(cell_, flat_[i] / length, d, static_cast<int>(i), spare_);
        }
        std::vector<int>& sides = sides_;
        sides.clear();
        for (std::size_t i = 0; i < cell_.size(); ++i)
            if (const int side = cell_[i].side; sides.empty() || sides.back() != side) sides.push_back(side);
        if (sides.size() > 1 && sides.front() == sides.back()) sides.pop_back();
        const double far = k_farthest * usual(sides);
        for (std::size_t i = 0; i < sides.size() && sides.size() > 1; ++i) {
            const int a = sides[i], b = sides[(i + 1) % sides.size()];
            if (a < 0 || b < 0 || flat_[a].norm() > far || flat_[b].norm() > far) continue;
            const double turn = std::atan2(flat_[a].x() * flat_[b].y() - flat_[a].y() * flat_[b].x(), flat_[a].dot(flat_[b]));
            if (turn > 0 && turn < k_widest) fan.push_back({v, found_[a].first, found_[b].first});
        }
    }

private:
    /// Neighbours in the plane that fits them best, seen from the point; those above or below it are of another sheet.
    void lay_flat(const Vector3d& place) {
        Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
        Vector3d mean = Vector3d::Zero();
        const auto arm = [&](std::size_t i) -> Vector3d { return Vector3d(points_.row(found_[i].first)) - place; };
        for (std::size_t i = 0; i < found_.size(); ++i) mean += arm(i) / static_cast<double>(found_.size() + 1);
        const double scale = found_.back().second;
        spread += mean * mean.transpose() / scale;
        for (std::size_t i = 0; i < found_.size(); ++i) spread += (arm(i) - mean) * (arm(i) - mean).transpose() / scale;
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes;
        axes.computeDirect(spread);
        const Vector3d x = axes.eigenvectors().col(2), y = axes.eigenvectors().col(1);
        flat_.resize(found_.size());
        for (std::size_t i = 0; i < found_.size(); ++i) {
            const Vector2d seen(arm(i).dot(x), arm(i).dot(y));
            flat_[i] = seen.squaredNorm() < k_aside * k_aside * found_[i].second ? Vector2d::Zero() : seen;
        }
    }

    /// The median distance of those whose cells touch.
    [[nodiscard]] double usual(const std::vector<int>& sides) {
        lengths_.clear();
        for (const int side : sides)
            if (side >= 0) lengths_.push_back(flat_[side].norm());
        if (lengths_.empty()) return 0;
        std::nth_element(lengths_.begin(), lengths_.begin() + std::ssize(lengths_) / 2, lengths_.end());
        return lengths_[lengths_.size() / 2];
    }

    const Points& points_;
    PointTree tree_;
    Vector3d one_, other_;
    std::vector<std::pair<int, double>> found_;
    std::vector<Vector2d> flat_;
    std::vector<CellCorner> cell_, spare_;
    std::vector<int> sides_;
    std::vector<double> lengths_;
};

/// Faces over points that grow one by one.
class Growing {
public:
    explicit Growing(const Points& points) : points_(points) { faces_.reserve(3 * static_cast<std::size_t>(points.rows())); }

    /// Takes a triangle unless an edge has two faces, or one that lies on the same side.
    void offer(const Corners& c) {
        const std::array<Corners, 3> sides{{{c[0], c[1], c[2]}, {c[1], c[2], c[0]}, {c[0], c[2], c[1]}}}; // an edge and who is opposite
        for (const auto& [a, b, opposite] : sides) {
            const auto at = faces_.find(edge(a, b));
            if (at == faces_.end()) continue;
            if (at->second.second >= 0 || covers(a, b, at->second.first, opposite)) return;
        }
        for (const auto& [a, b, opposite] : sides) {
            const auto [at, fresh] = faces_.try_emplace(edge(a, b), opposite, -1);
            if (!fresh) at->second.second = opposite;
        }
        taken_.push_back(c);
    }

    [[nodiscard]] std::vector<Corners> taken() && { return std::move(taken_); }

private:
    static std::int64_t edge(int a, int b) { return static_cast<std::int64_t>(a) << 32 | b; }

    /// Whether two triangles over one edge lie on one another rather than side by side.
    [[nodiscard]] bool covers(int a, int b, int one, int other) const {
        const Vector3d along = Vector3d(points_.row(b) - points_.row(a)).normalized();
        const auto across = [&](int v) -> Vector3d {
            const Vector3d arm = points_.row(v) - points_.row(a);
            return (arm - arm.dot(along) * along).normalized();
        };
        return across(one).dot(across(other)) > k_folded;
    }

    const Points& points_;
    std::unordered_map<std::int64_t, std::pair<int, int>> faces_; ///< who is opposite each edge
    std::vector<Corners> taken_;
};

/// A triangle that some of its corners want.
struct Wish {
    Corners corners; ///< ascending
    int votes;
    double shape; ///< smallest height per longest side
};

double shape_of(const Points& points, const Corners& c) {
    const auto p = [&](int k) -> Vector3d { return points.row(c[k]); };
    const Vector3d a = p(1) - p(0), b = p(2) - p(0);
    const double longest = std::max({a.squaredNorm(), b.squaredNorm(), (b - a).squaredNorm()});
    return longest > 0 ? a.cross(b).norm() / longest : 0;
}

std::vector<Wish> wishes(const Points& points) {
    Fans fans(points);
    std::vector<Corners> all, fan;
    for (int v = 0; v < points.rows(); ++v) {
        fans.around(v, fan);
        for (Corners& c : fan) {
            std::sort(c.begin(), c.end());
            all.push_back(c);
        }
    }
    std::sort(all.begin(), all.end());
    std::vector<Wish> wished;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (i > 0 && all[i] == all[i - 1]) ++wished.back().votes;
        else wished.push_back({all[i], 1, shape_of(points, all[i])});
    }
    std::erase_if(wished, [](const Wish& w) { return !(w.shape > k_flat); });
    std::sort(wished.begin(), wished.end(), [](const Wish& a, const Wish& b) {
        if (a.votes != b.votes) return a.votes > b.votes;
        return a.shape != b.shape ? a.shape > b.shape : a.corners < b.corners;
    });
    return wished;
}

/// Lets neighbours agree, and each piece enclose more than nothing.
void face_outwards(TriangleMesh& mesh) {
    const Orientation facing = orient(mesh);
    for (int t = 0; t < mesh.triangle_count(); ++t)
        if (facing.turned[t]) std::swap(mesh.triangles(t, 1), mesh.triangles(t, 2));
    const Components parts = components(vertex_rings(mesh));
    std::vector<Vector3d> middle(parts.count, Vector3d::Zero());
    std::vector<double> count(parts.count, 0), volume(parts.count, 0);
    for (int v = 0; v < mesh.vertex_count(); ++v) {
        middle[parts.of_vertex[v]] += Vector3d(mesh.points.row(v));
        ++count[parts.of_vertex[v]];
    }
    for (int c = 0; c < parts.count; ++c) middle[c] /= count[c];
    const auto part_of = [&](int t) { return parts.of_vertex[mesh.triangles(t, 0)]; };
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        const auto arm = [&](int k) -> Vector3d { return Vector3d(mesh.points.row(mesh.triangles(t, k))) - middle[part_of(t)]; };
        volume[part_of(t)] += arm(0).dot(arm(1).cross(arm(2)));
    }
    for (int t = 0; t < mesh.triangle_count(); ++t)
        if (volume[part_of(t)] < 0) std::swap(mesh.triangles(t, 1), mesh.triangles(t, 2));
}

} // namespace

Triangles surface_through(const Points& points) {
    const std::vector<int> first = places(points);
    if (first.size() < 3) return {};
    Points apart(std::ssize(first), 3);
    for (std::size_t i = 0; i < first.size(); ++i) apart.row(static_cast<Eigen::Index>(i)) = points.row(first[i]);

    Growing growing(apart);
    for (const Wish& wish : wishes(apart)) growing.offer(wish.corners);
    std::vector<Corners> taken = std::move(growing).taken();
    std::sort(taken.begin(), taken.end());
    TriangleMesh mesh{std::move(apart), Triangles(std::ssize(taken), 3)};
    for (std::size_t t = 0; t < taken.size(); ++t)
        for (int k = 0; k < 3; ++k) mesh.triangles(static_cast<Eigen::Index>(t), k) = taken[t][k];
    face_outwards(mesh);
    return mesh.triangles.unaryExpr([&](int v) { return first[v]; });
}

} // namespace lissom
