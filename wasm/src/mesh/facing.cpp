#include "lissom/mesh/facing.h"

#include "lissom/mesh/capped.h"
#include "lissom/mesh/operators.h"

#include <Eigen/Geometry>

#include <cmath>

namespace lissom {

namespace {
constexpr double k_flat = 1e-3; // volume against area^1.5; a sphere has 0.094
} // namespace

int facing(const TriangleMesh& mesh) {
    const TriangleMesh closed = capped(mesh);
    const Eigen::RowVector3d origin = mesh.points.colwise().mean();
    double volume = 0;
    for (int t = 0; t < closed.triangle_count(); ++t) {
        const auto corner = [&](int k) -> Eigen::RowVector3d { return closed.points.row(closed.triangles(t, k)) - origin; };
        volume += corner(0).dot(corner(1).cross(corner(2))) / 6;
    }
    const double area = triangle_areas(mesh).sum();
    if (!(std::abs(volume) > k_flat * std::pow(area, 1.5))) return 0;
    return volume > 0 ? 1 : -1;
}

} // namespace lissom
