#include "lissom/hair/parting_guard.h"

#include <algorithm>

namespace lissom {

using Eigen::Vector3d;

namespace {
constexpr double k_gap = 0.02;      // nearest that kept hair comes to the plane, in grid steps
constexpr double k_outward = 0.15;  // least part of a direction that leads away from the parting
}

PartingGuard::PartingGuard(std::span<const DividingCurve> partings, const HeadDistance& head, double step, double reach)
    : step_(step), reach_(reach) {
    for (DividingCurve curve : partings) {
        curve.tilt[0] = curve.tilt[1] = 0; // the plane follows the line, however the hair leans along it
        curves_.push_back(parting_frames(curve, head, 0.5 * step));
    }
}

const PartingFrame* PartingGuard::frame_at(const Vector3d& p, int curve) const {
    const auto& frames = curves_[static_cast<std::size_t>(curve)];
    if (frames.empty()) return nullptr;
    const auto nearest = std::min_element(frames.begin(), frames.end(), [&](const PartingFrame& a, const PartingFrame& b) {
        return (a.p - p).squaredNorm() < (b.p - p).squaredNorm();
    });
    const Vector3d q = p - nearest->p;
    const bool beside = std::abs(q.dot(nearest->z)) <= 0.5 * step_ && std::abs(q.dot(nearest->x)) <= reach_;
    return beside ? &*nearest : nullptr;
}

PartingGuard::Side PartingGuard::side(const Vector3d& root) const {
    Side best;
    double nearest = reach_;
    for (int c = 0; c < static_cast<int>(curves_.size()); ++c) {
        const PartingFrame* f = frame_at(root, c);
        if (!f) continue;
        const double x = (root - f->p).dot(f->x);
        if (std::abs(x) > nearest) continue;
        nearest = std::abs(x);
        best = {c, x < 0 ? -1.0 : 1.0};
    }
    return best;
}

Vector3d PartingGuard::kept(const Vector3d& p, Side side) const {
    if (side.curve < 0) return p;
    const PartingFrame* f = frame_at(p, side.curve);
    if (!f) return p;
    const double x = side.sign * (p - f->p).dot(f->x);
    return x >= k_gap * step_ ? p : Vector3d(p + side.sign * (k_gap * step_ - x) * f->x);
}

Vector3d PartingGuard::outward(const Vector3d& p, const Vector3d& direction, Side side) const {
    if (side.curve < 0) return direction;
    const PartingFrame* f = frame_at(p, side.curve);
    if (!f) return direction;
    const double away = side.sign * direction.dot(f->x);
    if (away >= k_outward) return direction;
    return (direction + side.sign * (k_outward - away) * f->x).normalized();
}

} // namespace lissom
