#pragma once

#include "lissom/mesh/topology.h"
#include "lissom/mesh/types.h"

#include <vector>

namespace lissom {

/// A coarser mesh of some of the vertices of a fine one, where they are.
struct Proxy {
    TriangleMesh mesh;
    std::vector<int> fine; ///< vertex of the fine mesh that each vertex is
};

/// The fine mesh itself, without the vertices that no triangle uses.
[[nodiscard]] Proxy whole(const TriangleMesh& mesh);

/// Collapses edges, least quadric error first, down to about `triangles` (meshoptimizer's simplifier, which also favours even
/// triangles). Fewer collapses where the topology allows no more.
[[nodiscard]] Proxy simplified(const Proxy& from, int triangles);

/// Where on a proxy each vertex of the fine mesh lies: a triangle and the weights of its corners 1 and 2.
struct SurfaceBinding {
    std::vector<int> triangle; ///< −1: its piece of the mesh has no triangle in the proxy
    Eigen::Matrix<float, Eigen::Dynamic, 2, Eigen::RowMajor> weights;
};

/// Binds the vertices of a fine mesh to the nearest points of a proxy *along the surface*: each vertex starts from the triangle
/// of a neighbour that is bound already and walks downhill over the proxy, so that fingers that touch are not mixed up.
///
/// Cost: linear, some twenty triangles a vertex.
class SurfaceBinder {
public:
    /// All are kept by reference.
    SurfaceBinder(const Points& fine, const VertexRings& rings, const Proxy& proxy);
    /// Binds some more vertices. @returns true while there is more; then `binding`
    bool step(int vertices = 50000);
    [[nodiscard]] double fraction() const;
    [[nodiscard]] SurfaceBinding take() { return std::move(binding_); }

private:
    struct Place {
        int triangle;
        double distance;
        Eigen::Vector2f weights;
    };
    [[nodiscard]] Place nearest_on(int triangle, const Eigen::Vector3d& p) const;
    void bind(int v);

    const Points& fine_;
    const VertexRings& rings_;
    const Proxy& proxy_;
    std::vector<int> around_offsets_, around_; ///< triangles around each proxy vertex
    std::vector<int> queue_;
    std::size_t next_ = 0;
    std::vector<char> queued_;
    SurfaceBinding binding_;
};

} // namespace lissom
