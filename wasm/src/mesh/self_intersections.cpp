#include "lissom/mesh/self_intersections.h"

#include "lissom/mesh/orient.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace lissom {

using Eigen::AlignedBox3d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Corners = std::array<Vector3d, 3>;

namespace {

/// How far rounding can carry a sum of products of coordinates, as a share of the largest of them; generous.
constexpr double k_rounding = 1e-13;

/// Whether points lie on the outer side of one of a triangle's sides, or on one side of its plane, by more than rounding: then they do not meet it.
/// Tells most of the triangles apart that lie in one plane, where exact signs are slow to find.
template <std::size_t N>
bool clearly_beyond(const std::array<Vector3d, N>& points, const Corners& t) {
    double size = 0; // of the coordinates: what differences are rounded by
    for (const Vector3d& p : points) size = std::max(size, p.cwiseAbs().maxCoeff());
    for (const Vector3d& p : t) size = std::max(size, p.cwiseAbs().maxCoeff());
    const Vector3d normal = (t[1] - t[0]).cross(t[2] - t[0]);
    const auto all_beyond = [&](const Vector3d& outwards, const Vector3d& from) {
        const double least = k_rounding * size * outwards.cwiseAbs().maxCoeff();
        return std::all_of(points.begin(), points.end(), [&](const Vector3d& p) { return outwards.dot(p - from) > least; });
    };
    if (all_beyond(normal, t[0]) || all_beyond(-normal, t[0])) return true;
    for (int k = 0; k < 3; ++k)
        if (all_beyond((t[(k + 1) % 3] - t[k]).cross(normal), t[k])) return true;
    return false;
}

/// Whether both lie in the plane of a triangle but for rounding.
bool in_plane(const Vector3d& p, const Vector3d& q, const Corners& t) {
    const Vector3d normal = (t[1] - t[0]).cross(t[2] - t[0]);
    const double size = std::max({p.cwiseAbs().maxCoeff(), q.cwiseAbs().maxCoeff(), t[0].cwiseAbs().maxCoeff()});
    return std::max(std::abs(normal.dot(p - t[0])), std::abs(normal.dot(q - t[0]))) <= k_rounding * size * normal.cwiseAbs().maxCoeff();
}

bool segments_meet(const Vector2d& a, const Vector2d& b, const Vector2d& c, const Vector2d& d) {
    const int abc = orient2d(a, b, c), abd = orient2d(a, b, d), cda = orient2d(c, d, a), cdb = orient2d(c, d, b);
    if (abc * abd < 0 && cda * cdb < 0) return true;
    const auto within = [](const Vector2d& p, const Vector2d& q, const Vector2d& x) { // x on the line through p and q
        return x.x() >= std::min(p.x(), q.x()) && x.x() <= std::max(p.x(), q.x()) && x.y() >= std::min(p.y(), q.y()) && x.y() <= std::max(p.y(), q.y());
    };
    return (abc == 0 && within(a, b, c)) || (abd == 0 && within(a, b, d)) || (cda == 0 && within(c, d, a)) || (cdb == 0 && within(c, d, b));
}

bool inside(const std::array<Vector2d, 3>& t, const Vector2d& p) {
    const int s0 = orient2d(t[0], t[1], p), s1 = orient2d(t[1], t[2], p), s2 = orient2d(t[2], t[0], p);
    return (s0 >= 0 && s1 >= 0 && s2 >= 0) || (s0 <= 0 && s1 <= 0 && s2 <= 0);
}

/// Points of one plane, seen along the axis that a triangle in it faces most.
template <std::size_t N>
std::array<Vector2d, N> flattened(const std::array<Vector3d, N>& points, int axis) {
    std::array<Vector2d, N> result;
    for (std::size_t k = 0; k < N; ++k) result[k] = {points[k][(axis + 1) % 3], points[k][(axis + 2) % 3]};
    return result;
}

int facing_axis(const Vector3d& normal) {
    int axis = 0;
    normal.cwiseAbs().maxCoeff(&axis);
    return axis;
}

bool meet_in_plane(const Corners& a, const Corners& b) {
    const int axis = facing_axis((a[1] - a[0]).cross(a[2] - a[0]).cwiseAbs() + (b[1] - b[0]).cross(b[2] - b[0]).cwiseAbs());
    const auto p = flattened(a, axis), q = flattened(b, axis);
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            if (segments_meet(p[i], p[(i + 1) % 3], q[j], q[(j + 1) % 3])) return true;
    return inside(p, q[0]) || inside(q, p[0]);
}

/// Of an edge that lies in the plane of a triangle.
bool meets_in_plane(const std::array<Vector3d, 2>& edge, const Corners& b) {
    const int axis = facing_axis((b[1] - b[0]).cross(b[2] - b[0]));
    const auto p = flattened(edge, axis);
    const auto q = flattened(b, axis);
    for (int j = 0; j < 3; ++j)
        if (segments_meet(p[0], p[1], q[j], q[(j + 1) % 3])) return true;
    return inside(q, p[0]);
}

/// Whether the segment from p to q, which lie on different sides of b's plane or one of them in it, meets `b`.
bool segment_meets(const Vector3d& p, const Vector3d& q, const Corners& b) {
    const int s0 = orient3d(p, q, b[0], b[1]), s1 = orient3d(p, q, b[1], b[2]), s2 = orient3d(p, q, b[2], b[0]);
    return (s0 >= 0 && s1 >= 0 && s2 >= 0) || (s0 <= 0 && s1 <= 0 && s2 <= 0);
}

/// Whether an edge of `a`, on whose sides of b's plane its corners lie as given, meets `b`. Edges in the plane are left to meet_in_plane.
bool edge_meets(const Corners& a, const std::array<int, 3>& side, const Corners& b) {
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3;
        if (side[i] * side[j] > 0 || (side[i] == 0 && side[j] == 0)) continue;
        if (segment_meets(a[i], a[j], b)) return true;
    }
    return false;
}

/// Of triangles with the corner `i` of `a` in common: whether the side of `a` opposite it goes through `b`.
bool opposite_side_meets(const Corners& a, int i, const Corners& b) {
    const Vector3d &p = a[(i + 1) % 3], &q = a[(i + 2) % 3];
    if (clearly_beyond(std::array{p, q}, b) || in_plane(p, q, b)) return false;
    const int sp = orient3d(b[0], b[1], b[2], p), sq = orient3d(b[0], b[1], b[2], q);
    return sp * sq <= 0 && (sp != 0 || sq != 0) && segment_meets(p, q, b);
}

struct Node {
    AlignedBox3d box;
    int first, last;          ///< of the triangles in order, [first, last)
    int left = -1, right = -1; ///< −1: a leaf
    bool chosen = true;        ///< holds a triangle that is asked about
};

constexpr int k_leaf = 4;

class Tree {
public:
    explicit Tree(const TriangleMesh& mesh) : boxes_(static_cast<std::size_t>(mesh.triangle_count())), chosen_(boxes_.size(), 1) {
        for (int t = 0; t < mesh.triangle_count(); ++t) {
            const auto row = mesh.triangles.row(t);
            box(mesh.triangles, mesh.points, t);
            if (boxes_[t].min().allFinite() && boxes_[t].max().allFinite() && row[0] != row[1] && row[1] != row[2] && row[2] != row[0]) order_.push_back(t);
        }
        if (!order_.empty()) build(0, static_cast<int>(order_.size()));
    }

    /// Boxes where the points are now.
    void follow(const Triangles& triangles, const Points& points) {
        for (const int t : order_) box(triangles, points, t);
        each_node_up([&](Node& node, const Node* left, const Node* right) {
            node.box = AlignedBox3d();
            if (left) node.box = left->box.merged(right->box);
            else
                for (int k = node.first; k < node.last; ++k) node.box.extend(boxes_[order_[k]]);
        });
    }

    /// From now on only pairs with at least one of these; none: with any.
    void choose(const std::span<const int>* triangles) {
        std::fill(chosen_.begin(), chosen_.end(), triangles ? 0 : 1);
        if (triangles)
            for (const int t : *triangles) chosen_[t] = 1;
        each_node_up([&](Node& node, const Node* left, const Node* right) {
            node.chosen = left ? left->chosen || right->chosen : std::any_of(order_.begin() + node.first, order_.begin() + node.last, [&](int t) { return chosen_[t] != 0; });
        });
    }

    /// Calls `meet` for every pair whose boxes overlap, once.
    template <class Meet>
    void pairs(Meet meet) const {
        if (nodes_.empty()) return;
        std::vector<std::pair<int, int>> open{{0, 0}};
        while (!open.empty()) {
            const auto [i, j] = open.back();
            open.pop_back();
            const Node &a = nodes_[i], &b = nodes_[j];
            if (!a.chosen && !b.chosen) continue;
            if (i != j && !a.box.intersects(b.box)) continue;
            if (a.left < 0 && b.left < 0) {
                for (int p = a.first; p < a.last; ++p)
                    for (int q = i == j ? p + 1 : b.first; q < b.last; ++q)
                        if ((chosen_[order_[p]] || chosen_[order_[q]]) && boxes_[order_[p]].intersects(boxes_[order_[q]])) meet(order_[p], order_[q]);
            } else if (i == j) {
                open.insert(open.end(), {{a.left, a.left}, {a.right, a.right}, {a.left, a.right}});
            } else if (b.left < 0 || (a.left >= 0 && a.last - a.first >= b.last - b.first)) {
                open.insert(open.end(), {{a.left, j}, {a.right, j}});
            } else open.insert(open.end(), {{i, b.left}, {i, b.right}});
        }
    }

private:
    void box(const Triangles& triangles, const Points& points, int t) {
        boxes_[t] = AlignedBox3d();
        for (int k = 0; k < 3; ++k) boxes_[t].extend(points.row(triangles(t, k)).transpose());
    }

    /// Calls `visit(node, left, right)` from the leaves up; leaves have no two children. Children stand after their parents.
    template <class Visit>
    void each_node_up(Visit visit) {
        for (auto node = nodes_.rbegin(); node != nodes_.rend(); ++node)
            visit(*node, node->left < 0 ? nullptr : &nodes_[node->left], node->left < 0 ? nullptr : &nodes_[node->right]);
    }

    int build(int first, int last) {
        const int here = static_cast<int>(nodes_.size());
        nodes_.push_back({{}, first, last});
        AlignedBox3d around;
        for (int k = first; k < last; ++k) around.extend(boxes_[order_[k]]);
        nodes_[here].box = around;
        if (last - first <= k_leaf) return here;
        int axis = 0;
        around.sizes().maxCoeff(&axis);
        const int middle = (first + last) / 2;
        std::nth_element(order_.begin() + first, order_.begin() + middle, order_.begin() + last, [&](int p, int q) {
            const double a = boxes_[p].min()[axis] + boxes_[p].max()[axis], b = boxes_[q].min()[axis] + boxes_[q].max()[axis];
            return a != b ? a < b : p < q;
        });
        const int left = build(first, middle), right = build(middle, last);
        nodes_[here].left = left;
        nodes_[here].right = right;
        return here;
    }

    std::vector<AlignedBox3d> boxes_;
    std::vector<char> chosen_;
    std::vector<int> order_;
    std::vector<Node> nodes_;
};

Corners corners(const Triangles& triangles, const Points& points, int t) {
    Corners all;
    for (int k = 0; k < 3; ++k) all[k] = points.row(triangles(t, k)).transpose();
    return all;
}

} // namespace

bool triangles_meet(const Corners& a, const Corners& b) {
    if (clearly_beyond(a, b) || clearly_beyond(b, a)) return false;
    std::array<int, 3> of_a, of_b;
    for (int k = 0; k < 3; ++k) of_a[k] = orient3d(b[0], b[1], b[2], a[k]);
    const auto alike = [](const std::array<int, 3>& side) { return side[0] == side[1] && side[1] == side[2]; };
    if (alike(of_a) && of_a[0] != 0) return false;
    for (int k = 0; k < 3; ++k) of_b[k] = orient3d(a[0], a[1], a[2], b[k]);
    if (alike(of_b) && of_b[0] != 0) return false;
    // A triangle without area has every other in its plane: only both together say that they share one.
    if (alike(of_a) && alike(of_b)) return meet_in_plane(a, b);
    if (edge_meets(a, of_a, b) || edge_meets(b, of_b, a)) return true;
    // An edge of one that lies in the plane of the other.
    const auto edge_in_plane = [](const Corners& t, const std::array<int, 3>& side, const Corners& other) {
        for (int i = 0; i < 3; ++i)
            if (side[i] == 0 && side[(i + 1) % 3] == 0 && meets_in_plane({t[i], t[(i + 1) % 3]}, other)) return true;
        return false;
    };
    return edge_in_plane(a, of_a, b) || edge_in_plane(b, of_b, a);
}

struct IntersectionFinder::State {
    Triangles triangles;
    bool neighbours;
    Tree tree;

    [[nodiscard]] bool meet(const Points& points, int p, int q) const {
        int common = 0, of_p = 0, of_q = 0;
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
                if (triangles(p, i) == triangles(q, j)) {
                    ++common;
                    of_p = i;
                    of_q = j;
                }
        if (common == 0) return triangles_meet(corners(triangles, points, p), corners(triangles, points, q));
        if (common > 1 || !neighbours) return false;
        const Corners a = corners(triangles, points, p), b = corners(triangles, points, q);
        return opposite_side_meets(a, of_p, b) || opposite_side_meets(b, of_q, a);
    }

    [[nodiscard]] SelfIntersections found(const Points& points) const {
        SelfIntersections result;
        tree.pairs([&](int p, int q) {
            if (!meet(points, p, q)) return;
            ++result.pairs;
            result.triangles.insert(result.triangles.end(), {p, q});
        });
        std::sort(result.triangles.begin(), result.triangles.end());
        result.triangles.erase(std::unique(result.triangles.begin(), result.triangles.end()), result.triangles.end());
        return result;
    }
};

IntersectionFinder::IntersectionFinder(const TriangleMesh& mesh, Neighbours neighbours)
    : state_(new State{mesh.triangles, neighbours == Neighbours::looked_at, Tree(mesh)}) {}
IntersectionFinder::~IntersectionFinder() = default;
IntersectionFinder::IntersectionFinder(IntersectionFinder&&) noexcept = default;
IntersectionFinder& IntersectionFinder::operator=(IntersectionFinder&&) noexcept = default;

SelfIntersections IntersectionFinder::find(const Points& points) {
    state_->tree.follow(state_->triangles, points);
    state_->tree.choose(nullptr);
    return state_->found(points);
}

SelfIntersections IntersectionFinder::find(const Points& points, std::span<const int> triangles) {
    state_->tree.follow(state_->triangles, points);
    state_->tree.choose(&triangles);
    return state_->found(points);
}

SelfIntersections self_intersections(const TriangleMesh& mesh) { return IntersectionFinder(mesh).find(mesh.points); }

} // namespace lissom
