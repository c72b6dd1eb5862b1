#pragma once

#include "lissom/hair/style.h"

#include <span>

namespace lissom {

/// Keeps hair on its side of a parting near its root: the field between two nodes cannot jump, so what lies within
/// a step of the line needs to be told.
class PartingGuard {
public:
    /// A parting and the side of it on which a strand is rooted; curve −1: near none.
    struct Side {
        int curve = -1;
        double sign = 1;
    };

    /// @param reach  how far from a parting a strand is still kept from crossing, head units
    PartingGuard(std::span<const DividingCurve> partings, const HeadDistance& head, double step, double reach);

    [[nodiscard]] Side side(const Eigen::Vector3d& root) const;

    /// The point, moved straight across to its side of the parting's plane where it had come too near or beyond.
    [[nodiscard]] Eigen::Vector3d kept(const Eigen::Vector3d& p, Side side) const;

    /// The direction without what leads to the parting, where p lies near it.
    [[nodiscard]] Eigen::Vector3d outward(const Eigen::Vector3d& p, const Eigen::Vector3d& direction, Side side) const;

private:
    /// The nearest frame of a curve whose plane's strip p lies in; null beyond its ends or reach.
    [[nodiscard]] const PartingFrame* frame_at(const Eigen::Vector3d& p, int curve) const;

    std::vector<std::vector<PartingFrame>> curves_;
    double step_, reach_;
};

} // namespace lissom
