#include "lissom/hair/hair_volume.h"

#include "lissom/mesh/errors.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>

namespace lissom {

using Eigen::Vector3d;
using Eigen::Vector3i;

namespace {

// A scalp is about three quarters of a head's height; a body is many scalps high.
constexpr double k_head_in_scalps = 1.35, k_most_scalps = 2.5;
/// Of the distance from the origin: six digits of sixteen are left for a scalp this wide.
constexpr double k_least_digits = 1e-10;
constexpr int k_distance_nodes = 112;  // of the distance grid, longest side
constexpr double k_margin = 0.12;      // of the distance grid round the head, in head heights
constexpr double k_aside = 0.45, k_above = 0.25, k_below = 0.8; // of the field's grid, in head heights

struct Box {
    Vector3d low = Vector3d::Constant(INFINITY), high = Vector3d::Constant(-INFINITY);
    void add(const Vector3d& p) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
    }
    [[nodiscard]] Vector3d extent() const { return high - low; }
};

/// The grid over a box with `nodes` along its longest side, centred on it.
Grid grid_over(const Box& box, int nodes) {
    Grid grid;
    grid.step = box.extent().maxCoeff() / (nodes - 1);
    grid.size = (box.extent() / grid.step).array().round().cast<int>() + 1;
    grid.size = grid.size.cwiseMax(4).cwiseMin(nodes);
    grid.origin = (box.low + box.high) / 2 - grid.step / 2 * (grid.size.array() - 1).cast<double>().matrix();
    return grid;
}

TriangleMesh inside(const TriangleMesh& mesh, const Box& box) {
    TriangleMesh kept{mesh.points, Triangles(mesh.triangles.rows(), 3)};
    Eigen::Index count = 0;
    for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
        bool all = true;
        for (int k = 0; k < 3; ++k) {
            const Vector3d p = mesh.points.row(mesh.triangles(t, k));
            all = all && (p.array() >= box.low.array()).all() && (p.array() <= box.high.array()).all();
        }
        if (all) kept.triangles.row(count++) = mesh.triangles.row(t);
    }
    kept.triangles.conservativeResize(count, 3);
    return kept;
}

} // namespace

HairVolume hair_volume(const TriangleMesh& mesh, std::span<const int> scalp, int resolution, UpAxis up_axis) {
    if (resolution < 16 || resolution > 96)
        throw InvalidInput("bad-resolution", "A hair grid has 16 to 96 nodes along its longest side, not " +
                                                 std::to_string(resolution) + ".");
    if (scalp.empty())
        throw InvalidInput("scalp-empty", "The head has no scalp. Paint where hair grows, or choose a head that brings a scalp.");
    const int up = static_cast<int>(up_axis);
    Box roots, all;
    for (const int v : scalp) {
        if (v < 0 || v >= mesh.vertex_count())
            throw InvalidInput("scalp-vertex", "Scalp vertex " + std::to_string(v) + " is not in the head, which has " +
                                                   std::to_string(mesh.vertex_count()) + " vertices.");
        roots.add(mesh.points.row(v).transpose());
    }
    for (Eigen::Index t = 0; t < mesh.triangles.size(); ++t)
        all.add(mesh.points.row(mesh.triangles.data()[t]).transpose());
    const double scalp_size = roots.extent().maxCoeff();
    if (!(scalp_size > 0))
        throw InvalidInput("scalp-empty", "The scalp has no area. Paint at least one whole triangle.");
    const double farthest = all.low.cwiseAbs().cwiseMax(all.high.cwiseAbs()).maxCoeff();
    if (!(scalp_size > k_least_digits * farthest)) {
        std::ostringstream message;
        message << "The scalp is " << scalp_size << " wide, but the head has vertices " << farthest
                << " from its origin: numbers do not tell its places apart. Move those vertices to the others, or delete them.";
        throw InvalidInput("scalp-too-small", message.str());
    }

    HairVolume out;
    out.up = up_axis;
    const bool is_head = all.extent()[up] <= k_most_scalps * scalp_size;
    out.head_height = is_head ? all.extent()[up] : k_head_in_scalps * scalp_size;
    const double h = out.head_height;

    Box reach = all; // of the mesh that matters
    if (!is_head || all.extent().maxCoeff() > 2 * h) {
        reach.low = all.low.cwiseMax((roots.low.array() - 0.6 * h).matrix());
        reach.high = all.high.cwiseMin((roots.high.array() + 0.6 * h).matrix());
        reach.low[up] = std::max(all.low[up], roots.high[up] - h);
    }
    out.head = inside(mesh, reach);

    Box volume = reach, close = reach;
    volume.low.array() -= k_aside * h;
    volume.high.array() += k_aside * h;
    volume.low[up] = reach.low[up] - k_below * h;
    volume.high[up] = reach.high[up] + k_above * h;
    close.low.array() -= k_margin * h;
    close.high.array() += k_margin * h;
    out.field = grid_over(volume, resolution);
    out.distance = grid_over(close, k_distance_nodes);
    return out;
}

} // namespace lissom
