#include "egg.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

namespace eggs {

Convex::Convex(const TriangleMesh& closed) {
    for (int t = 0; t < closed.triangle_count(); ++t) {
        const Vector3d a = closed.points.row(closed.triangles(t, 0)), b = closed.points.row(closed.triangles(t, 1)), c = closed.points.row(closed.triangles(t, 2));
        const Vector3d normal = (b - a).cross(c - a);
        if (normal.norm() == 0) continue;
        normals_.push_back(normal.normalized());
        offsets_.push_back(normals_.back().dot(a));
    }
    double highest = 0; // of a vertex before a face: none is, or the mesh would not be convex
    for (int v = 0; v < closed.vertex_count(); ++v)
        for (std::size_t f = 0; f < normals_.size(); ++f) highest = std::max(highest, normals_[f].dot(Vector3d(closed.points.row(v))) - offsets_[f]);
    REQUIRE(highest < 1e-9);
}

double Convex::depth(const Vector3d& p) const {
    if (normals_[parting_].dot(p) > offsets_[parting_]) return 0;
    double highest = -INFINITY;
    for (std::size_t f = 0; f < normals_.size(); ++f) {
        const double before = normals_[f].dot(p) - offsets_[f];
        if (before > 0) {
            parting_ = f;
            return 0;
        }
        highest = std::max(highest, before);
    }
    return -highest;
}

} // namespace eggs
