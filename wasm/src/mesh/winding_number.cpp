#include "lissom/mesh/winding_number.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace lissom {

using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

constexpr int k_leaf = 8;
/// Groups are far when they are this many times their radius away: the error is then below 0.06 on the test shapes; 4 gives 0.016 and takes twice as long.
constexpr double k_far = 2.5;

/// Half the solid angle of a triangle (van Oosterom and Strackee 1983).
double half_angle(Vector3d a, Vector3d b, Vector3d c, const Vector3d& p) {
    a -= p, b -= p, c -= p;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    const double below = la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb, above = a.dot(b.cross(c));
    return above == 0 && below <= 0 ? 0 : std::atan2(above, below);
}

} // namespace

WindingNumber::WindingNumber(const TriangleMesh& mesh) {
    triangles_.reserve(static_cast<std::size_t>(mesh.triangle_count()));
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        const Corners corners{mesh.points.row(mesh.triangles(t, 0)), mesh.points.row(mesh.triangles(t, 1)), mesh.points.row(mesh.triangles(t, 2))};
        if (corners.a.allFinite() && corners.b.allFinite() && corners.c.allFinite()) triangles_.push_back(corners);
    }
    if (!triangles_.empty()) build(0, static_cast<int>(triangles_.size()));
}

int WindingNumber::build(int first, int last) {
    const int at = static_cast<int>(nodes_.size());
    nodes_.emplace_back();
    Node node;
    node.first = first, node.last = last;
    node.dipole.setZero(), node.centre.setZero(), node.moment.setZero();
    Vector3d low = Vector3d::Constant(std::numeric_limits<double>::infinity()), high = -low, plain = Vector3d::Zero();
    double area = 0;
    for (int k = first; k < last; ++k) {
        const auto& [a, b, c] = triangles_[k];
        const Vector3d n = 0.5 * (b - a).cross(c - a), middle = (a + b + c) / 3;
        node.dipole += n;
        node.centre += n.norm() * middle;
        plain += middle;
        area += n.norm();
        low = low.cwiseMin(middle), high = high.cwiseMax(middle);
    }
    node.centre = area > 0 ? Vector3d(node.centre / area) : Vector3d(plain / (last - first));
    for (int k = first; k < last; ++k) {
        const auto& [a, b, c] = triangles_[k];
        node.moment += ((a + b + c) / 3 - node.centre) * (0.5 * (b - a).cross(c - a)).transpose();
        for (const Vector3d& corner : {a, b, c}) node.radius = std::max(node.radius, (corner - node.centre).norm());
    }
    if (last - first > k_leaf) {
        int axis = 0;
        (high - low).maxCoeff(&axis);
        const int middle = (first + last) / 2;
        const auto key = [axis](const Corners& t) { return t.a[axis] + t.b[axis] + t.c[axis]; };
        std::nth_element(triangles_.begin() + first, triangles_.begin() + middle, triangles_.begin() + last, [&](const Corners& x, const Corners& y) { return key(x) < key(y); });
        build(first, middle);
        node.right = build(middle, last);
    }
    nodes_[at] = node;
    return at;
}

double WindingNumber::operator()(const Vector3d& p) const {
    if (nodes_.empty() || !p.allFinite()) return 0;
    double angle = 0; // by 4π
    std::vector<int> open{0};
    while (!open.empty()) {
        const int at = open.back();
        const Node& node = nodes_[at];
        open.pop_back();
        const Vector3d d = node.centre - p;
        const double squared = d.squaredNorm();
        if (squared > k_far * k_far * node.radius * node.radius) {
            // d/|d|³ · N + tr(J M) with J = 1/|d|³ − 3 d dᵀ/|d|⁵, the derivative of d/|d|³ (Barill et al. 2018, Eq 14).
            const double cubed = squared * std::sqrt(squared);
            angle += (d.dot(node.dipole) + node.moment.trace() - 3 * d.dot(node.moment * d) / squared) / cubed;
        } else if (node.right < 0) {
            for (int k = node.first; k < node.last; ++k) angle += 2 * half_angle(triangles_[k].a, triangles_[k].b, triangles_[k].c, p);
        } else {
            open.push_back(node.right);
            open.push_back(at + 1);
        }
    }
    return angle / (4 * std::numbers::pi);
}

double WindingNumber::exact(const Vector3d& p) const {
    double angle = 0;
    if (p.allFinite())
        for (const auto& [a, b, c] : triangles_) angle += 2 * half_angle(a, b, c, p);
    return angle / (4 * std::numbers::pi);
}

} // namespace lissom
