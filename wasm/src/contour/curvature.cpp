#include "lissom/contour/curvature.h"

#include "lissom/mesh/topology.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace lissom {

using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

constexpr int k_triangles = 20000; // of a slice

/// The part of a triangle that is nearest to each of its corners, mixed as Meyer et al. (2003) where it is obtuse.
Vector3d corner_areas(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
    const Vector3d e[3] = {c - b, a - c, b - a}; // opposite corner k
    const double area = e[0].cross(e[1]).norm() / 2;
    const double l[3] = {e[0].squaredNorm(), e[1].squaredNorm(), e[2].squaredNorm()};
    for (int k = 0; k < 3; ++k)
        if (l[k] > l[(k + 1) % 3] + l[(k + 2) % 3]) {
            Vector3d obtuse = Vector3d::Constant(area / 4);
            obtuse[k] = area / 2;
            return obtuse;
        }
    if (area <= 0) return Vector3d::Zero();
    Vector3d cotangents;
    for (int k = 0; k < 3; ++k) cotangents[k] = -e[(k + 1) % 3].dot(e[(k + 2) % 3]) / (2 * area);
    Vector3d areas;
    for (int k = 0; k < 3; ++k) areas[k] = (l[(k + 1) % 3] * cotangents[(k + 1) % 3] + l[(k + 2) % 3] * cotangents[(k + 2) % 3]) / 8;
    return areas;
}

struct Corners {
    Vector3d a, b, c;
    Corners(const TriangleMesh& mesh, int t)
        : a(mesh.points.row(mesh.triangles(t, 0))), b(mesh.points.row(mesh.triangles(t, 1))), c(mesh.points.row(mesh.triangles(t, 2))) {}
};

} // namespace

Points max_normals(const TriangleMesh& mesh) {
    Points normals = Points::Zero(mesh.vertex_count(), 3);
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        const Corners p(mesh, t);
        const Vector3d e[3] = {p.c - p.b, p.a - p.c, p.b - p.a};
        const Vector3d n = e[2].cross(-e[1]);
        for (int k = 0; k < 3; ++k) {
            const double scale = e[(k + 1) % 3].squaredNorm() * e[(k + 2) % 3].squaredNorm();
            if (scale > 0) normals.row(mesh.triangles(t, k)) += (n / scale).transpose();
        }
    }
    for (Eigen::Index v = 0; v < normals.rows(); ++v)
        if (const double length = normals.row(v).norm(); length > 0) normals.row(v) /= length;
    return normals;
}

ShapeTensor triangle_tensor(const TriangleMesh& mesh, const Points& normals, int t) {
    const Corners p(mesh, t);
    const Vector3d e[3] = {p.c - p.b, p.a - p.c, p.b - p.a};
    const Vector3d n = e[0].cross(e[1]);
    if (n.norm() <= 1e-12 * e[0].norm() * e[1].norm()) return ShapeTensor::Zero();
    const Vector3d u = e[0].normalized(), v = n.normalized().cross(u);
    // Unknowns (e, f, g) of II = [e f; f g]; two equations an edge.
    Matrix3d normal = Matrix3d::Zero();
    Vector3d right = Vector3d::Zero();
    for (int k = 0; k < 3; ++k) {
        const Vector3d dn = (normals.row(mesh.triangles(t, (k + 2) % 3)) - normals.row(mesh.triangles(t, (k + 1) % 3))).transpose();
        const double x = e[k].dot(u), y = e[k].dot(v);
        const Vector3d along_u(x, y, 0), along_v(0, x, y);
        normal += along_u * along_u.transpose() + along_v * along_v.transpose();
        right += dn.dot(u) * along_u + dn.dot(v) * along_v;
    }
    const Vector3d efg = normal.inverse() * right;
    if (!efg.allFinite()) return ShapeTensor::Zero();
    return efg[0] * u * u.transpose() + efg[1] * (u * v.transpose() + v * u.transpose()) + efg[2] * v * v.transpose();
}

ShapeTensor carried(const ShapeTensor& tensor, const Vector3d& m, const Vector3d& n) {
    // The turn R = I − c a aᵀ + 2 n mᵀ, a = m + n, c = 1/(1 + m·n); T m = 0, so the last term drops out of R T Rᵀ.
    const double d = 1 + m.dot(n);
    if (d < 1e-6) return tensor;
    const double c = 1 / d;
    const Vector3d a = m + n, ta = tensor * a;
    return tensor - c * (a * ta.transpose() + ta * a.transpose()) + c * c * a.dot(ta) * a * a.transpose();
}

CurvatureField::CurvatureField(const TriangleMesh& mesh, int sweeps)
    : mesh_(&mesh), sweeps_(std::max(0, sweeps)), normals_(max_normals(mesh)), smooth_(normals_), tensors_(static_cast<std::size_t>(mesh.vertex_count()), ShapeTensor::Zero()),
      weights_(Eigen::VectorXd::Zero(mesh.vertex_count())) {
    VertexRings rings = vertex_rings(mesh);
    ring_offsets_ = std::move(rings.offsets);
    ring_ = std::move(rings.neighbours);
}

bool CurvatureField::step() {
    if (done_triangles_ < mesh_->triangle_count()) {
        const int last = std::min(done_triangles_ + k_triangles, mesh_->triangle_count());
        add_triangles(done_triangles_, last);
        done_triangles_ = last;
        if (last == mesh_->triangle_count())
            for (std::size_t v = 0; v < tensors_.size(); ++v)
                if (const double w = weights_[static_cast<Eigen::Index>(v)]; w > 0) tensors_[v] /= w;
    } else if (done_sweeps_ < sweeps_) {
        sweep();
        ++done_sweeps_;
    }
    return done_triangles_ < mesh_->triangle_count() || done_sweeps_ < sweeps_;
}

double CurvatureField::fraction() const {
    const double triangles = mesh_->triangle_count() == 0 ? 1 : static_cast<double>(done_triangles_) / mesh_->triangle_count();
    return (triangles + done_sweeps_) / (1 + sweeps_);
}

void CurvatureField::add_triangles(int first, int last) {
    for (int t = first; t < last; ++t) {
        const Corners p(*mesh_, t);
        const Vector3d n = (p.b - p.a).cross(p.c - p.a).normalized();
        if (!n.allFinite()) continue;
        const ShapeTensor tensor = triangle_tensor(*mesh_, normals_, t);
        const Vector3d areas = corner_areas(p.a, p.b, p.c);
        for (int k = 0; k < 3; ++k) {
            const int v = mesh_->triangles(t, k);
            tensors_[v] += areas[k] * carried(tensor, n, normals_.row(v).transpose());
            weights_[v] += areas[k];
        }
    }
}

void CurvatureField::sweep() {
    const Points normals = smooth_;
    const std::vector<ShapeTensor> tensors = tensors_;
    for (int v = 0; v < mesh_->vertex_count(); ++v) {
        const int count = ring_offsets_[v + 1] - ring_offsets_[v];
        if (count == 0) continue;
        Vector3d mean = Vector3d::Zero();
        for (int i = ring_offsets_[v]; i < ring_offsets_[v + 1]; ++i) mean += normals.row(ring_[i]).transpose();
        const Vector3d old = normals.row(v), n = (old + mean / count).normalized();
        if (!n.allFinite()) continue;
        ShapeTensor sum = ShapeTensor::Zero();
        for (int i = ring_offsets_[v]; i < ring_offsets_[v + 1]; ++i) sum += carried(tensors[ring_[i]], normals.row(ring_[i]).transpose(), n);
        tensors_[v] = (carried(tensors[v], old, n) + sum / count) / 2;
        smooth_.row(v) = n.transpose();
    }
}

} // namespace lissom
