#include "lissom/mesh/triangulate.h"

#include "ear_clipping.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <span>

namespace lissom {

namespace {

using Triangle = std::array<int, 3>; // places in a polygon

/// Twice the area vector of a closed polygon (Newell): its length is twice the area of the best-fit projection.
Eigen::Vector3d newell(std::span<const Eigen::Vector3d> corners) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < corners.size(); ++i)
        sum += (corners[i] - corners[0]).cross(corners[(i + 1) % corners.size()] - corners[0]);
    return sum;
}

/// The smaller of the areas that two triangles show along the normal; negative where one is turned over.
double worse_half(std::span<const Eigen::Vector3d> p, const Triangle& s, const Triangle& t) {
    const Eigen::Vector3d normal = newell(p);
    const auto shown = [&](const Triangle& c) { return (p[c[1]] - p[c[0]]).cross(p[c[2]] - p[c[0]]).dot(normal); };
    return std::min(shown(s), shown(t));
}

std::vector<Triangle> split_quad(std::span<const Eigen::Vector3d> p) {
    const std::vector<Triangle> along_02{{0, 1, 2}, {0, 2, 3}}, along_13{{0, 1, 3}, {1, 2, 3}};
    const double inside_02 = worse_half(p, along_02[0], along_02[1]), inside_13 = worse_half(p, along_13[0], along_13[1]);
    const double tiny = 1e-12 * newell(p).squaredNorm();
    if ((inside_02 > tiny) != (inside_13 > tiny))
        return inside_02 > tiny ? along_02 : along_13;
    const double length_02 = (p[2] - p[0]).squaredNorm(), length_13 = (p[3] - p[1]).squaredNorm();
    return length_13 < length_02 * (1 - 1e-9) ? along_13 : along_02; // a square's diagonals differ by rounding
}

std::vector<Triangle> fan(int corner_count) {
    std::vector<Triangle> triangles;
    for (int i = 1; i + 1 < corner_count; ++i)
        triangles.push_back({0, i, i + 1});
    return triangles;
}

std::vector<Triangle> split_polygon(std::span<const Eigen::Vector3d> p) {
    if (p.size() == 4)
        return split_quad(p);
    const Eigen::Vector3d normal = newell(p);
    double perimeter = 0;
    for (std::size_t i = 0; i < p.size(); ++i)
        perimeter += (p[(i + 1) % p.size()] - p[i]).norm();
    if (normal.norm() <= 1e-12 * perimeter * perimeter) // on one line, or a figure of eight: there is no inside
        return fan(static_cast<int>(p.size()));

    const Eigen::Vector3d w = normal.normalized();
    const Eigen::Vector3d u = w.unitOrthogonal(), v = w.cross(u);
    std::vector<Eigen::Vector2d> flat;
    for (const Eigen::Vector3d& corner : p)
        flat.emplace_back(u.dot(corner - p[0]), v.dot(corner - p[0]));
    return clip_ears(flat);
}

/// Triangles of one polygon in vertex indices, without any that uses a vertex twice.
std::vector<Triangle> triangles_of(const std::vector<int>& polygon, const Points& points) {
    std::vector<Eigen::Vector3d> corners;
    for (const int v : polygon)
        corners.emplace_back(points.row(v));
    std::vector<Triangle> found = corners.size() == 3 ? fan(3) : split_polygon(corners);
    for (Triangle& t : found)
        for (int& corner : t)
            corner = polygon[corner];
    std::erase_if(found, [](const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; });
    return found;
}

/// The corners without those that repeat the one before.
std::vector<int> without_stutter(std::span<const int> corners) {
    std::vector<int> polygon;
    for (const int v : corners)
        if (polygon.empty() || polygon.back() != v)
            polygon.push_back(v);
    while (polygon.size() > 1 && polygon.back() == polygon.front())
        polygon.pop_back();
    return polygon;
}

/// The corners, each vertex once, at its first place.
std::vector<int> first_visits(std::span<const int> corners) {
    std::vector<int> order(corners.size()), polygon;
    for (std::size_t i = 0; i < order.size(); ++i)
        order[i] = static_cast<int>(i);
    std::sort(order.begin(), order.end(),
              [&](int i, int j) { return corners[i] != corners[j] ? corners[i] < corners[j] : i < j; });
    order.erase(std::unique(order.begin(), order.end(), [&](int i, int j) { return corners[i] == corners[j]; }),
                order.end());
    std::sort(order.begin(), order.end());
    for (const int i : order)
        polygon.push_back(corners[i]);
    return polygon;
}

std::span<const int> corners_of(const PolygonMesh& source, int face) {
    return {source.corners.data() + source.offsets[face], source.corners.data() + source.offsets[face + 1]};
}

} // namespace

std::vector<bool> finite_vertices(const Points& points) {
    std::vector<bool> finite(points.rows());
    for (int v = 0; v < points.rows(); ++v)
        finite[v] = std::abs(points(v, 0)) < 1e100 && std::abs(points(v, 1)) < 1e100 && std::abs(points(v, 2)) < 1e100;
    return finite;
}

FaceVerdict face_verdict(const PolygonMesh& source, int face, const std::vector<bool>& finite) {
    const std::span<const int> corners = corners_of(source, face);
    for (const int v : corners)
        if (v < 0 || v >= source.vertex_count())
            return FaceVerdict::out_of_range;
    for (const int v : corners)
        if (!finite[v])
            return FaceVerdict::not_finite;
    int other = -1; // a corner unlike the first
    for (const int v : corners) {
        if (other < 0 && v != corners[0])
            other = v;
        else if (other >= 0 && v != corners[0] && v != other)
            return FaceVerdict::usable;
    }
    return FaceVerdict::too_small;
}

Triangulation triangulate(const PolygonMesh& source) {
    const std::vector<bool> finite = finite_vertices(source.points);
    std::vector<Triangle> all;
    Triangulation result;
    const auto add = [&](int face, const Triangle& t) {
        all.push_back(t);
        result.polygon_of_triangle.push_back(face);
    };
    for (int f = 0; f < source.face_count(); ++f) {
        if (face_verdict(source, f, finite) != FaceVerdict::usable)
            continue;
        const std::span<const int> corners = corners_of(source, f);
        if (corners.size() == 3) {
            add(f, {corners[0], corners[1], corners[2]});
            continue;
        }
        std::vector<Triangle> found = triangles_of(without_stutter(corners), source.points);
        const std::vector<int> different = first_visits(corners);
        if (found.size() + 2 < different.size()) // spikes that run out and back ate too many
            found = triangles_of(different, source.points);
        for (const Triangle& t : found)
            add(f, t);
    }
    result.triangles.resize(static_cast<int>(all.size()), 3);
    for (std::size_t t = 0; t < all.size(); ++t)
        for (int k = 0; k < 3; ++k)
            result.triangles(static_cast<int>(t), k) = all[t][k];
    return result;
}

} // namespace lissom
