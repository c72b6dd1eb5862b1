#pragma once

#include "lissom/isoline/isoline_model.h"

#include <memory>
#include <span>
#include <vector>

namespace lissom {

struct TransferOptions {
    double strength = 1;       ///< 0: at rest, 1: the whole pose; more exaggerates
    bool keep_stretch = false; ///< takes over stretch and shear as well; else triangles only turn
};

struct TransferSeconds {
    double fields = 0; ///< fields of both models
    double reduce = 0; ///< the fit's matrix and the target's factor
};

/// Gives poses of one model to another by corresponding handles (Isolines 6).
///
/// Both models have the harmonic fields of their handles; what happens at the same field values is taken to correspond. A pose is read as
/// linear maps of the controls, fitted to those of the source's triangles with their normals (not edges: Eq 11 printed for edges is singular
/// wherever surfaces are flat along an isoline):
///
///     minimise Σ_t A_t |Σ_q b_q(φ_t) R_q − F_t|² + β² (n − 1) Σ_ij |R_ij − R_i,j+1|²
///
/// and given to each triangle of the target, where the *blended* map is made a rotation (single R_q mean nothing alone). The target's positions
/// are those whose triangles fit these best (Eq 12, by cotangent weights). Directions alone add up errors along limbs: handles that then lie near where
/// the source's handles went (in shares of the diagonal, beside the turn of the whole) are moved there, the surface following along their fields.
/// A model that is given its own pose has that pose.
///
/// Source: Au et al. 2007 (001), section 6; the last step as in Sumner and Popović, "Deformation transfer for triangle meshes", 2004.
/// Limits: like rest poses, handles of like extent in the same order.
/// Cost: prepare factors one matrix of each model's surface and one of the target; a pose is a pass over both and one solve.
class PoseTransfer {
public:
    /// Call step() until it returns false. @param source, target  kept by reference
    /// @param source_handles, target_handles  source vertices of each handle, in the same order on both
    /// @throws InvalidInput `handle-count` (not as many on both), `no-handle`, `empty-handle`, `vertex-out-of-range`, `handle-overlap`, `handle-too-small`:
    ///                      says on which model
    PoseTransfer(const WorkingMesh& source, std::span<const std::vector<int>> source_handles, const WorkingMesh& target,
                 std::span<const std::vector<int>> target_handles);
    ~PoseTransfer();
    PoseTransfer(PoseTransfer&&) noexcept;

    /// One slice. @returns true while there is more. @throws SolverFailure
    bool step();
    [[nodiscard]] double fraction() const;

    /// The target in each of several poses of the source, in one solve.
    /// @param poses  source positions, n×3 each, vertex by vertex as the source's
    /// @returns      target positions, as many; vertices of pieces without a handle at rest, bit for bit
    /// @throws InvalidInput `wrong-size`, `non-finite-position`, `bad-option`  @throws SolverFailure
    [[nodiscard]] std::vector<Points> transfer(std::span<const Points> poses, const TransferOptions& options = {}) const;

    [[nodiscard]] int unknowns() const;
    [[nodiscard]] const TransferSeconds& seconds() const;
    [[nodiscard]] double memory_bytes() const;
    /// Of the target: `component-without-handle` (examples: a source vertex of each).
    [[nodiscard]] const std::vector<Finding>& warnings() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace lissom
