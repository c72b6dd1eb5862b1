#pragma once

#include "lissom/deform/deform_session.h"
#include "lissom/mesh/topology.h"

#include <span>
#include <vector>

namespace lissom {

/// What decides a vertex.
enum class Role : char {
    fixed, ///< rest: outside the region of interest, or on a piece that nothing holds
    free,  ///< the solve
    region, ///< a handle's affine map: position and gradient
    point  ///< a point handle's position; the gradient comes from the solve
};

/// A connected set of free vertices (and point handles between them) and what holds it.
struct HeldPiece {
    int free_count = 0;
    bool touches_fixed = false;
    std::vector<int> region_handles; ///< adjacent ones, ascending
    std::vector<int> point_handles;  ///< handles in it, ascending
    std::vector<int> rim_sizes;      ///< vertices of each region handle that touch the piece, as region_handles
    int pose = -1;                   ///< number of its pose (see HeldRegion::poses), −1: needs none
    [[nodiscard]] bool has_frame() const { return touches_fixed || !region_handles.empty(); }
};

/// The part of a working mesh that a deformation has to look at: the free vertices and two rings about them.
/// What lies farther away costs nothing.
///
/// A *slot* numbers what can move: first the free vertices (slot = unknown), then the handle vertices
/// of this part; fixed vertices have none.
struct HeldRegion {
    TriangleMesh mesh;          ///< vertices of this part, in the working mesh's order
    VertexRings rings;
    std::vector<int> working;   ///< working vertex of each vertex here
    std::vector<Role> role;
    std::vector<int> handle;    ///< of region and point vertices; −1 elsewhere
    std::vector<int> slot;      ///< −1: fixed
    std::vector<int> vertex_of_slot;
    std::vector<int> piece;     ///< of free and point vertices; −1 elsewhere
    std::vector<HeldPiece> pieces;
    std::vector<int> poses;     ///< pieces held by so few points that their orientation needs the weak rest term
    int unknowns = 0;           ///< free vertices
    int handle_count = 0;       ///< the user's handles

    [[nodiscard]] int slots() const { return static_cast<int>(vertex_of_slot.size()); }
    /// Unknowns and four columns for each handle and each pose.
    [[nodiscard]] int columns() const { return unknowns + 4 * (handle_count + static_cast<int>(poses.size())); }
    [[nodiscard]] int handle_column(int h) const { return unknowns + 4 * h; }
};

/// Roles on the whole working mesh, in working indices.
struct Roles {
    std::vector<Role> role;
    std::vector<int> handle;
};

/// @throws InvalidInput `no-handle`, `empty-handle`, `vertex-out-of-range`, `handle-overlap`, `point-handle-size`
[[nodiscard]] Roles assign_roles(const WorkingMesh& working, std::span<const int> roi,
                                 std::span<const DeformHandle> handles);

/// Cuts out what matters, finds its pieces by connectivity (never by pivots: no threshold tells a floating
/// piece from a badly shaped one), and puts pieces without any handle to rest.
/// @param warnings  receives `component-without-handle`, `tiny-boundary`, `nothing-free`
[[nodiscard]] HeldRegion hold_region(const WorkingMesh& working, const Roles& roles, int handle_count,
                                     std::vector<Finding>& warnings);

} // namespace lissom
