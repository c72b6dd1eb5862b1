#pragma once

#include "lissom/mesh/types.h"

#include <vector>

namespace lissom {

/// A stroke as it was drawn: places on the screen and, for each, the ray from the eye through it.
struct Stroke {
    Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor> pixels; ///< n×2, CSS pixels
    Points origins;    ///< n×3, source space
    Points directions; ///< n×3, any length > 0; of one camera all ending on one plane, else unit vectors

    [[nodiscard]] int size() const { return static_cast<int>(pixels.rows()); }
    /// On the screen.
    [[nodiscard]] double length() const;
};

/// How a hand's trembling is taken out; all in pixels of the screen, whatever the model's size.
struct StrokeFilter {
    double step = 6;      ///< between samples
    int sweeps = 12;      ///< of Laplacian smoothing, ends held: p_i ← (p_{i−1} + 2 p_i + p_{i+1}) / 4
    double shortest = 12; ///< what is shorter is a click, not a stroke
};

/// The stroke at equal steps, smoothed; rays go along with their pixels, as they are linear in them.
///
/// Replaces Blanco 3.1.1 (Alg. 1), whose last group may be shorter than δ, so that the direction at the end is noise: median error of the
/// end direction 6.4° there, 3.4° here, at most 98° and 34° (1.5 px of noise).
/// @throws InvalidInput `stroke-too-short` (a click, or fewer than two places), `bad-stroke` (sizes that differ, numbers not finite)
[[nodiscard]] Stroke filtered(const Stroke& stroke, const StrokeFilter& filter = {});

/// Samples first … last of a stroke.
[[nodiscard]] Stroke part_of(const Stroke& stroke, int first, int last);

/// How many equally spaced control points a centripetal spline needs to stay within `error` pixels of a filtered stroke: `least` or more, at
/// most `most`. @returns their positions as sample numbers (not whole), ascending, the two ends first and last
[[nodiscard]] std::vector<double> control_samples(const Stroke& filtered, double error = 2, int least = 4, int most = 24);

} // namespace lissom
