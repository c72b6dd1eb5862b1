// The second half of preparing a merge: the source's pose and the system that moves it.

#include "merge_state.h"

#include "lissom/mesh/facing.h"
#include "lissom/mesh/operators.h"
#include "lissom/mesh/polyline.h"
#include "lissom/mesh/topology.h"

#include <algorithm>
#include <set>
#include <utility>

namespace lissom {
namespace {

using Eigen::Affine3d;
using Eigen::Vector3d;

std::vector<int> inverse(const Part& part, int working_vertices) {
    std::vector<int> place(static_cast<std::size_t>(working_vertices), -1);
    for (int v = 0; v < std::ssize(part.origin); ++v)
        if (part.origin[v].is_vertex()) place[part.origin[v].vertex[0]] = v;
    return place;
}
/// The pose that a loop's own shape decides: its middle at the origin, its first vertex along x, its area's normal near z,
/// its length 1.
Affine3d canonical_pose(const Points& points, const std::vector<int>& loop) {
    Points ring(std::ssize(loop), 3);
    for (std::size_t i = 0; i < loop.size(); ++i) ring.row(static_cast<Eigen::Index>(i)) = points.row(loop[i]);
    const Eigen::RowVector3d middle = ring.colwise().mean();
    ring.rowwise() -= middle;
    const double length = loop_length(points, loop);
    const double size = length > 0 ? length : 1;
    Vector3d area = Vector3d::Zero();
    for (Eigen::Index i = 0; i < ring.rows(); ++i) area += Vector3d(ring.row(i)).cross(Vector3d(ring.row((i + 1) % ring.rows())));
    Eigen::Index farthest = 0; // the first vertex, unless it stands in the middle
    if (!(ring.row(0).norm() > 1e-3 * size)) ring.rowwise().norm().maxCoeff(&farthest);
    Vector3d x = ring.row(farthest).transpose();
    Vector3d z = area;
    if (!(area.norm() > 1e-6 * size * size)) z = Vector3d(ring.row((farthest + ring.rows() / 3) % ring.rows())).cross(x);
    Affine3d pose = Affine3d::Identity();
    if (x.norm() > 0 && z.norm() > 0) {
        z.normalize();
        x -= x.dot(z) * z;
        if (x.norm() > 0) {
            x.normalize();
            Eigen::Matrix3d frame;
            frame.row(0) = x.transpose();
            frame.row(1) = z.cross(x).transpose();
            frame.row(2) = z.transpose();
            pose.linear() = frame / size;
        }
    }
    pose.translation() = -pose.linear() * middle.transpose();
    return pose;
}

Points images(const Affine3d& map, const Points& points) {
    return (points * map.linear().transpose()).rowwise() + map.translation().transpose();
}

/// The systems amplify what turning and scaling a source leaves in the last bits, up to 1e-6 of its size. On a grid a
/// hundred millionth of the loop wide two poses of one source are the same to the last bit.
Points on_grid(const Points& points) {
    constexpr double cells = 1 << 27;
    return (points.array() * cells).round() / cells;
}

WorkingMesh as_working(const TriangleMesh& mesh) {
    PolygonMesh polygons{mesh.points, {0}, {}};
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        for (int c = 0; c < 3; ++c) polygons.corners.push_back(mesh.triangles(t, c));
        polygons.offsets.push_back(3 * (t + 1));
    }
    return make_working_mesh(polygons);
}

} // namespace

void MergeSession::State::prepare(std::span<const int> roi, std::span<const MergeHandle> handles) {
    const bool independent = options.mode == MergeMode::independent;
    source_place = inverse(source_part, source.mesh.vertex_count());
    target_place = inverse(target_part, target.mesh.vertex_count());
    if (independent) {
        source_part.mesh.points = on_grid(images(canonical_pose(source_part.mesh.points, source_part.loops.front()), source_part.mesh.points));
    } else {
        for (int v = 0; v < source_part.mesh.vertex_count(); ++v)
            source_part.mesh.points.row(v) =
                target.to_working(Vector3d(options.placement * source.to_source(source_part.mesh.points.row(v).transpose()))).transpose();
        check_placed();
    }
    source_normals = vertex_normals(source_part.mesh);
    target_normals = vertex_normals(target_part.mesh);
    looks_turned = facing(source.mesh) * facing(target.mesh) < 0;

    posed = std::make_unique<WorkingMesh>(as_working(source_part.mesh));
    std::vector<DeformHandle> held;
    std::set<int> taken;
    for (const std::vector<int>& loop : source_part.loops)
        for (const int v : loop) {
            held.push_back({false, {v}});
            taken.insert(v);
        }
    if (!independent)
        for (const MergeHandle& handle : handles) {
            DeformHandle group;
            for (const int w : painted_vertices(handle.vertices, source, "source"))
                if (const int v = source_place[w]; v >= 0 && taken.insert(v).second) group.vertices.push_back(v);
            if (group.vertices.empty()) continue;
            held.push_back(std::move(group));
            fixed.push_back(handle);
        }
    std::vector<int> movable;
    if (independent || roi.empty()) {
        for (int v = 0; v < source_part.mesh.vertex_count(); ++v) movable.push_back(v);
    } else {
        std::vector<char> inside(static_cast<std::size_t>(source.mesh.vertex_count()), 0);
        for (const int w : painted_vertices(roi, source, "source")) inside[w] = 1;
        for (int v = 0; v < source_part.mesh.vertex_count(); ++v)
            if (const Origin& o = source_part.origin[v]; inside[o.vertex[0]] && inside[o.vertex[1]] && inside[o.vertex[2]]) movable.push_back(v);
    }
    DeformOptions solving{.remove_shear = true, .scale_details = true, .coherence_ring = options.coherence_ring};
    if (options.transition) {
        solving.blend_weight = options.transition->weight;
        for (const auto& [k, v] : blended) // 1 at the seam, where the target's detail continues, 0 at the far edge
            solving.blended.push_back({source_strips[k].part_vertex[v],
                                       std::clamp(1 - source_strips[k].distance[v] * source.scale / options.transition->source_width, 0.0, 1.0)});
    }
    deform.emplace(*posed, movable, held, std::move(solving));
    for (const Finding& w : deform->warnings())
        if (w.code == "nothing-free") warnings.push_back(w);

    if (!independent) return;
    const Components pieces = components(vertex_rings(source_part.mesh));
    std::set<int> reached;
    for (const std::vector<int>& loop : source_part.loops) reached.insert(pieces.of_vertex[loop.front()]);
    for (int v = 0; v < source_part.mesh.vertex_count(); ++v)
        if (!reached.contains(pieces.of_vertex[v])) loose.push_back(v);
    if (!loose.empty()) warnings.push_back({"piece-without-boundary", pieces.count - static_cast<int>(reached.size()), {}, true});
}

} // namespace lissom
