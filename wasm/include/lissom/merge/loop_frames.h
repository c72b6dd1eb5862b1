#pragma once

#include "lissom/merge/boundary_correspondence.h"

#include <Eigen/Geometry>

namespace lissom {

/// What becomes of each place of a source loop: where it goes, and how its surroundings turn and grow.
struct LoopImage {
    Points positions;                      ///< n×3, on the target loop
    std::vector<Eigen::Matrix3d> rotation; ///< R_i: the source's local frame onto the target's
    std::vector<double> scale;             ///< s_i > 0: ratio of the tangents' lengths
};

/// Local frames of tangent, vertex normal and their cross product on both loops (Fu 3.3.1). Tangents are chords over
/// a fortieth of the loop, so that a jagged path gives steady frames; places whose frame does not exist (no length,
/// no normal) take that of the best similarity of the whole loop.
///
/// @param source_normals,target_normals  unit vertex normals, both pointing out
[[nodiscard]] LoopImage image_of_loop(const LoopMatch& match, const Points& source, const Points& source_normals,
                                      const Points& target, const Points& target_normals);

} // namespace lissom
