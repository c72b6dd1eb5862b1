#pragma once

#include "lissom/mesh/working_mesh.h"

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace lissom {

enum class DeformMethod {
    implicit,  ///< Fu ch. 2: implicit gradients, shear removal, reconstruction
    iterative, ///< the same, re-estimating the rotations from the last result `iterations` times
    naive      ///< Eq 2.1: Laplacian coordinates kept as they are (the baseline to compare with); no first system
};

/// A vertex whose detail is mixed with one from elsewhere, as in a transition between two surfaces (Fu 3.3.3).
struct BlendedDetail {
    int vertex = 0;   ///< source index; free
    double share = 0; ///< of the other detail, in [0, 1]
};

struct DeformOptions {
    DeformMethod method = DeformMethod::implicit;
    bool remove_shear = true;   ///< polar decomposition and second solve (Eq 2.10/2.11); read by `implicit` only
    bool scale_details = false; ///< Eq 2.11 (details take the local scale) instead of Eq 2.10
    int iterations = 1;         ///< reconstructions, ≥ 1; read by `iterative` only
    int coherence_ring = 1;     ///< 1 or 2: which neighbours share gradients (Eq 2.7)
    std::vector<BlendedDetail> blended{}; ///< each vertex at most once; see `deform`
    double blend_weight = 0.1;  ///< w_T of E_T, which draws gradients of blended vertices to the other detail (Fu 3.3.3)
};

/// One handle: source vertices that the user moves.
struct DeformHandle {
    bool is_point = false;     ///< point: position only, orientation found by the solve; region: affine map
    std::vector<int> vertices; ///< source indices; a point handle has exactly one
};

/// What a drag did, beside the positions.
struct DeformResult {
    Points positions;                ///< n×3 SOURCE vertices; those that are not free nor handled: rest, bit for bit
    double solve_seconds = 0;        ///< both solves
    double rotate_seconds = 0;       ///< gradients and polar decompositions
    double reconstruct_seconds = 0;  ///< right-hand side of Eq 2.10/2.11 and writing back
    int iterations = 0;              ///< reconstructions done; 0 for a sheared result
    std::vector<Finding> warnings;   ///< of these targets: `rotation-near-180`, its examples are handle numbers
};

/// Implicit Laplacian deformation of a region of interest by handles.
///
/// Minimises E_L + E_R (Eq 2.6–2.8) with handle positions and gradients substituted exactly, then removes
/// shear and solves D(v) = R_i s_i δ_i (Eq 2.10/2.11). E_L is divided by the mean edge length (with
/// area-averaged cotangent Laplacian) so that the result does not depend on the unit of length.
///
/// Vertices outside the region stay where they are and hold the rest. A piece held by nothing stays at rest
/// (`component-without-handle`). A piece held by so few points that its orientation is open (fewer than
/// four, or all in a plane) takes that of the least rotation that fits them: one point moves it, two turn it.
/// Of an unused vertex only a region handle that names it knows: it follows.
///
/// Source: Fu, thesis ch. 2 (000); Fu et al., Computer Graphics Forum 26(1), 2007 (002).
/// Limits: rotations between neighbouring handles below 180 degrees.
/// Cost:   prepare factors two matrices once per handle set; deform() is two solves and one polar
///         decomposition per free vertex; where `corrects`, each solve that settles is two or three.
class DeformSession {
public:
    /// Assembles and analyzes; call step() until it returns false before deform().
    ///
    /// @param working  kept by reference: must outlive the session
    /// @param roi      source vertices that may move (handles are added to it); null span of all = pass every index
    /// @param handles  disjoint; vertices that welding joins belong together
    /// @throws InvalidInput `no-handle`, `empty-handle`, `vertex-out-of-range`, `handle-overlap`,
    ///                      `point-handle-size`, `bad-option`
    DeformSession(const WorkingMesh& working, std::span<const int> roi, std::span<const DeformHandle> handles,
                  DeformOptions options = {});
    ~DeformSession();
    DeformSession(DeformSession&&) noexcept;

    /// One slice of the factorizations. @returns true while there is more. @throws SolverFailure
    bool step();
    [[nodiscard]] double fraction() const;

    /// @param targets  one affine map per handle, from the REST pose, source space; a point handle reads the
    ///                 image of its rest position, so a translation places it
    /// @param settle   false: only the first solve (sheared preview, as the paper does while the mouse moves)
    /// @param details  one row per blended vertex: the detail L v to mix in, where the result is; null where none is blended
    /// @throws InvalidInput `handle-count`, `non-finite-target`, `detail-count`
    /// @throws SolverFailure  the result is not finite
    [[nodiscard]] DeformResult deform(std::span<const Eigen::Affine3d> targets, bool settle = true, const Points* details = nullptr) const;

    [[nodiscard]] int free_vertices() const;
    [[nodiscard]] int degenerate_vertices() const; ///< displaced by Eq 2.9
    [[nodiscard]] double assemble_seconds() const;
    [[nodiscard]] double factor_seconds() const;
    /// Whether one of the systems lacks digits (very short edges beside needles), so that settled results are corrected.
    [[nodiscard]] bool corrects() const;
    [[nodiscard]] double memory_bytes() const;     ///< factors and matrices
    /// Things the user should know: `component-without-handle` (examples: a source vertex of each),
    /// `tiny-boundary` (handles whose rim is so small beside its region that local refinement there would
    /// help; examples: handle numbers), `nothing-free`, `factor-shifted` (after the last step); same shape as
    /// the import findings.
    [[nodiscard]] const std::vector<Finding>& warnings() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace lissom
