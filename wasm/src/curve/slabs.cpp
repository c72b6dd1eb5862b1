#include "lissom/curve/slabs.h"

#include <algorithm>
#include <cmath>

namespace lissom {

using Eigen::Vector3d;

namespace {

/// Signed way from a point of plane k−1, along its normal, to plane k.
double way_to(const CurveFrame& from, const CurveFrame& to, const Vector3d& point) {
    const double slope = from.axes.col(0).dot(to.axes.col(0));
    return (to.origin - point).dot(to.axes.col(0)) / (std::abs(slope) > 1e-9 ? slope : 1e-9);
}

} // namespace

SlabTable::SlabTable(const EncodedCurve& curve) {
    for (int k = 0; k < k_planes; ++k) {
        t_.push_back(static_cast<double>(k) / (k_planes - 1));
        lengths_.push_back(curve.curve().arc_length(t_.back()));
    }
    rest_ = curve.rest_frames(t_);
}

SlabPlace SlabTable::place(const Vector3d& x, double t) const {
    SlabPlace result;
    result.slab = t <= 0 ? -1 : t >= 1 ? k_planes - 1 : std::min(static_cast<int>(t * (k_planes - 1)), k_planes - 2);
    const CurveFrame& frame = rest_[std::max(result.slab, 0)];
    const Vector3d local = frame.axes.transpose() * (x - frame.origin);
    result.beta = local[1];
    result.gamma = local[2];
    if (t <= 0 || t >= 1) result.ratio = local[0];
    else {
        const double way = way_to(frame, rest_[result.slab + 1], x - local[0] * frame.axes.col(0));
        result.ratio = std::abs(way) > 1e-12 ? local[0] / way : 0; // Eq 5.4, signed
    }
    return result;
}

SlabTable::Planes SlabTable::posed(const EncodedCurve& curve, const CurvePosture& posture) const {
    Planes result;
    result.across = curve.across(posture, lengths_);
    result.frames = curve.posed_frames(curve.posed_curve(posture), posture, t_, result.across);
    return result;
}

Vector3d SlabTable::position(const Planes& planes, const SlabPlace& place) {
    const int k = std::max(place.slab, 0);
    const CurveFrame& frame = planes.frames[k];
    const Vector3d in_plane = frame.origin + planes.across[k].scale_v * place.beta * frame.axes.col(1) +
                              planes.across[k].scale_w * place.gamma * frame.axes.col(2); // Eq 5.5, with w′
    const bool beyond = place.slab < 0 || place.slab == k_planes - 1;
    const double along = beyond ? place.ratio : place.ratio * way_to(frame, planes.frames[k + 1], in_plane);
    return in_plane + along * frame.axes.col(0); // Eq 5.6, s′ signed
}

} // namespace lissom
