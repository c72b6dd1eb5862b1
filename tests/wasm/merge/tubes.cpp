#include "tubes.h"

#include "lissom/merge/loop_frames.h"
#include "lissom/mesh/operators.h"
#include "lissom/mesh/topology.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

namespace tubes {

using Eigen::Vector3d;
using lissom::TriangleMesh;

TriangleMesh tube(int n, int m, const Profile& profile, bool upward) {
    TriangleMesh mesh{lissom::Points(n * m + 1, 3), lissom::Triangles(2 * (n - 1) * m + m, 3)};
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < m; ++j)
            mesh.points.row(i * m + j) = profile(static_cast<double>(i) / n, 2 * std::numbers::pi * j / m).transpose();
    mesh.points.row(n * m) = profile(1, 0).transpose();
    int f = 0;
    const auto add = [&](int a, int b, int c) {
        if (!upward) std::swap(b, c);
        mesh.triangles.row(f++) << a, b, c;
    };
    for (int i = 0; i + 1 < n; ++i)
        for (int j = 0; j < m; ++j) {
            const int a = i * m + j, b = (i + 1) * m + j, c = (i + 1) * m + (j + 1) % m, d = i * m + (j + 1) % m;
            add(a, b, c);
            add(a, c, d);
        }
    for (int j = 0; j < m; ++j) add((n - 1) * m + j, n * m, (n - 1) * m + (j + 1) % m);
    return mesh;
}

Vector3d dome(double s, double t) {
    const double r = (1 - s * s * s) * (1 + 0.1 * s * std::cos(3 * t + s));
    return {r * std::cos(t), 2 * s + 0.1 * s * std::sin(t), r * std::sin(t)};
}

Vector3d bowl(double s, double t) {
    const double r = 1.4 * (1 - s * s * s * s);
    return {r * std::cos(t), -2 * s, r * std::sin(t)};
}

std::vector<int> first(int count) {
    std::vector<int> list;
    for (int i = 0; i < count; ++i) list.push_back(i);
    return list;
}

std::vector<int> within(const TriangleMesh& mesh, double low, double high) {
    std::vector<int> list;
    for (int v = 0; v < mesh.vertex_count(); ++v)
        if (mesh.points(v, 1) >= low && mesh.points(v, 1) <= high) list.push_back(v);
    return list;
}

Stitched stitched(int n, int m) {
    const std::vector<lissom::BoundaryLoop> of_source{{first(n), {}}}, of_target{{first(m), {}}};
    Stitched out{lissom::cut_part(tube(12, m, bowl, false), of_target, "target"), lissom::cut_part(tube(12, n, dome), of_source, "source"), {}, {}};
    const TriangleMesh &target = out.target.mesh, &source = out.source.mesh;
    const std::vector<std::pair<int, int>> keys{{0, 0}};
    out.match = lissom::match_loops(source.points, out.source.loops[0], target.points, out.target.loops[0], keys);
    const lissom::LoopImage image = lissom::image_of_loop(out.match, source.points, lissom::vertex_normals(source), target.points, lissom::vertex_normals(target));
    lissom::Points positions = 1.4 * source.points; // about as wide as the bowl
    for (std::size_t i = 0; i < out.match.source.size(); ++i) positions.row(out.match.source[i]) = image.positions.row(static_cast<Eigen::Index>(i));
    out.joined = lissom::stitch(out.target, out.source, false, positions, std::span(&out.match, 1));
    return out;
}

void check_closed(const TriangleMesh& mesh, int euler) {
    CHECK(lissom::euler_characteristic(mesh) == euler);
    CHECK(lissom::non_manifold_vertices(mesh).empty());
    int apart = 0;
    for (const lissom::Edge& e : lissom::edges(mesh)) apart += e.forward != 1 || e.backward != 1;
    CHECK(apart == 0);
}

lissom::MergeResult merged(const lissom::WorkingMesh& source, const lissom::WorkingMesh& target, const std::vector<lissom::MergeBoundary>& boundaries,
                           const std::vector<lissom::MergeKeys>& keys, lissom::MergeOptions options) {
    lissom::MergeSession session(source, target, boundaries, options);
    while (session.step()) {}
    return session.merge(keys);
}

TriangleMesh mesh_of(const lissom::MergedModel& model, const TriangleMesh& source, const TriangleMesh& target) {
    std::vector<Eigen::RowVector3i> triangles;
    const auto add_whole = [&](const lissom::Contribution& part, const TriangleMesh& file) {
        for (std::size_t k = 0; k < part.faces.size(); ++k) {
            Eigen::RowVector3i t;
            for (int c = 0; c < 3; ++c) t[c] = part.result_of_vertex[file.triangles(part.faces[k], part.turned[k] ? 2 - c : c)];
            triangles.push_back(t);
        }
    };
    add_whole(model.target, target);
    add_whole(model.source, source);
    for (std::size_t k = 0; k < model.cut_face.size(); ++k)
        triangles.emplace_back(model.cut_vertices[3 * k], model.cut_vertices[3 * k + 1], model.cut_vertices[3 * k + 2]);
    TriangleMesh mesh{model.positions, lissom::Triangles(std::ssize(triangles), 3)};
    for (std::size_t t = 0; t < triangles.size(); ++t) mesh.triangles.row(static_cast<Eigen::Index>(t)) = triangles[t];
    return mesh;
}

std::vector<Eigen::Affine3d> twenty_similarities() {
    std::vector<Eigen::Affine3d> maps;
    for (int k = 0; k < 20; ++k) {
        const double scale = std::pow(10, -2 + 4.0 * k / 19);
        const Vector3d axis = Vector3d(std::sin(1 + k), std::cos(2.3 * k), std::sin(0.7 * k)).normalized();
        Eigen::Affine3d map = Eigen::Affine3d::Identity();
        map.linear() = scale * Eigen::AngleAxisd(std::fmod(2.4 * k, 6.28), axis).toRotationMatrix();
        map.translation() = scale * Vector3d(std::cos(5.0 * k), 3 * std::sin(k + 0.5), 0.4 * k);
        maps.push_back(map);
    }
    return maps;
}

} // namespace tubes
