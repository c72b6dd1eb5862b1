#pragma once

#include "lissom/deform/deform_session.h"

#include <memory>
#include <span>
#include <vector>

namespace lissom {

/// One iteration of the unreduced method (Isolines 3): every vertex takes the rotation that its triangles show, and the
/// surface is fitted to the details so turned, the handles exact. From a reduced result one pass is what is missing to the full quality.
///
/// Limits: to be iterated to its end only as a reference: free limbs shrivel in its limit where the reduced space holds them.
/// Cost: a factorization once per handle set (memory and time of `DeformSession`'s second system), then one solve and a polar decomposition a
/// vertex each pass.
class FullPass {
public:
    /// Assembles and analyzes; call step() until it returns false. Arguments as DeformSession.
    /// @param working  kept by reference
    FullPass(const WorkingMesh& working, std::span<const int> roi, std::span<const DeformHandle> handles);
    ~FullPass();
    FullPass(FullPass&&) noexcept;

    /// @returns true while there is more. @throws SolverFailure
    bool step();
    [[nodiscard]] double fraction() const;
    [[nodiscard]] double memory_bytes() const;

    /// @param positions  n×3 source positions to read rotations from; not changed where nothing is free
    /// @param targets    as DeformSession::deform; a region handle gives its vertices' rotation, too
    /// @param passes     ≥ 1
    /// @throws SolverFailure  the result is not finite
    [[nodiscard]] Points apply(const Points& positions, std::span<const Eigen::Affine3d> targets, int passes = 1) const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// Of a surface too large for a full pass: `moved` with its details (what Taubin smoothing takes off) turned by the rotation that the
/// smooth surface under them shows, vertex by vertex.
/// @param rest, moved   working vertices before and after
/// @param rest_base     the smooth surface at rest; @param moved_base  the same after the deformation
/// @param kept          vertices that stay where `moved` has them (handles)
[[nodiscard]] Points with_turned_details(const TriangleMesh& rest, const Points& moved, const Points& rest_base, const Points& moved_base,
                                         const std::vector<bool>& kept);

} // namespace lissom
