#pragma once

#include "lissom/curve/encoding.h"
#include "lissom/curve/links.h"
#include "lissom/curve/ownership.h"
#include "lissom/mesh/working_mesh.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace lissom {

enum class CurveEncoding {
    kernel, ///< continuous places, motions blended along the curve
    slabs   ///< the thesis's 200 planes, to compare with
};

enum class CurveRole {
    limb,   ///< takes its region along, turned as the curve turns
    contour ///< a line of the drawing: the surface around it is pulled along, not turned (line_weights.h)
};

/// A curve as a recipe has it, in source space.
struct CurveSpec {
    Points rest;                                      ///< control points, two or more
    CurveRole role = CurveRole::limb;                 ///< of a cloud all are limbs
    std::vector<int> rigid = {};                      ///< spans that stay nearly straight
    std::optional<std::vector<int>> region = {};      ///< source vertices that follow it; else found
    std::optional<CurveEnd> anchor = {};              ///< the end that stays; else the one on the larger rest
    double reach = 0;                                 ///< of a contour: how far its pull goes along the surface, source units; 0: as line_weights.h has it
    std::vector<Points> held = {};                    ///< of a contour: lines beside it that stay, control points each
};

struct CurveOptions {
    CurveBlending blending = CurveBlending::ownership;
    CurveEncoding encoding = CurveEncoding::kernel;
    CurveGuard guard = CurveGuard::symmetric;
    double kappa = 1.5;  ///< reach of a region in radii of the limb
    double kernel = 1;   ///< half width over which motions are blended along a curve, in radii
    double blend = 1;    ///< width over which linked curves blend, in radii of the limb at the link
};

struct CurveSeconds {
    double regions = 0; ///< surface, radii, regions
    double encode = 0;  ///< places, shares
};

/// What bounds a pose: above `CurveSession::k_bend` without a guard, or `k_tilt` with one, the surface folds.
struct CurveStrain {
    double bend = 0; ///< largest curvature times reach to the inside, of all curves
    double tilt = 0; ///< most that the guard turned a plane by, degrees
};

struct PosedPoints {
    Points positions; ///< n×3, source space
    CurveStrain strain;
};

/// A pose as data for a vertex shader: `k_texels` texels of four numbers a row, rows of a curve one after the other, curves likewise.
/// x′ = c + q(Σ w_k P_k (x − c)), with P from texels 2–4 (rows of a 3×4) and q = Σ w_k (real, dual), texels 0 and 1, each of the sign that
/// agrees with those before, then of unit length; all interpolated between two rows; what the weights leave to 1 is the identity's.
/// A vertex of one weight 1 stands between where its two rows put it: x′ = c + (1 − f) q_i(P_i (x − c)) + f q_{i+1}(P_{i+1} (x − c)).
struct CurveTable {
    static constexpr int k_texels = 5;
    std::vector<float> texels;
    CurveStrain strain;
};

/// Who moves each source vertex, for that shader: 4 a vertex; weights sum to 1, or to less where some of it rests.
struct CurveAttributes {
    std::vector<std::uint16_t> curves;
    std::vector<float> rows;    ///< in [0, 255]: apart from the curve, or many curves would leave few digits to the row
    std::vector<float> weights; ///< 0 where there is none
    Eigen::Vector3d centre;     ///< c
    std::vector<double> frames; ///< of each row at rest: origin (source space), u, v, w; 12 a row. What bones are made from
    std::vector<double> slopes; ///< of each row at rest: EncodedCurve::RowSlope, less the centre; 9 a row. What normals are turned by
};

/// Curves on a model: prepared once, posed many times.
///
/// A curve on its own moves its region; what is left beyond its ends follows the ends rigidly, and what touches both is blended between
/// them with smoothstep(g₀/(g₀+g₁)), g the ways to either. Curves that are linked share the model: each vertex belongs to the curve of
/// least distance minus radius, and shares are blended. A child is posed in the frame of its parent at rest: what it takes over from the
/// parent (turn and place at the link) comes on top.
/// A contour pulls what its line weights say; the rest of each vertex stays with its owner, or at rest.
/// Welded vertices move as one, so coincident vertices stay coincident on any mesh: soups, one-sided, non-manifold or in several pieces.
///
/// Source: Blanco 3.1, 5.2–5.5. Changed: throughout; see docs/curves.md.
/// Cost: prepare one nearest point per vertex of a region and, where curves are linked, one sparse factorization; a pose about 60 ns a
/// vertex where shares are blended, 10 where they are not.
class CurveSession {
public:
    static constexpr double k_bend = 0.95; ///< flips begin at 1 exactly
    static constexpr double k_tilt = 30;   ///< degrees

    /// Call step() until it returns false before anything else.
    /// @throws InvalidInput `no-curve`, `curve-points`, `non-finite-curve`, `rigid-span`, `vertex-out-of-range`, `link-range`, `link-twice`,
    ///                      `link-ring`, `bad-option`, `line-radius`
    CurveSession(std::shared_ptr<const WorkingMesh> model, std::vector<CurveSpec> curves, std::vector<CurveLink> links = {}, CurveOptions options = {});
    /// Points alone: a cloud, or the vertices of polylines. What is not finite rests.
    CurveSession(const Points& cloud, std::vector<CurveSpec> curves, std::vector<CurveLink> links = {}, CurveOptions options = {});
    ~CurveSession();
    CurveSession(CurveSession&&) noexcept;

    /// One piece of the preparation. @returns true while there is more. @throws InvalidInput `curve-without-length`  @throws SolverFailure
    bool step();
    [[nodiscard]] double fraction() const;

    [[nodiscard]] int curve_count() const;

    /// n×3 source positions. Vertices that no curve moves are as given, bit for bit.
    /// @param postures  one per curve, source space; a child's in the frame of its parent at rest
    /// @throws InvalidInput `posed-points`, `curve-twist`, `curve-scale`, `non-finite-curve`, `curve-count`
    [[nodiscard]] Points positions(std::span<const CurvePosture> postures) const { return posed(postures).positions; }
    /// The same, and what it strains.
    [[nodiscard]] PosedPoints posed(std::span<const CurvePosture> postures) const;
    [[nodiscard]] CurveStrain strain(std::span<const CurvePosture> postures) const;
    [[nodiscard]] CurveTable table(std::span<const CurvePosture> postures) const;
    [[nodiscard]] CurveAttributes attributes() const;

    /// Unit normals of the pose: rest normals times the cofactors of ∂x′/∂x, with the change of place along the curve in it
    /// (EncodedCurve::row_gradient). Without the change of shares, so that beside a link they are near those of the posed surface, elsewhere equal to them but for the mesh.
    /// @param normals  n×3, of source vertices at rest
    [[nodiscard]] Points normals(std::span<const CurvePosture> postures, const Points& normals) const;

    /// How far towards `to` a drag may go from `from` in a straight line, in [0, 1]: the largest share at which neither fold nor tilt is
    /// beyond what `from` has or the limit allows.
    [[nodiscard]] double drag_limit(std::span<const CurvePosture> from, std::span<const CurvePosture> to) const;

    /// What the parent of a linked curve does to it: maps from the child's own space (the parent at rest) to the posed one. The identity for roots.
    [[nodiscard]] std::vector<Eigen::Affine3d> parent_motions(std::span<const CurvePosture> postures) const;

    /// Source vertices that a curve moves by itself, not through its ends; ascending.
    [[nodiscard]] std::vector<int> region(int curve) const;
    [[nodiscard]] CurveEnd anchor(int curve) const;
    /// Radius of the limb at each control point, source units.
    [[nodiscard]] std::vector<double> radii(int curve) const;
    [[nodiscard]] const CurveSeconds& seconds() const;
    [[nodiscard]] double memory_bytes() const;
    /// `empty-region` (examples: curve numbers).
    [[nodiscard]] const std::vector<Finding>& warnings() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace lissom
