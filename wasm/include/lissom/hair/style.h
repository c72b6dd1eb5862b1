#pragma once

#include "lissom/hair/field_solver.h"
#include "lissom/hair/head_distance.h"
#include "lissom/mesh/polyline.h"

#include <vector>

namespace lissom {

// All lines are drawn, and all lengths are, in head units.

/// The general flow of the hair: the field follows it (Fu 4.5, Fig 4.5 left).
struct StreamCurve {
    Polyline points;   ///< from the scalp on; at least two different ones
    bool fade = false; ///< hair ends at the curve's end instead of growing on
};

/// A line on the scalp at which hair parts (Fu 4.5, Fig 4.4).
struct DividingCurve {
    Polyline points;           ///< on the scalp
    double tilt[2] = {0, 0};   ///< degrees at the two ends: how far the hair leans along the line, about the skin's normal
    double sigma = 1;          ///< of the Gaussian profile, in grid steps
    double height = 0.5;       ///< of the Gaussian profile, in grid steps
};

/// Hair gathered into a tail (Fu 4.5, Fig 4.5 middle and right).
struct Ponytail {
    Polyline spine;          ///< from the knot on
    Polyline section;        ///< drawn round the first cross-section C1: its centre and mean radius count
    Polyline profiles[2];    ///< outlines of the tail on either side; empty: the radius of C1 all along
    double tightness = 0.6;  ///< magnitude of the centripetal vectors, 0..1
};

struct HairStyle {
    std::vector<StreamCurve> streams;
    std::vector<DividingCurve> partings;
    std::vector<Ponytail> ponytails;
};

/// A frame that travels along a dividing curve: x away from the parting, y out of the skin, z along the curve.
struct PartingFrame {
    Eigen::Vector3d p, x, y, z;
};
/// Frames about one grid step apart. `tilt` turns x and z about y, interpolated between the ends.
[[nodiscard]] std::vector<PartingFrame> parting_frames(const DividingCurve& curve, const HeadDistance& head, double step);

/// A circle across a ponytail's spine.
struct TailSection {
    Eigen::Vector3d centre, axis; ///< axis: unit, along the spine
    double radius;
};
/// C1 … C2, about one grid step apart, C1 at the drawn section. Empty when spine or section is no curve.
[[nodiscard]] std::vector<TailSection> tail_sections(const Ponytail& tail, double step);

/// What a style demands of the field, each node once, ordered by node.
///
/// Several vectors of one primitive type at one node are averaged, nearer ones counting more. Between types
/// the more particular wins: ponytail over parting over stream. Points outside the grid demand nothing.
[[nodiscard]] std::vector<FieldConstraint> style_constraints(const HairStyle& style, const HeadDistance& head,
                                                             const Grid& grid);

} // namespace lissom
