#include "lissom/wear/measures.h"

#include "lissom/mesh/errors.h"
#include "lissom/mesh/half_edges.h"

#include <Eigen/SVD>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string>

namespace lissom {

using Eigen::RowVector3d;
using Eigen::Vector3d;

namespace {

/// Places of a line in order around its convex hull, seen along the direction in which they vary least (Andrew 1979).
std::vector<int> hull_of(const std::vector<Vector3d>& line) {
    Points rows(std::ssize(line), 3);
    for (std::size_t k = 0; k < line.size(); ++k) rows.row(static_cast<Eigen::Index>(k)) = line[k].transpose();
    const RowVector3d middle = rows.colwise().mean();
    rows.rowwise() -= middle;
    const Eigen::JacobiSVD<Eigen::Matrix3d> axes(rows.transpose() * rows, Eigen::ComputeFullU);
    const Eigen::Matrix<double, Eigen::Dynamic, 2> flat = rows * axes.matrixU().leftCols(2);
    std::vector<int> order(line.size()), hull;
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](int a, int b) { return std::pair(flat(a, 0), flat(a, 1)) < std::pair(flat(b, 0), flat(b, 1)); });
    const auto left = [&](int a, int b, int c) {
        return (flat(b, 0) - flat(a, 0)) * (flat(c, 1) - flat(a, 1)) - (flat(b, 1) - flat(a, 1)) * (flat(c, 0) - flat(a, 0)) > 0;
    };
    for (int pass = 0; pass < 2; ++pass, std::reverse(order.begin(), order.end())) {
        const std::size_t start = hull.size();
        for (const int c : order) {
            while (hull.size() >= start + 2 && !left(hull[hull.size() - 2], hull.back(), c)) hull.pop_back();
            hull.push_back(c);
        }
        hull.pop_back(); // the last of one half is the first of the other
    }
    return hull;
}

std::string place(int number) { return "measures[" + std::to_string(number) + "]: "; }

} // namespace

Measurer::Measurer(const Triangles& triangles, int vertex_count)
    : triangles_(triangles), vertex_count_(vertex_count), beyond_(static_cast<std::size_t>(triangles.size()), -1), around_(static_cast<std::size_t>(vertex_count)) {
    const std::vector<HalfEdge> sides = half_edges({Points(vertex_count, 3), triangles});
    for_each_edge(sides, [&](auto first, auto last) {
        if (last - first != 2) return;
        const HalfEdge &a = *first, &b = *(first + 1);
        beyond_[static_cast<std::size_t>(3 * a.triangle + a.corner)] = b.triangle;
        beyond_[static_cast<std::size_t>(3 * b.triangle + b.corner)] = a.triangle;
    });
    for (int t = 0; t < triangles_.rows(); ++t)
        for (int k = 0; k < 3; ++k) around_[triangles_(t, k)].push_back(t);
}

void Measurer::check(const Measure& measure, int number) const {
    const auto in_range = [&](int v) {
        if (v < 0 || v >= vertex_count_)
            throw InvalidInput("vertex-out-of-range", place(number) + "there is no vertex " + std::to_string(v) + "; the skins have " + std::to_string(vertex_count_) + ", numbered from 0.");
    };
    const bool by_plane = measure.kind == Measure::Kind::height || measure.kind == Measure::Kind::section;
    if (by_plane && (!measure.direction.allFinite() || measure.direction.norm() == 0)) throw InvalidInput("bad-measure", place(number) + "the direction is 0; give one.");
    if (measure.kind == Measure::Kind::section) in_range(measure.vertex);
    if (!by_plane) {
        for (const int v : measure.vertices) in_range(v);
        const std::size_t fewest = measure.kind == Measure::Kind::loop ? 3 : 2;
        if (measure.vertices.size() < fewest)
            throw InvalidInput("bad-measure", place(number) + (fewest == 3 ? "a loop closes through three vertices or more." : "a length goes through two vertices or more."));
    }
    if (measure.wanted && !(*measure.wanted > 0 && std::isfinite(*measure.wanted))) throw InvalidInput("bad-measure", place(number) + "what is wanted must be above 0.");
}

/// From triangle to triangle across edges with an end above the plane and one not, from those of the vertex until they meet again.
std::vector<Measurer::Crossing> Measurer::section(const Points& points, const Vector3d& normal, int vertex) const {
    const double offset = points.row(vertex).dot(normal);
    const auto is_above = [&](int v) { return v != vertex && points.row(v).dot(normal) > offset; };
    /// The side by which a triangle is left towards its upper part to the right.
    const auto crossed_side = [&](int t, bool downward) {
        for (int k = 0; k < 3; ++k) {
            const bool a = is_above(triangles_(t, k)), b = is_above(triangles_(t, (k + 1) % 3));
            if (a != b && a == downward) return k;
        }
        return -1;
    };
    for (const int first : around_[vertex]) {
        if (crossed_side(first, true) < 0) continue;
        std::vector<Crossing> found;
        bool downward = true;
        for (int t = first, steps = 0; steps <= triangles_.rows(); ++steps) {
            const int k = crossed_side(t, downward);
            const int a = triangles_(t, k), b = triangles_(t, (k + 1) % 3);
            found.push_back(is_above(a) ? Crossing{a, b} : Crossing{b, a});
            const int next = beyond_[static_cast<std::size_t>(3 * t + k)];
            if (next < 0) return {};
            // Where neighbours do not agree about their sides the walk turns round with them.
            const int back = [&] {
                for (int j = 0; j < 3; ++j) {
                    const int p = triangles_(next, j), q = triangles_(next, (j + 1) % 3);
                    if ((p == b && q == a)) return 1;
                    if ((p == a && q == b)) return 0;
                }
                return 1;
            }();
            if (!back) downward = !downward;
            t = next;
            if (t == first) return found;
        }
    }
    return {};
}

Measured Measurer::measure(const Points& points, const Measure& measure, int number) const {
    Measured found;
    if (measure.kind == Measure::Kind::height) {
        const Vector3d up = measure.direction.normalized();
        int low = -1, high = -1;
        double least = 0, most = 0;
        for (int v = 0; v < vertex_count_; ++v) {
            if (around_[v].empty()) continue;
            const double h = points.row(v).dot(up);
            if (low < 0 || h < least) low = v, least = h;
            if (high < 0 || h > most) high = v, most = h;
        }
        if (low < 0) return found;
        found.value = most - least;
        found.slope = {{high, up.transpose()}, {low, -up.transpose()}};
        found.line = {points.row(low).transpose(), points.row(high).transpose()};
        return found;
    }
    const bool closed = measure.kind != Measure::Kind::path, cut = measure.kind == Measure::Kind::section;
    const Vector3d normal = measure.direction.normalized();
    std::vector<Crossing> crossings;
    std::vector<double> above; // shares of the upper ends
    std::vector<Vector3d> line;
    if (cut) {
        crossings = section(points, normal, measure.vertex);
        if (crossings.size() < 3)
            throw InvalidInput("loop-open", place(number) + "the plane through vertex " + std::to_string(measure.vertex) +
                                                " does not cut the surface in a closed line there. Choose another vertex or direction.");
        const double offset = points.row(measure.vertex).dot(normal);
        for (const auto& [a, b] : crossings) {
            const double ha = points.row(a).dot(normal) - offset, hb = points.row(b).dot(normal) - offset;
            above.push_back(b == measure.vertex ? 0 : hb / (hb - ha));
            line.push_back((points.row(b) + above.back() * (points.row(a) - points.row(b))).transpose());
        }
    } else {
        for (const int v : measure.vertices) line.push_back(points.row(v).transpose());
    }
    std::vector<int> order(line.size());
    std::iota(order.begin(), order.end(), 0);
    if (closed && measure.hull) order = hull_of(line);

    std::vector<Vector3d> pull(line.size(), Vector3d::Zero()); // ∂value/∂place
    const std::size_t count = order.size();
    for (std::size_t k = 0; k + (closed ? 0 : 1) < count; ++k) {
        const int i = order[k], j = order[(k + 1) % count];
        const Vector3d side = line[j] - line[i];
        const double length = side.norm();
        found.value += length;
        if (!(length > 0)) continue;
        pull[j] += side / length;
        pull[i] -= side / length;
    }
    for (const int i : order) found.line.push_back(line[i]);
    for (const int i : order) {
        if (!cut) {
            found.slope.emplace_back(measure.vertices[i], pull[i].transpose());
            continue;
        }
        // p = b + t (a − b) with n·p = n·x_v: as a, b and the plane move, t follows, so that p moves in the plane.
        const auto [a, b] = crossings[i];
        const Vector3d along = (points.row(a) - points.row(b)).transpose();
        const double t = above[i], c = pull[i].dot(along) / normal.dot(along);
        found.slope.emplace_back(a, (t * (pull[i] - c * normal)).transpose());
        found.slope.emplace_back(b, ((1 - t) * (pull[i] - c * normal)).transpose());
        found.slope.emplace_back(measure.vertex, (c * normal).transpose());
    }
    return found;
}

} // namespace lissom
