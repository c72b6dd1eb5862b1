#pragma once

#include "lissom/mesh/types.h"

#include <Eigen/Geometry>

#include <array>
#include <optional>
#include <vector>

namespace lissom {

/// What bends a spline other than its control points.
struct SplineOptions {
    std::vector<int> rigid = {};                        ///< spans (span i: from control i to i+1) that stay nearly straight
    double rigid_tangent = 0.15;                        ///< τ: length of a rigid span's end tangents, in lengths of the span
    std::optional<Eigen::Vector3d> start_direction = {}; ///< p′(0) points there: a clamped start
    std::optional<Eigen::Vector3d> end_direction = {};   ///< p′(1) points there: a clamped end
};

/// A nearest point of a curve.
struct NearestOnCurve {
    double t;        ///< in [0, 1]
    double distance; ///< unit of length
};

/// An interpolating curve through control points: centripetal Catmull–Rom, with rigid spans on demand.
///
/// t runs over all spans in equal parts: control i lies at t = i/(n−1). Each span is the cubic
/// p(u) = (2u³−3u²+1) p₀ + (u³−2u²+u) m₀ + (3u²−2u³) p₁ + (u³−u²) m₁, u in [0, 1], the Catmull–Rom of Blanco A.10 written by its tangents
/// (printed there without its factor ½). Tangents are those of Barry and Goldman's non-uniform form with knots |p_{i+1} − p_i|^½:
/// p′ turns smoothly at control points, its length may jump there. At the two ends the curve leaves along the chord.
/// A rigid span has tangents τ |p₁ − p₀| long (Blanco 7: "a Hermite curve with small tangent vectors"); τ = 0.15 keeps the middle half of the
/// span rigid to 5 % of a limb's radius and the length to 0.7 %.
///
/// Measured (random unequal polygons, total turn over that of the polygon, median and 95th percentile): uniform knots 1.48, 2.75;
/// centripetal 1.16, 1.30: hence these.
/// Source: Blanco, "Sketch-based deformation of 3D objects", 2007, chapter 4 and appendix A; Yuksel, Schaefer, Keyser, "Parameterization and
/// applications of Catmull–Rom curves", CAD 43(7), 2011.
/// Cost: constructor linear in spans; evaluation constant; nearest() some ten evaluations.
class SplineCurve {
public:
    /// @param controls  n×3, n ≥ 2; neighbours may coincide
    /// @throws InvalidInput `curve-points` (fewer than two), `non-finite-curve`, `rigid-span` (one that is not there)
    explicit SplineCurve(const Points& controls, const SplineOptions& options = {});

    [[nodiscard]] int control_count() const { return static_cast<int>(controls_.rows()); }
    [[nodiscard]] int span_count() const { return static_cast<int>(spans_.size()); }
    [[nodiscard]] const Points& controls() const { return controls_; }

    // t is clamped to [0, 1] throughout. --------------------------------------------------------------------------

    [[nodiscard]] Eigen::Vector3d point(double t) const;
    /// dp/dt.
    [[nodiscard]] Eigen::Vector3d derivative(double t) const;
    /// d²p/dt².
    [[nodiscard]] Eigen::Vector3d second_derivative(double t) const;
    /// Unit p′; where p′ vanishes the direction in which the curve goes on from there. Zero for a curve without length.
    [[nodiscard]] Eigen::Vector3d tangent(double t) const;
    /// κ = |p′ × p″| / |p′|³, 1/length; 0 where p′ vanishes.
    [[nodiscard]] double curvature(double t) const;

    [[nodiscard]] double length() const { return arc_.back(); }
    /// Length of the curve from 0 to t (Gauss–Legendre, five places in each of 32 pieces a span).
    [[nodiscard]] double arc_length(double t) const;
    /// The t at which arc_length is s; s is clamped to [0, length()].
    [[nodiscard]] double parameter(double s) const;

    /// The nearest point to p; the smallest t of equally near samples. Blocks of samples that cannot be nearer than the best of their ends
    /// are left out, then Newton steps kept between the neighbouring samples.
    [[nodiscard]] NearestOnCurve nearest(const Eigen::Vector3d& p) const;
    /// The same where a place near it is known: downhill along samples from there. What is nearer beyond a rise is not found.
    [[nodiscard]] NearestOnCurve nearest(const Eigen::Vector3d& p, double near) const;

private:
    struct Span {
        std::array<Eigen::Vector3d, 4> power; ///< p(u) = Σ power[k] uᵏ
    };
    /// Which span t falls in and where in it: min(⌊(n−1)t⌋, n−2), for t = 1 belongs to the last (Blanco A.10 reads past it).
    [[nodiscard]] std::pair<int, double> at(double t) const;
    /// From the nearest sample to the nearest point.
    [[nodiscard]] NearestOnCurve refined(const Eigen::Vector3d& p, int sample) const;

    Points controls_;
    std::vector<Span> spans_;
    std::vector<double> arc_;              ///< length up to each piece's start, one more at the end
    std::vector<Eigen::Vector3d> samples_; ///< at equal steps of t, for nearest()
};

} // namespace lissom
