#include "lissom/mesh/working_mesh.h"

#include "lissom/mesh/errors.h"
#include "lissom/mesh/half_edges.h"
#include "lissom/mesh/orientation.h"
#include "lissom/mesh/topology.h"
#include "lissom/mesh/weld.h"

#include <algorithm>
#include <limits>
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
        throw InvalidInput("no-faces", "The model has no faces, so there is no surface to work on.");
    if (source.offsets.front() != 0 || source.offsets.back() != std::ssize(source.corners)
        || !std::is_sorted(source.offsets.begin(), source.offsets.end()))
        throw InvalidInput("bad-offsets", "The faces' offsets do not fit their corners.");
}

/// Triangles on their way into the working copy, with the source face of each.
struct Selection {
    Triangles triangles;
    std::vector<int> polygon_of_triangle;
    std::vector<int> dropped; ///< faces of what `keep` left out last

    template <class Wanted>
    void keep(Wanted wanted) {
        int count = 0;
        dropped.clear();
        for (int t = 0; t < triangles.rows(); ++t) {
            if (!wanted(t)) {
                dropped.push_back(polygon_of_triangle[t]);
                continue;
            }
            triangles.row(count) = triangles.row(t).eval();
            polygon_of_triangle[count++] = polygon_of_triangle[t];
        }
        triangles.conservativeResize(count, 3);
        polygon_of_triangle.resize(count);
        dropped.erase(std::unique(dropped.begin(), dropped.end()), dropped.end()); // faces come in order
    }
    void map(const std::vector<int>& vertex) {
        for (int& v : triangles.reshaped())
            v = vertex[v];
    }
    void drop_collapsed() {
        keep([&](int t) {
            const auto c = triangles.row(t);
            return c[0] != c[1] && c[1] != c[2] && c[2] != c[0];
        });
    }
    void drop_repeated() {
        const std::vector<bool> repeated = repeated_triangles(triangles);
        keep([&](int t) { return !repeated[t]; });
    }
    [[nodiscard]] std::vector<bool> used(int vertex_count) const {
        std::vector<bool> flags(vertex_count, false);
        for (const int v : triangles.reshaped())
            flags[v] = true;
        return flags;
    }
};

/// Vertices that a near twin may stand beside: on a boundary, and with edges long enough that welding within
/// the tolerance can neither fold a triangle nor eat fine detail.
std::vector<int> weldable(const TriangleMesh& mesh, double tolerance) {
    std::vector<bool> on_boundary(mesh.vertex_count(), false), has_short_edge(mesh.vertex_count(), false);
    for (const Edge& e : edges(mesh)) {
        if (e.forward + e.backward == 1)
            on_boundary[e.a] = on_boundary[e.b] = true;
        if ((mesh.points.row(e.a) - mesh.points.row(e.b)).norm() < 4 * tolerance)
            has_short_edge[e.a] = has_short_edge[e.b] = true;
    }
    std::vector<int> found;
    for (int v = 0; v < mesh.vertex_count(); ++v)
        if (on_boundary[v] && !has_short_edge[v])
            found.push_back(v);
    return found;
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
    const VertexRings rings = vertex_rings(out.mesh);
    const Components parts = components(rings);
    out.component_count = parts.count;
    out.euler_characteristic = euler_characteristic(out.mesh);
    const auto source_of = [&](std::vector<int> vertices) {
        for (int& v : vertices)
            v = out.source_of_working[v];
        return vertices;
    };

    std::vector<int> crowded;
    for (const Edge& e : edges(out.mesh)) {
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

    Triangulation drawn = triangulate(source);
    out.display = drawn.triangles;
    out.polygon_of_display = drawn.polygon_of_triangle;
    if (out.display.rows() == 0)
        throw InvalidInput("no-usable-faces", "None of the model's " + std::to_string(source.face_count())
                                                  + " faces has three different corners that exist and are finite.");

    Selection chosen{std::move(drawn.triangles), std::move(drawn.polygon_of_triangle), {}};
    const std::vector<bool> used = chosen.used(n);
    Eigen::AlignedBox3d box;
    for (int v = 0; v < n; ++v)
        if (used[v])
            box.extend(Eigen::Vector3d(source.points.row(v)));
    out.centre = box.min() + 0.5 * box.sizes();
    out.scale = box.diagonal().stableNorm();
    if (!(out.scale > 0) || !((1 / out.scale) < std::numeric_limits<double>::infinity()))
        throw InvalidInput("zero-size", "All corners of the model's faces stand in one point.");

    // Weld: exact twins first, then the near ones along what is still open.
    std::vector<int> leader = exact_twins(source.points, used);
    std::vector<int> twins, near;
    for (int v = 0; v < n; ++v)
        if (leader[v] >= 0 && leader[v] != v)
            twins.push_back(v);
    chosen.map(leader);
    chosen.drop_collapsed();
    std::vector<int> collapsed = chosen.dropped;
    chosen.drop_repeated();
    std::vector<int> repeated = chosen.dropped;

    const double reach = k_weld_distance * out.scale;
    const std::vector<int> open = weldable({source.points, chosen.triangles}, reach);
    const std::vector<int> joined = near_twins(source.points, open, reach);
    std::vector<int> target(n);
    for (int v = 0; v < n; ++v)
        target[v] = v;
    for (std::size_t i = 0; i < open.size(); ++i)
        if (joined[i] != open[i]) {
            target[open[i]] = joined[i];
            near.push_back(open[i]);
        }
    if (!near.empty()) {
        for (int& v : leader)
            v = v < 0 ? v : target[v];
        chosen.map(target);
        chosen.drop_collapsed();
        collapsed.insert(collapsed.end(), chosen.dropped.begin(), chosen.dropped.end());
        chosen.drop_repeated();
        repeated.insert(repeated.end(), chosen.dropped.begin(), chosen.dropped.end());
    }
    if (chosen.triangles.rows() == 0)
        throw InvalidInput("no-usable-faces", "Every face of the model shrinks to a line or a point once corners at "
                                              "the same position are joined.");
    settle_vertices(out, chosen, leader, source.points);
    out.source = source.points;

    const Eigen::VectorXd heights = slenderness(out.mesh);
    std::vector<int> flat, needles;
    for (int t = 0; t < out.mesh.triangle_count(); ++t)
        if (heights[t] < k_needle)
            (heights[t] < k_no_area ? flat : needles).push_back(t);
    const bool all_collapsed = flat.empty();
    std::vector<int> without_area = faces_of(flat, out.polygon_of_triangle);
    without_area.insert(without_area.end(), collapsed.begin(), collapsed.end());
    for (std::vector<int>* faces : {&without_area, &repeated}) {
        std::sort(faces->begin(), faces->end());
        faces->erase(std::unique(faces->begin(), faces->end()), faces->end());
    }
    report.add("zero-area-face", without_area, all_collapsed);
    report.add("duplicate-vertices", twins, true);
    report.add("near-duplicate-vertices", near, true);
    report.add("duplicate-face", repeated, true);
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
    return out;
}

} // namespace lissom
