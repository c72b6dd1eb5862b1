#pragma once

#include "lissom/curve/spline.h"

#include <Eigen/Geometry>

#include <span>
#include <vector>

namespace lissom {

/// A place on a curve with three axes: the columns u (along the curve), v, w = u × v. Never left-handed.
struct CurveFrame {
    Eigen::Vector3d origin = Eigen::Vector3d::Zero();
    Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
};

/// Right-handed axes whose first is the unit vector u: v is u projected to the world's XZ or XY plane and turned there by 90 degrees
/// (Blanco 5.1, Alg. 6, which picks the plane that u lies least square to).
[[nodiscard]] Eigen::Matrix3d axes_along(const Eigen::Vector3d& u);

/// The first axes of a posed curve: those at rest turned by `base`, then by the least turn that brings u onto the posed tangent.
/// Points alone cannot tell how far a straight curve has rolled; `base` can. Blanco 5.2 is this with base = 1.
[[nodiscard]] Eigen::Matrix3d posed_axes(const Eigen::Matrix3d& rest, const Eigen::Vector3d& tangent, const Eigen::Quaterniond& base);

/// A frame carried to another point of a curve with the least turn about it: the double reflection. Works forward and backward; where
/// the two places coincide it is the least turn between the tangents.
///
/// Source: Wang, Jüttler, Zheng, Liu, "Computation of rotation minimizing frames", ACM Trans. Graph. 27(1), 2008, table I. The
/// projection of Blanco 5.1 costs as much and rolls: median 8, most 93 degrees on random splines; this one less than 0.003 and 0.9.
/// @param tangent  unit; zero keeps the axes
[[nodiscard]] CurveFrame transported(const CurveFrame& from, const Eigen::Vector3d& to, const Eigen::Vector3d& tangent);

/// Rotation-minimising frames at places of a curve, carried from the first of them, or from the last.
/// @param parameters  ascending, in [0, 1]
/// @param axes        of the frame that the others are carried from
[[nodiscard]] std::vector<CurveFrame> frames_along(const SplineCurve& curve, std::span<const double> parameters, const Eigen::Matrix3d& axes, bool from_end = false);

/// The least turn from one unit vector to another; half a turn about any square axis where they are opposite.
[[nodiscard]] Eigen::Quaterniond least_turn(const Eigen::Vector3d& from, const Eigen::Vector3d& to);

} // namespace lissom
