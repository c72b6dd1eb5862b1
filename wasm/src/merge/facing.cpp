#include "lissom/merge/facing.h"

#include "lissom/mesh/operators.h"
#include "lissom/mesh/topology.h"

#include <Eigen/Geometry>

#include <cmath>

namespace lissom {

namespace {
constexpr double k_flat = 1e-3; // volume against area^1.5; a sphere has 0.094
} // namespace

int facing(const TriangleMesh& mesh) {
    const Eigen::RowVector3d origin = mesh.points.colwise().mean();
    double volume = 0;
    const auto add = [&](const Eigen::RowVector3d& a, const Eigen::RowVector3d& b, const Eigen::RowVector3d& c) {
        volume += (a - origin).dot((b - origin).cross(c - origin)) / 6;
    };
    for (int t = 0; t < mesh.triangle_count(); ++t)
        add(mesh.points.row(mesh.triangles(t, 0)), mesh.points.row(mesh.triangles(t, 1)), mesh.points.row(mesh.triangles(t, 2)));
    for (const std::vector<int>& loop : boundary_loops(mesh)) {
        Eigen::RowVector3d middle = Eigen::RowVector3d::Zero();
        for (const int v : loop) middle += mesh.points.row(v) / static_cast<double>(loop.size());
        for (std::size_t i = 0; i < loop.size(); ++i) add(middle, mesh.points.row(loop[(i + 1) % loop.size()]), mesh.points.row(loop[i]));
    }
    const double area = triangle_areas(mesh).sum();
    if (!(std::abs(volume) > k_flat * std::pow(area, 1.5))) return 0;
    return volume > 0 ? 1 : -1;
}

} // namespace lissom
