#include "lissom/mesh/working_mesh.h"

#include "welding.h"

#include "lissom/mesh/errors.h"
#include "lissom/mesh/orientation.h"
#include "lissom/mesh/points_surface.h"
#include "lissom/mesh/topology.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <string>
#include <utility>

namespace lissom {

namespace {

constexpr double k_weld_distance = 1e-6; // of the diagonal: coordinates that went through single precision
constexpr double k_no_area = 1e-12;      // height per longest side below which a triangle is a line
constexpr double k_needle = 1e-3;        // the same, below which it is a needle
constexpr double k_far = 1e3;            // diagonals from the origin

/// Collects findings; those that found nothing are not reported.
class Report {
public:
    void add(const char* code, const std::vector<int>& where, bool repaired) {
        if (!where.empty())
            findings_.push_back({code, static_cast<int>(where.size()),
                                 {where.begin(), where.begin() + std::min<std::ptrdiff_t>(std::ssize(where), 8)}, repaired});
    }
    [[nodiscard]] std::vector<Finding> take() { return std::move(findings_); }

private:
    std::vector<Finding> findings_;
};

std::vector<int> where(const std::vector<bool>& flags) {
    std::vector<int> found;
    for (std::size_t i = 0; i < flags.size(); ++i)
        if (flags[i])
            found.push_back(static_cast<int>(i));
    return found;
}

/// Source faces of some working triangles, each once.
std::vector<int> faces_of(const std::vector<int>& triangles, const std::vector<int>& polygon_of_triangle) {
    std::vector<int> faces;
    for (const int t : triangles)
        faces.push_back(polygon_of_triangle[t]);
    std::sort(faces.begin(), faces.end());
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    return faces;
}

void check(const PolygonMesh& source) {
    if (source.vertex_count() == 0)
        throw InvalidInput("no-vertices", "The model has no vertices.");
    if (source.face_count() == 0)
        return;
    if (source.offsets.front() != 0 || source.offsets.back() != std::ssize(source.corners)
        || !std::is_sorted(source.offsets.begin(), source.offsets.end()))
        throw InvalidInput("bad-offsets", "The faces' offsets do not fit their corners.");
}

bool about_points(const Finding& finding) {
    static const std::vector<std::string> codes{"points-only", "non-finite-vertex", "duplicate-vertices", "far-from-origin"};
    return std::find(codes.begin(), codes.end(), finding.code) != codes.end();
}

/// A surface for points without faces: each of its triangles counts as a face of its own.
/// @throws InvalidInput `no-faces` where they make none
Triangulation through_points(const Points& points, const std::vector<bool>& finite) {
    const std::vector<int> sound = where(finite);
    Points kept(std::ssize(sound), 3);
    for (std::size_t i = 0; i < sound.size(); ++i)
        kept.row(static_cast<Eigen::Index>(i)) = points.row(sound[i]);
    Triangulation drawn;
    drawn.triangles = surface_through(kept).unaryExpr([&](int v) { return sound[v]; });
    if (drawn.triangles.rows() == 0)
        throw InvalidInput("no-faces", "The model has no faces, and its points make no surface.");
    drawn.polygon_of_triangle.resize(drawn.triangles.rows());
    std::iota(drawn.polygon_of_triangle.begin(), drawn.polygon_of_triangle.end(), 0);
    return drawn;
}

/// Height per longest side of each triangle; 0 where it is a point.
Eigen::VectorXd slenderness(const TriangleMesh& mesh) {
    Eigen::VectorXd ratios(mesh.triangle_count());
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        const auto p = [&](int k) -> Eigen::Vector3d { return mesh.points.row(mesh.triangles(t, k)); };
        const Eigen::Vector3d a = p(1) - p(0), b = p(2) - p(0);
        const double longest2 = std::max({a.squaredNorm(), b.squaredNorm(), (b - a).squaredNorm()});
        ratios[t] = longest2 > 0 ? a.cross(b).norm() / longest2 : 0;
    }
    return ratios;
}

/// Lists what cannot take part.
void report_unusable(const PolygonMesh& source, const std::vector<bool>& finite, Report& report) {
    std::vector<int> out_of_range, too_small;
    for (int f = 0; f < source.face_count(); ++f) {
        const FaceVerdict verdict = face_verdict(source, f, finite);
        if (verdict == FaceVerdict::out_of_range)
            out_of_range.push_back(f);
        else if (verdict == FaceVerdict::too_small)
            too_small.push_back(f);
    }
    std::vector<bool> not_finite = finite;
    not_finite.flip();
    report.add("non-finite-vertex", where(not_finite), true);
    report.add("index-out-of-range", out_of_range, true);
    report.add("face-too-small", too_small, true);
}

/// Normalises the used vertices, numbers them, and keeps the way back.
void settle_vertices(WorkingMesh& out, const Selection& chosen, const std::vector<int>& leader, const Points& source) {
    const int n = static_cast<int>(source.rows());
    const std::vector<bool> used = chosen.used(n);
    std::vector<int> number(n, -1);
    for (int v = 0; v < n; ++v)
        if (used[v]) {
            number[v] = static_cast<int>(out.source_of_working.size());
            out.source_of_working.push_back(v);
        }
    out.working_of_source.assign(n, -1);
    for (int v = 0; v < n; ++v)
        if (leader[v] >= 0)
            out.working_of_source[v] = number[leader[v]];
    out.mesh.points.resize(std::ssize(out.source_of_working), 3);
    for (int w = 0; w < out.mesh.points.rows(); ++w)
        out.mesh.points.row(w) = out.to_working(Eigen::Vector3d(source.row(out.source_of_working[w])));
    out.mesh.triangles = chosen.triangles.unaryExpr([&](int v) { return number[v]; });
    out.polygon_of_triangle = chosen.polygon_of_triangle;
}

/// What the finished copy is like: all but what was found on the way there.
void describe(WorkingMesh& out, Report& report) {
    const Components parts = components(vertex_rings(out.mesh));
    out.component_count = parts.count;
    const auto source_of = [&](std::vector<int> vertices) {
        for (int& v : vertices)
            v = out.source_of_working[v];
        return vertices;
    };

    const std::vector<Edge> all = edges(out.mesh);
    out.euler_characteristic = out.mesh.vertex_count() - static_cast<int>(all.size()) + out.mesh.triangle_count();
    std::vector<int> crowded;
    for (const Edge& e : all) {
        if (e.forward + e.backward > 2)
            crowded.push_back(e.a);
        out.closed = out.closed && e.forward + e.backward != 1;
    }
    report.add("non-manifold-edge", source_of(crowded), false);
    report.add("non-manifold-vertex", source_of(non_manifold_vertices(out.mesh)), false);

    std::vector<int> first_of_part, first_of_loop;
    for (int v = 0; v < out.mesh.vertex_count(); ++v)
        if (parts.of_vertex[v] == std::ssize(first_of_part))
            first_of_part.push_back(v);
    if (parts.count > 1)
        report.add("several-components", source_of(first_of_part), false);
    if (!out.closed)
        for (const std::vector<int>& loop : boundary_loops(out.mesh))
            first_of_loop.push_back(loop.front());
    out.boundary_loop_count = static_cast<int>(first_of_loop.size());
    report.add("open-boundary", source_of(first_of_loop), false);

    if (out.centre.norm() > k_far * out.scale)
        report.add("far-from-origin", {out.source_of_working[0]}, true);
}

} // namespace

Eigen::Affine3d WorkingMesh::to_working(const Eigen::Affine3d& source_map) const {
    Eigen::Affine3d map = source_map; // N W N⁻¹ keeps the linear part; the origin goes to N(W(centre))
    map.translation() = (source_map * centre - centre) / scale;
    return map;
}

Eigen::Vector3d WorkingMesh::to_working(const Eigen::Vector3d& source_point) const {
    return (source_point - centre) / scale;
}

Eigen::Vector3d WorkingMesh::to_source(const Eigen::Vector3d& working_point) const {
    return working_point * scale + centre;
}

WorkingMesh make_working_mesh(const PolygonMesh& source) {
    check(source);
    const int n = source.vertex_count();
    WorkingMesh out;
    Report report;

    const std::vector<bool> finite = finite_vertices(source.points);
    report_unusable(source, finite, report);

    const bool has_faces = source.face_count() > 0;
    Triangulation drawn = has_faces ? triangulate(source) : through_points(source.points, finite);
    if (!has_faces)
        report.add("points-only", where(std::vector<bool>(n, true)), true);
    out.display = drawn.triangles;
    out.polygon_of_display = drawn.polygon_of_triangle;
    if (out.display.rows() == 0)
        throw InvalidInput("no-usable-faces", "None of the model's " + std::to_string(source.face_count())
                                                  + " faces has three different corners that exist and are finite.");

    Selection chosen{std::move(drawn.triangles), std::move(drawn.polygon_of_triangle)};
    const std::vector<bool> used = chosen.used(n);
    Eigen::AlignedBox3d box;
    for (int v = 0; v < n; ++v)
        if (used[v])
            box.extend(Eigen::Vector3d(source.points.row(v)));
    out.centre = box.min() + 0.5 * box.sizes();
    out.scale = box.diagonal().stableNorm();
    if (!(out.scale > 0) || !((1 / out.scale) < std::numeric_limits<double>::infinity()))
        throw InvalidInput("zero-size", "All corners of the model's faces stand in one point.");

    const Welding welded = weld(source.points, used, k_weld_distance * out.scale, chosen);
    if (chosen.triangles.rows() == 0)
        throw InvalidInput("no-usable-faces", "Every face of the model shrinks to a line or a point once corners at "
                                              "the same position are joined.");
    settle_vertices(out, chosen, welded.leader, source.points);
    out.source = source.points;

    const Eigen::VectorXd heights = slenderness(out.mesh);
    std::vector<int> flat, needles;
    for (int t = 0; t < out.mesh.triangle_count(); ++t)
        if (heights[t] < k_needle)
            (heights[t] < k_no_area ? flat : needles).push_back(t);
    report.add("zero-area-face", united(faces_of(flat, out.polygon_of_triangle), welded.collapsed), flat.empty());
    report.add("duplicate-vertices", welded.exact, true);
    report.add("near-duplicate-vertices", welded.near, true);
    report.add("duplicate-face", welded.repeated, true);
    std::vector<int> unused;
    for (int v = 0; v < n; ++v)
        if (finite[v] && out.working_of_source[v] < 0)
            unused.push_back(v);
    report.add("unused-vertex", unused, false);

    const Orientation facing = orient(out.mesh);
    for (int t = 0; t < out.mesh.triangle_count(); ++t)
        if (facing.turned[t])
            std::swap(out.mesh.triangles(t, 1), out.mesh.triangles(t, 2));
    out.oriented = facing.one_sided.empty();
    report.add("inconsistent-orientation", faces_of(facing.inconsistent, out.polygon_of_triangle), true);
    report.add("inside-out", faces_of(facing.inside_out, out.polygon_of_triangle), true);
    report.add("non-orientable", faces_of(facing.one_sided, out.polygon_of_triangle), false);

    describe(out, report);
    report.add("needle-face", faces_of(needles, out.polygon_of_triangle), false);
    out.findings = report.take();
    // What the surface drawn through points is like is not the file's doing.
    if (!has_faces)
        std::erase_if(out.findings, [](const Finding& f) { return !about_points(f); });
    return out;
}

} // namespace lissom
