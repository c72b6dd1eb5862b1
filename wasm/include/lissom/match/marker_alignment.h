#pragma once

#include "lissom/match/radial_map.h"
#include "lissom/mesh/similarity.h"

#include <optional>
#include <utility>
#include <vector>

namespace lissom {

/// How a source model first comes to lie on a target.
enum class MatchStart {
    automatic,  ///< the similarity where markers are flat or few; else both are tried, and the one that leaves less is kept
    similarity, ///< moved, turned and scaled, never mirrored
    radial      ///< bent, so that every marker is met
};

/// What pairs of markers say about the way from one model to another, and about themselves.
struct MarkerAlignment {
    Similarity similarity;           ///< the identity without markers; with one or two no turn
    std::optional<RadialMap> radial; ///< none: the similarity is the start
    double flatness = 0;             ///< smallest by largest singular value of the centred markers, of the flatter side; 0 for fewer than four
    double misfit = 0;               ///< of the similarity, relative to the spread of the target's markers
    double mirrored_misfit = 0;      ///< of the best similarity that mirrors
    bool mirrored = false;           ///< markers look as if left and right had been changed on one side
    std::vector<double> surprises;   ///< per marker how far the others would have placed it, shares of their size (√12 times the root mean square distance from their middle); empty for fewer than six
    std::optional<std::pair<int, int>> swapped; ///< two markers that fit far better if they changed places

    [[nodiscard]] Eigen::Vector3d operator()(const Eigen::Vector3d& x) const;
    [[nodiscard]] Points operator()(const Points& points) const;
};

/// Markers flatter than this decide no bending: nothing holds it out of their plane (feet are at 0.03, bodies at 0.19, heads at 0.75).
constexpr double k_flat_markers = 0.1;

/// The similarity, and the radial map where `start` asks for it or markers are not flat (ratio of singular values at least 0.1 on both sides)
/// and at least five.
///
/// Mirrored: the best mirroring similarity misfits less than the proper one by a factor of 1.2. Swapped: the pair whose exchange lowers the sum of
/// all squared surprises most, if it lowers it to less than half. Both are warnings: a pose can look like either.
/// @param from,to  n×3, any n, each at about a unit diagonal
/// @throws InvalidInput `marker-count` (sides differ), `non-finite-marker`
[[nodiscard]] MarkerAlignment align_markers(const Points& from, const Points& to, MatchStart start = MatchStart::automatic);

} // namespace lissom
