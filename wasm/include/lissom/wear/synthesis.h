#pragma once

#include "lissom/wear/measures.h"

#include <span>
#include <vector>

namespace lissom {

struct Synthesis {
    Eigen::VectorXd weights;    ///< sum to 1
    std::vector<double> reached; ///< each measure of the sum of the bodies by them
    int iterations = 0;
};

/// Σ_k w_k S_k.
[[nodiscard]] Points blended(std::span<const Points> bodies, const Eigen::VectorXd& weights);

/// Weights by which bodies add up to one that measures what is wanted (Skins 5.1, Fig 15):
///
///     minimise Σ_m ((g_m(w) − v_m) / v_m)² + μ |w − w₀|²,  Σ_k w_k = 1
///
/// by Gauss and Newton, each step halved until it helps, for girths are not linear in weights. μ is a millionth of how strongly the measures answer to the
/// weights: it decides only what they leave open, as with more bodies than measures. Measures that contradict one another come out by least squares.
/// @param measures  checked; those without a wanted value count for nothing
/// @param given     w₀; brought to sum 1 (all alike where it sums to 0)
/// @throws InvalidInput `loop-open`
[[nodiscard]] Synthesis synthesised(const Measurer& measurer, std::span<const Points> bodies, std::span<const Measure> measures, const Eigen::VectorXd& given);

} // namespace lissom
