#include "lissom/isoline/patches.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace lissom {
namespace {

/// Farthest vertices in the metric, one after the other, each taking the vertices that are nearer to it than to those before.
class FarthestCells {
public:
    FarthestCells(const TriangleMesh& mesh, const Columns& fields, const std::vector<int>& region, double position_share, Patches& patches)
        : mesh_(mesh), fields_(fields), share_(position_share), patches_(patches) {
        for (int v = 0; v < mesh.vertex_count(); ++v) {
            if (region[v] >= 0) patches.of_vertex[v] = region[v];
            else if ((fields.row(v).array() != 0).any()) free_.push_back(v);
        }
        distance_.assign(free_.size(), INFINITY);
    }

    void grow(int cells) {
        // The first where no handle rules: its place hardly matters, but it must not depend on the numbering.
        std::size_t next = 0;
        for (std::size_t k = 1; k < free_.size(); ++k)
            if (fields_.row(free_[k]).maxCoeff() < fields_.row(free_[next]).maxCoeff()) next = k;
        for (int c = 0; c < cells && !free_.empty() && distance_[next] > 0; ++c) {
            take(free_[next], patches_.count++);
            next = static_cast<std::size_t>(std::max_element(distance_.begin(), distance_.end()) - distance_.begin());
        }
    }

private:
    void take(int seed, int patch) {
        for (std::size_t k = 0; k < free_.size(); ++k) {
            const int v = free_[k];
            const double along = share_ * (mesh_.points.row(v) - mesh_.points.row(seed)).norm();
            if (along >= distance_[k]) continue;
            const double d = along + (fields_.row(v) - fields_.row(seed)).norm();
            if (d >= distance_[k]) continue;
            distance_[k] = d;
            patches_.of_vertex[v] = patch;
        }
    }

    const TriangleMesh& mesh_;
    const Columns& fields_;
    double share_;
    Patches& patches_;
    std::vector<int> free_;
    std::vector<double> distance_;
};

/// Lowest height per longest edge of a triangle whose frame says something.
constexpr double k_thin = 1e-3;

bool has_frame(const TriangleMesh& mesh, int t) {
    const Eigen::Vector3d a = mesh.points.row(mesh.triangles(t, 1)) - mesh.points.row(mesh.triangles(t, 0));
    const Eigen::Vector3d b = mesh.points.row(mesh.triangles(t, 2)) - mesh.points.row(mesh.triangles(t, 0));
    return a.cross(b).norm() > k_thin * std::max({a.squaredNorm(), b.squaredNorm(), (a - b).squaredNorm()});
}

/// Spread over the patch: the one nearest its middle, then always the farthest from those taken.
std::vector<int> spread(const TriangleMesh& mesh, const std::vector<int>& candidates, int count) {
    const auto m = static_cast<Eigen::Index>(candidates.size());
    Points centres(m, 3);
    for (Eigen::Index k = 0; k < m; ++k)
        centres.row(k) = (mesh.points.row(mesh.triangles(candidates[k], 0)) + mesh.points.row(mesh.triangles(candidates[k], 1)) +
                          mesh.points.row(mesh.triangles(candidates[k], 2))) / 3;
    std::vector<int> taken;
    if (m == 0) return taken;
    Eigen::Index next = 0;
    Eigen::VectorXd distance = (centres.rowwise() - centres.colwise().mean().eval()).rowwise().squaredNorm();
    distance.minCoeff(&next);
    distance.setConstant(INFINITY);
    while (static_cast<int>(taken.size()) < count && distance[next] > 0) {
        taken.push_back(candidates[next]);
        distance = distance.cwiseMin((centres.rowwise() - centres.row(next).eval()).rowwise().squaredNorm());
        distance.maxCoeff(&next);
    }
    return taken;
}

} // namespace

Patches cut_patches(const TriangleMesh& mesh, const Columns& fields, const std::vector<int>& region, int handles, const PatchOptions& options) {
    Patches patches;
    patches.of_vertex.assign(static_cast<std::size_t>(mesh.vertex_count()), -1);
    patches.count = handles;
    FarthestCells(mesh, fields, region, options.position_share, patches).grow(options.count);

    // Triangles all of one patch, and those that touch it for a patch that has none.
    std::vector<std::vector<int>> inside(static_cast<std::size_t>(patches.count)), touching(inside.size());
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        if (!has_frame(mesh, t)) continue;
        int p[3];
        for (int k = 0; k < 3; ++k) p[k] = patches.of_vertex[mesh.triangles(t, k)];
        if (p[0] == p[1] && p[1] == p[2]) {
            if (p[0] >= handles) inside[p[0]].push_back(t);
            continue;
        }
        for (int k = 0; k < 3; ++k)
            if (p[k] >= handles && p[k] != p[(k + 1) % 3] && (k == 0 || p[k] != p[0])) touching[p[k]].push_back(t);
    }
    for (std::size_t c = 0; c < inside.size(); ++c)
        patches.triangles.push_back(spread(mesh, inside[c].empty() ? touching[c] : inside[c], options.triangles));
    return patches;
}

} // namespace lissom
