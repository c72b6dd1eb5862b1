#include "lissom/mesh/surface_places.h"

#include "lissom/mesh/corner_weights.h"
#include "lissom/mesh/triangle_tree.h"

namespace lissom {

Points SurfacePlaces::on(const TriangleMesh& mesh) const {
    Points places = Points::Zero(size(), 3);
    for (int i = 0; i < size(); ++i)
        if (const int t = triangle[i]; t >= 0)
            for (int k = 0; k < 3; ++k) places.row(i) += weights(i, k) * mesh.points.row(mesh.triangles(t, k));
    return places;
}

SurfacePlaces places_on(const TriangleMesh& surface, const Points& points) {
    const TriangleTree tree(surface);
    SurfacePlaces places{{}, Points(points.rows(), 3)};
    places.triangle.reserve(static_cast<std::size_t>(points.rows()));
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
        const TriangleTree::Nearest at = tree.nearest(points.row(i));
        places.triangle.push_back(at.triangle);
        places.weights.row(i) = at.triangle < 0 ? Eigen::RowVector3d(1, 0, 0) : Eigen::RowVector3d(corner_weights(surface, at.triangle, at.point).transpose());
    }
    return places;
}

} // namespace lissom
