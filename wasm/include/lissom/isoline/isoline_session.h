#pragma once

#include "lissom/deform/deform_session.h"
#include "lissom/isoline/field_basis.h"
#include "lissom/isoline/isoline_model.h"
#include "lissom/isoline/isolines.h"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace lissom {

enum class LocalStep {
    patches,   ///< rotations of patches from the full frames of their sampled triangles
    isolines,  ///< t2 of the paper: of isolines from the normals of triangles they cross (Isolines Eq 8–10)
    positions  ///< t1 of the paper: of every vertex, the controls standing for positions only; O(n) an iteration
};

struct IsolineOptions {
    BasisKind basis = BasisKind::quadratic;
    int controls = 10;            ///< a handle; `hats` want 20 or more
    double smoothness = 0.03;     ///< β of Isolines Eq 5, no unit, in (0, 1]
    LocalStep local = LocalStep::patches;
    int patches = 150;            ///< read by `patches`, and by `positions` for its first guess
    int sampled_triangles = 600;  ///< n_tri: of all patches or all isolines together
    int solves = 8;               ///< at most this many a frame
    double tolerance = 1e-4;      ///< stop a frame when no sampled point moves farther, in diagonals
    int acceleration = 5;         ///< memory of Anderson's acceleration; 0: the plain iteration
    bool scale_details = false;   ///< details take the handles' scale
    int free_handles = 8;         ///< at most this many where flat isolines leave no rotation; 0: none
    int settle_passes = 1;        ///< full passes on release, 1 to 3
    int settle_limit = 200000;    ///< vertices above which settling only turns details
};

/// What one frame of a drag did.
struct IsolineFrame {
    int solves = 0;
    double change = 0;            ///< of the sampled points in the last solve, in diagonals
    double local_seconds = 0, global_seconds = 0;
    std::vector<Finding> warnings; ///< `handles-pulled-apart`: examples are handle numbers
};

struct IsolineSeconds {
    double fields = 0;   ///< harmonic fields, and free handles
    double reduce = 0;   ///< patches, energy, factor
    double settle = 0;   ///< preparation of settling
};

/// Deformation in the space of the handles' isolines: each frame of a drag costs the same whatever the size of the model.
///
/// Handles and the rest that is held (vertices outside `roi`) have harmonic fields φ_i; the surface moves by
/// x′ = x + Σ_i φ_i Σ_j b_j(φ_i) (D_ij x + t_ij), whose few controls (D, t) minimise the Laplacian energy with details turned as the surface turns.
/// What handles prescribe is exact. A point handle grows to a disc of a hundredth of the diagonal in the fields; its
/// orientation is found. A piece of the model that no handle holds stays at rest (`component-without-handle`).
///
/// Source: Au et al., "Handle-Aware Isolines for Scalable Shape Editing", ACM Trans. Graph. 26(3), 2007 (001). Changed: the energy is free of
/// unit and tessellation, handles are substituted, patches with full frames take the place of isolines with normals, quadratic
/// B-splines that of linear ones, free handles mend the planar limitation.
/// Cost: prepare factors one matrix of the surface and a dense one of 40 unknowns a handle; a frame is some products of that size.
class IsolineSession {
public:
    /// Call step() until it returns false before drag().
    /// @param model    prepared; kept by reference with its working mesh: both must outlive the session
    /// @param roi      source vertices that may move (handles are added to it)
    /// @throws InvalidInput `no-handle`, `empty-handle`, `vertex-out-of-range`, `handle-overlap`, `point-handle-size`, `bad-option`,
    ///                      `handle-too-small` (it has no place of its own on the proxy)
    IsolineSession(const IsolineModel& model, std::span<const int> roi, std::span<const DeformHandle> handles, IsolineOptions options = {});
    ~IsolineSession();
    IsolineSession(IsolineSession&&) noexcept;

    /// One slice of the preparation. @returns true while there is more. @throws SolverFailure
    bool step();
    /// Of the preparation; of settling's once that has begun.
    [[nodiscard]] double fraction() const;

    /// Moves the handles; reads no vertex of the model. Starts from where the last drag ended.
    /// @param targets  one affine map per handle, from the REST pose, source space; a point handle reads the image of its rest position
    /// @param solves   at most this many, 0: as the options say
    /// @param afresh   forget the last drag: turns are then at most half a turn
    /// @throws InvalidInput `handle-count`, `non-finite-target`  @throws SolverFailure
    IsolineFrame drag(std::span<const Eigen::Affine3d> targets, int solves = 0, bool afresh = false);

    /// n×3 source positions as dragged last: handled ones where their handles have them; unused ones at rest, bit for bit.
    [[nodiscard]] Points positions() const;
    /// Unit normals of the last drag from the gradient of the blend, cof(I + Σ w D + Σ_i ∂x′/∂φ_i ∇φ_iᵀ) n: what a shader is checked against.
    /// @param rest_normals  of the working vertices; @returns as many
    [[nodiscard]] Points blended_normals(const Points& rest_normals) const;

    /// Prepares settling, a slice at a time, whenever there is time for it. @returns true while there is more. @throws SolverFailure
    bool settle_step();
    /// Whether settling is a full pass (else details are turned).
    [[nodiscard]] bool settles_fully() const;
    /// The last drag with what the reduced space leaves out. Requires that settle_step() has returned false.
    /// @throws SolverFailure
    [[nodiscard]] Points settled() const;

    // For drawing: the blend in numbers. Fields: handles in their order, then the rest if any is held, then free handles. -------------

    [[nodiscard]] const ControlSets& sets() const;
    [[nodiscard]] int field_count() const;
    [[nodiscard]] int free_handle_count() const;
    [[nodiscard]] bool holds_rest() const;
    /// The field of each set per source vertex, row by row; rows of an unheld piece are 0, others sum to 1 but for rounding where sets are not
    /// mirrored. n × sets.
    [[nodiscard]] std::vector<float> set_fields() const;
    /// ∇ of them, three numbers a set, 1/source length. n × 3·sets.
    [[nodiscard]] std::vector<float> set_gradients() const;
    /// Per source vertex: 1 where no field reaches, so that it stays at rest.
    [[nodiscard]] std::vector<std::uint8_t> still_vertices() const;
    /// φ_f per source vertex as a number.
    [[nodiscard]] Eigen::VectorXf field(int f) const;
    /// ψ_f of Isolines 4.1 per source vertex (1/source length); f = −1: combined.
    [[nodiscard]] Eigen::VectorXf rigidity(int f) const;
    /// (D, t) of each control in source space: twelve numbers, three rows of four.
    [[nodiscard]] std::vector<double> control_offsets() const;
    /// Isolines of field f at rest at `count` equal steps from 0 to 1, ends left out, on the surface that is worked on; source space.
    [[nodiscard]] std::vector<Isoline> isolines(int f, int count) const;

    [[nodiscard]] int unknowns() const;
    [[nodiscard]] int sampled_triangles() const;
    [[nodiscard]] const IsolineSeconds& seconds() const;
    [[nodiscard]] double memory_bytes() const;
    /// `component-without-handle`, `nothing-free`, `handles-touch` (examples: handle numbers), `free-handles` (how many were placed).
    [[nodiscard]] const std::vector<Finding>& warnings() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace lissom
