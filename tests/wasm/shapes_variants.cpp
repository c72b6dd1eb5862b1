// Shapes made from shapes: joined, moved, broken, renumbered.

#include "shapes.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace shapes {

namespace {

/// Pseudo-random numbers that are the same everywhere (splitmix64).
class Random {
public:
    explicit Random(std::uint64_t seed) : state_(seed) {}
    std::uint64_t next() {
        std::uint64_t z = state_ += 0x9e3779b97f4a7c15u;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return z ^ (z >> 31);
    }
    /// Even in [−1, 1)
    double even() { return static_cast<double>(next() >> 11) * 0x1p-52 - 1; }

private:
    std::uint64_t state_;
};

int add_point(TriangleMesh& mesh, const Eigen::RowVector3d& p) {
    mesh.points.conservativeResize(mesh.points.rows() + 1, Eigen::NoChange);
    mesh.points.row(mesh.points.rows() - 1) = p;
    return mesh.vertex_count() - 1;
}

void add_triangle(TriangleMesh& mesh, int a, int b, int c) {
    mesh.triangles.conservativeResize(mesh.triangles.rows() + 1, Eigen::NoChange);
    mesh.triangles.row(mesh.triangles.rows() - 1) << a, b, c;
}

} // namespace

TriangleMesh joined(const std::vector<TriangleMesh>& parts) {
    TriangleMesh all{Points(0, 3), Triangles(0, 3)};
    for (const TriangleMesh& part : parts) {
        const int v = all.vertex_count(), t = all.triangle_count();
        all.points.conservativeResize(v + part.points.rows(), Eigen::NoChange);
        all.points.bottomRows(part.points.rows()) = part.points;
        all.triangles.conservativeResize(t + part.triangles.rows(), Eigen::NoChange);
        all.triangles.bottomRows(part.triangles.rows()) = part.triangles.array() + v;
    }
    return all;
}

TriangleMesh moved(TriangleMesh mesh, const Eigen::Affine3d& map) {
    for (int v = 0; v < mesh.vertex_count(); ++v)
        mesh.points.row(v) = map * Eigen::Vector3d(mesh.points.row(v));
    return mesh;
}

TriangleMesh turned_inside_out(TriangleMesh mesh) {
    mesh.triangles.col(1).swap(mesh.triangles.col(2));
    return mesh;
}

TriangleMesh soup(const TriangleMesh& mesh, double jitter) {
    Random random(5);
    TriangleMesh apart{Points(3 * mesh.triangle_count(), 3), Triangles(mesh.triangle_count(), 3)};
    for (int c = 0; c < apart.vertex_count(); ++c) {
        apart.triangles(c / 3, c % 3) = c;
        apart.points.row(c) = mesh.points.row(mesh.triangles(c / 3, c % 3));
        for (int axis = 0; axis < 3 && jitter > 0; ++axis)
            apart.points(c, axis) += jitter * random.even();
    }
    return apart;
}

TriangleMesh with_fin(TriangleMesh mesh) {
    const int a = mesh.triangles(0, 0), b = mesh.triangles(0, 1), c = mesh.triangles(0, 2);
    const Eigen::RowVector3d ab = mesh.points.row(b) - mesh.points.row(a), ac = mesh.points.row(c) - mesh.points.row(a);
    const int tip = add_point(mesh, mesh.points.row(a) + 0.5 * ab + ab.norm() * ab.cross(ac).normalized());
    add_triangle(mesh, a, b, tip);
    return mesh;
}

TriangleMesh with_flipped_face(TriangleMesh mesh, int face) {
    std::swap(mesh.triangles(face, 1), mesh.triangles(face, 2));
    return mesh;
}

TriangleMesh with_mixed_orientation(TriangleMesh mesh, int every) {
    for (int t = 0; t < mesh.triangle_count(); t += every)
        std::swap(mesh.triangles(t, 1), mesh.triangles(t, 2));
    return mesh;
}

TriangleMesh with_unused_vertices(const TriangleMesh& mesh, int count) {
    TriangleMesh more{Points(mesh.vertex_count() + count, 3), mesh.triangles};
    const int gap = mesh.vertex_count() / count; // one unused vertex before each run of this many
    const auto place = [&](int v) { return v + std::min(v / gap + 1, count); };
    more.points.rowwise() = Eigen::RowVector3d(0.3, 0.2, 0.1);
    for (int v = 0; v < mesh.vertex_count(); ++v)
        more.points.row(place(v)) = mesh.points.row(v);
    more.triangles = mesh.triangles.unaryExpr(place).eval();
    return more;
}

TriangleMesh with_zero_area_faces(TriangleMesh mesh) {
    const int a = mesh.triangles(0, 0), b = mesh.triangles(0, 1);
    const int middle = add_point(mesh, mesh.points.row(a));
    for (int t = 0, count = mesh.triangle_count(); t < count; ++t)
        for (int k = 0; k < 3; ++k) {
            const int from = mesh.triangles(t, k), to = mesh.triangles(t, (k + 1) % 3);
            if ((from != a || to != b) && (from != b || to != a))
                continue;
            const int other = mesh.triangles(t, (k + 2) % 3);
            mesh.triangles.row(t) << from, middle, other;
            add_triangle(mesh, middle, to, other);
            break;
        }
    return mesh;
}

TriangleMesh with_needles(TriangleMesh mesh, int count, double thinness) {
    for (int t = 0; t < count; ++t) {
        const int a = mesh.triangles(t, 0), b = mesh.triangles(t, 1), c = mesh.triangles(t, 2);
        const Eigen::RowVector3d middle = 0.5 * (mesh.points.row(a) + mesh.points.row(b));
        const int m = add_point(mesh, middle + thinness * (mesh.points.row(c) - middle));
        mesh.triangles.row(t) << a, b, m;
        add_triangle(mesh, b, c, m);
        add_triangle(mesh, c, a, m);
    }
    return mesh;
}

TriangleMesh with_extra_shell(const TriangleMesh& mesh) {
    const Eigen::RowVector3d size = mesh.points.colwise().maxCoeff() - mesh.points.colwise().minCoeff();
    const Eigen::RowVector3d base = mesh.points.colwise().maxCoeff() + 0.1 * size;
    TriangleMesh shell{Points(4, 3), Triangles(4, 3)};
    shell.points << 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1;
    shell.points = (0.1 * size.norm() * shell.points).rowwise() + base;
    shell.triangles << 0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2;
    return joined({mesh, shell});
}

TriangleMesh with_duplicate_faces(TriangleMesh mesh, int count) {
    for (int t = 0; t < count; ++t)
        add_triangle(mesh, mesh.triangles(t, 1), mesh.triangles(t, 2), mesh.triangles(t, 0));
    return mesh;
}

TriangleMesh with_nan_vertex(TriangleMesh mesh, int v) {
    mesh.points(v, 1) = std::numeric_limits<double>::quiet_NaN();
    return mesh;
}

std::vector<Broken> eight_broken(const TriangleMesh& mesh) {
    return {{"unused vertices", with_unused_vertices(mesh)},
            {"zero-area faces", with_zero_area_faces(mesh)},
            {"duplicated positions", soup(mesh)},
            {"a fin", with_fin(mesh)},
            {"a flipped face", with_flipped_face(mesh)},
            {"an extra shell", with_extra_shell(mesh)},
            {"needles", with_needles(mesh)},
            {"a jittered soup", soup(mesh, 1e-8)}};
}

std::vector<int> permutation(int n, std::uint64_t seed) {
    Random random(seed);
    std::vector<int> places(n);
    std::iota(places.begin(), places.end(), 0);
    for (int i = n - 1; i > 0; --i)
        std::swap(places[i], places[random.next() % static_cast<std::uint64_t>(i + 1)]);
    return places;
}

TriangleMesh permuted(const TriangleMesh& mesh, const std::vector<int>& new_place) {
    TriangleMesh other = mesh;
    for (int v = 0; v < mesh.vertex_count(); ++v)
        other.points.row(new_place[v]) = mesh.points.row(v);
    other.triangles = mesh.triangles.unaryExpr([&](int v) { return new_place[v]; }).eval();
    return other;
}

PolygonMesh polygons(const TriangleMesh& mesh) {
    PolygonMesh file{mesh.points, {0}, {}};
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        file.corners.insert(file.corners.end(), {mesh.triangles(t, 0), mesh.triangles(t, 1), mesh.triangles(t, 2)});
        file.offsets.push_back(static_cast<int>(file.corners.size()));
    }
    return file;
}

PolygonMesh polygons(const Points& points, const std::vector<std::vector<int>>& faces) {
    PolygonMesh file{points, {0}, {}};
    for (const std::vector<int>& face : faces) {
        file.corners.insert(file.corners.end(), face.begin(), face.end());
        file.offsets.push_back(static_cast<int>(file.corners.size()));
    }
    return file;
}

} // namespace shapes
