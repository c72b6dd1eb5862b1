#include "lissom/wear/body.h"

#include "lissom/mesh/capped.h"
#include "lissom/mesh/corner_weights.h"
#include "lissom/mesh/facing.h"
#include "lissom/mesh/operators.h"
#include "lissom/mesh/surface_samples.h"
#include "lissom/mesh/topology.h"

namespace lissom {

using Eigen::Vector3d;

namespace {

/// More openings than a garment's worth of limbs: not closed by fans, which in a soup would lie on its triangles.
constexpr std::size_t k_openings = 16;
/// How far beside the surface it is tried, in shares of the size.
constexpr double k_beside = 0.002;
constexpr int k_tried = 400;

TriangleMesh closed(const TriangleMesh& surface) {
    const std::size_t openings = boundary_loops(surface).size();
    TriangleMesh mesh = openings > 0 && openings <= k_openings ? capped(surface) : surface;
    if (facing(mesh) < 0) mesh.triangles.col(1).swap(mesh.triangles.col(2));
    return mesh;
}

} // namespace

Body::Body(const TriangleMesh& surface, double size) : mesh_(closed(surface)), tree_(mesh_), winding_(mesh_), normals_(vertex_normals(mesh_)) {
    const SurfacePlaces samples = sample_surface(mesh_, k_tried);
    const Points places = samples.on(mesh_);
    int right = 0;
    for (int k = 0; k < samples.size(); ++k) {
        const auto corner = [&](int c) -> Vector3d { return mesh_.points.row(mesh_.triangles(samples.triangle[k], c)); };
        const Vector3d off = k_beside * size * (corner(1) - corner(0)).cross(corner(2) - corner(0)).stableNormalized();
        const Vector3d p = places.row(k);
        right += winding_(p - off) > 0.5 && winding_(p + off) < 0.5;
    }
    has_inside_ = samples.size() > 0 && right >= 0.95 * samples.size();
}

Body::Place Body::nearest(const Vector3d& p) const {
    const TriangleTree::Nearest at = tree_.nearest(p);
    const Vector3d weights = corner_weights(mesh_, at.triangle, at.point);
    Vector3d normal = Vector3d::Zero();
    for (int k = 0; k < 3; ++k) normal += weights[k] * normals_.row(mesh_.triangles(at.triangle, k)).transpose();
    return {at.point, normal.stableNormalized(), at.distance};
}

} // namespace lissom
