#pragma once

#include "lissom/curve/dual_quaternion.h"
#include "lissom/curve/frames.h"
#include "lissom/curve/guard.h"
#include "lissom/curve/spline.h"

#include <array>
#include <span>
#include <vector>

namespace lissom {

enum class CurveEnd { start, end };

/// What is known of a curve before it is posed.
struct EncodedCurveOptions {
    std::vector<int> rigid = {};           ///< spans that stay nearly straight
    std::vector<double> radius = {};       ///< of the limb at each control point, > 0, unit of the points
    CurveEnd anchor = CurveEnd::start;     ///< the end that frames are carried from
    bool held = false;                     ///< the anchored end keeps its direction, so that the body beyond it stays still
    double kernel = 1;                     ///< half width along the curve over which motions are blended, in radii; 0: none
};

/// A curve in another pose. Lists may be empty: nothing of that kind.
struct CurvePosture {
    Points points;                                              ///< as many as at rest
    Eigen::Quaterniond base = Eigen::Quaterniond::Identity();   ///< how the whole curve was turned: what points cannot tell
    std::vector<double> twist = {};                             ///< degrees about the curve, per control point
    std::vector<std::array<double, 2>> scale = {};              ///< across the curve, along v and w, per control point; > 0
};

/// What a posed curve does to the space around it, at equal steps of its rest length.
struct CurveRows {
    std::vector<DualQuaternion> rigid; ///< the motion, blended along the curve
    std::vector<Matrix34> before;      ///< stretch and scale about the curve at rest, done before the motion
    std::vector<Matrix34> affine;      ///< both in one
    std::vector<CurveFrame> fine;      ///< frames of the posed curve, twisted: not blended, not guarded; 4 a row
    double bend = 0;                   ///< largest curvature times reach to the inside: above 1 the surface folds
    double tilt = 0;                   ///< what the guard turned planes by, at most, degrees
};

/// A curve at rest, its frames, and the table of motions that a pose makes of it.
///
/// A vertex is told by the place s of the curve that it belongs to, in rest arc length, and follows x ↦ T(s) x with
/// T(s) x = M(s) [C(s) + F(s) D(s) F(s)ᵀ (x − C(s))]: D = diag(stretch, scale, scale) in the rest frame, M the rigid motion from rest frame to
/// posed frame. Any s gives the rest pose exactly, and a rigid motion of the curve a rigid motion: s may be smoothed freely.
///
/// M is blended along the curve as dual quaternions with the kernel (1 − x²)² of half width min(h r, s, L − s). As it depends on s only, it is
/// applied to the table, not to vertices. In rest arc length a straight stretch stays exact (in the spline's t it errs by 4e-3 of the
/// length); the taper keeps the body beyond the ends still. Figures beside the thesis's slabs are in docs/curves.md.
///
/// At the two ends stretch is left out, or it would scale everything beyond them. At a held end what twist and scale it was given fades out.
/// Source: Blanco 5.1–5.3. Changed: interpolated frames instead of those of 200 slabs.
/// Cost: pose() some thousand frames whatever the model.
class EncodedCurve {
public:
    static constexpr int k_rows = 256;
    static constexpr int k_finer = 4; ///< frames from one row to the next

    /// @param rest  n×3 control points, n ≥ 2
    /// @throws InvalidInput as SplineCurve; `curve-without-length`; `curve-radius`
    EncodedCurve(const Points& rest, EncodedCurveOptions options);

    [[nodiscard]] const SplineCurve& curve() const { return curve_; }
    [[nodiscard]] const EncodedCurveOptions& options() const { return options_; }

    /// Row, a real number in [0, 255], of the curve's parameter t.
    [[nodiscard]] double row_of(double t) const { return curve_.arc_length(t) / curve_.length() * (k_rows - 1); }
    /// The rest frame at a row, from the nearest of the fine ones.
    [[nodiscard]] const CurveFrame& frame_at(double row) const;
    /// Radius at a row.
    [[nodiscard]] double radius_at(double row) const;

    /// What the curve at rest is at a row, for the change of the row with the place.
    struct RowSlope {
        Eigen::Vector3d origin; ///< C
        Eigen::Vector3d along;  ///< g: the unit tangent times rows per length
        Eigen::Vector3d bend;   ///< κ: the curvature, towards the centre of the bend
    };
    [[nodiscard]] const std::vector<RowSlope>& row_slopes() const { return slopes_; }
    /// ∂row/∂x = g / (1 − κ·(x − C)) for a vertex at x whose nearest place is `row`, with C, g and κ interpolated between two rows and the divisor
    /// at least 0.05 (beyond the centre of a bend it has no meaning). 0 beyond the ends.
    [[nodiscard]] Eigen::Vector3d row_gradient(double row, const Eigen::Vector3d& x) const;

    /// @param supports  per row; read by the guard and for `bend`
    /// @throws InvalidInput `posed-points`, `curve-twist`, `curve-scale` (not one per control point), `non-finite-curve`
    [[nodiscard]] CurveRows pose(const CurvePosture& posture, std::span<const RowSupport> supports, CurveGuard guard) const;

    /// How a place t of the posed curve moves what is fixed to it there: a rigid motion such that `root` lands where the curve takes it.
    /// It is what linked curves take over.
    [[nodiscard]] Matrix34 motion_at(const CurveRows& rows, const CurvePosture& posture, double t, const Eigen::Vector3d& root) const;

    /// The rest pose as a posture.
    [[nodiscard]] CurvePosture at_rest() const { return {.points = curve_.controls()}; }

    /// Twist (degrees) and scale at a place s of the rest length.
    struct Across {
        double twist, scale_v, scale_w;
    };
    [[nodiscard]] std::vector<Across> across(const CurvePosture& posture, std::span<const double> lengths) const;

    /// Checked posture → its spline. @throws as pose()
    [[nodiscard]] SplineCurve posed_curve(const CurvePosture& posture) const;
    /// Frames of a posed curve at parameters t, twisted. @param turns  twist at each, degrees
    [[nodiscard]] std::vector<CurveFrame> posed_frames(const SplineCurve& posed, const CurvePosture& posture, std::span<const double> t, std::span<const Across> turns) const;
    /// Frames of the curve at rest at parameters t.
    [[nodiscard]] std::vector<CurveFrame> rest_frames(std::span<const double> t) const;

private:
    EncodedCurveOptions options_;
    SplineCurve curve_;
    Eigen::Matrix3d first_axes_;
    std::vector<double> fine_lengths_, fine_t_, control_lengths_;
    std::vector<CurveFrame> fine_;
    std::vector<RowSlope> slopes_;
};

} // namespace lissom
