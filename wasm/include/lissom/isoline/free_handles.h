#pragma once

#include "lissom/mesh/topology.h"
#include "lissom/solve/sparse_cholesky.h"

#include <algorithm>
#include <vector>

namespace lissom {

/// How much of a surface turns only if an isoline turns differently along itself: 1 where an isoline lies in a flat place (a
/// circle drawn on a plate, whose points must tilt outward all around), 0 where it goes around a limb (a cross
/// section, which turns as one). The length of the mean normal of the piece of isoline through each vertex, over the fields
/// weighted by |∇φ|²: the planar limitation of Isolines 5, as a number. No unit.
/// @param rings  of the mesh
/// @param least_length  pieces of isolines shorter than this count as not flat (unit of the mesh)
/// @returns one number a vertex
[[nodiscard]] Eigen::VectorXd isoline_flatness(const TriangleMesh& mesh, const VertexRings& rings, const Columns& fields, double least_length = 0);

struct FreeHandleOptions {
    int most = 8;              ///< handles placed
    double flat = 0.8;         ///< isoline_flatness above which a vertex needs them
    double least_length = 0.25; ///< of an isoline that counts, D = 1: a bump has rings of its own that need no handle
    double least_area = 0.1;   ///< share of the surface that must be flat before any is placed
    double radius = 0.02;      ///< of the disc of each, D = 1
};

/// Discs of vertices to serve as handles that nobody holds: spread over the flat part between the handles, farthest points first, so that the
/// isolines around a lifted middle are cut into pieces which tilt on their own.
/// @param mesh    D = 1
/// @param handle  per vertex its handle or −1
/// @returns one list of vertices per free handle; none where the fields reach everything
[[nodiscard]] std::vector<std::vector<int>> place_free_handles(const TriangleMesh& mesh, const VertexRings& rings, const Columns& fields,
                                                               const std::vector<int>& handle, const FreeHandleOptions& options = {});

/// Vertices within `radius` of p along the edges, walking from `seeds` over vertices that `allowed` lets pass; the seeds included.
template <class Allowed>
std::vector<int> disc_around(const TriangleMesh& mesh, const VertexRings& rings, const Eigen::Vector3d& p, const std::vector<int>& seeds, double radius,
                             Allowed allowed) {
    std::vector<int> disc = seeds;
    for (std::size_t next = 0; next < disc.size(); ++next)
        for (const int w : rings[disc[next]])
            if (allowed(w) && (mesh.points.row(w).transpose() - p).norm() <= radius && std::find(disc.begin(), disc.end(), w) == disc.end())
                disc.push_back(w);
    return disc;
}

} // namespace lissom
