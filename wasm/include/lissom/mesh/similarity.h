#pragma once

#include "lissom/mesh/types.h"

#include <Eigen/Geometry>

namespace lissom {

/// x ↦ scale · rotation · x + translation.
struct Similarity {
    double scale = 1;
    Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
    Eigen::Vector3d translation = Eigen::Vector3d::Zero();

    [[nodiscard]] Eigen::Affine3d affine() const;
};

/// The similarity that carries `from` to `to` (both n×3) in the least squares sense, never a reflection (Umeyama,
/// PAMI 13(4), 1991). Points on one line leave a turn about it open: some turn is returned.
[[nodiscard]] Similarity fit_similarity(const Points& from, const Points& to);

/// Root mean square of what is left after the fit, relative to the spread of `to`.
[[nodiscard]] double misfit(const Similarity& map, const Points& from, const Points& to);

} // namespace lissom
