#include "lissom/mesh/capped.h"

#include "lissom/mesh/topology.h"

namespace lissom {

TriangleMesh capped(const TriangleMesh& mesh) {
    const auto loops = boundary_loops(mesh);
    TriangleMesh out = mesh;
    Eigen::Index extra = 0;
    for (const auto& loop : loops) extra += static_cast<Eigen::Index>(loop.size());
    out.points.conservativeResize(mesh.points.rows() + static_cast<Eigen::Index>(loops.size()), 3);
    out.triangles.conservativeResize(mesh.triangles.rows() + extra, 3);
    Eigen::Index t = mesh.triangles.rows();
    for (std::size_t l = 0; l < loops.size(); ++l) {
        const auto& loop = loops[l];
        const int centre = mesh.vertex_count() + static_cast<int>(l);
        Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
        for (const int v : loop) sum += mesh.points.row(v);
        out.points.row(centre) = sum / static_cast<double>(loop.size());
        for (std::size_t k = 0; k < loop.size(); ++k)
            out.triangles.row(t++) << loop[(k + 1) % loop.size()], loop[k], centre;
    }
    return out;
}

} // namespace lissom
