#pragma once

#include "lissom/hair/style.h"

#include <cstdint>
#include <optional>
#include <span>

namespace lissom {

/// Keeps hair on its side of the partings near its root: the field between two nodes cannot jump, so what lies
/// within a step of a line needs to be told.
///
/// The sides of a parting are those of the plane along the nearest piece of its line and along the skin's normal
/// there, as drawn: however the hair leans along the line. It ends where the line does.
class PartingGuard {
public:
    /// Per parting the side on which a strand is rooted: −1 or 1; 0 where the parting is none of its business.
    using Sides = std::vector<std::int8_t>;

    /// @param reach  how far from a parting hair is rooted that could cross it, head units
    PartingGuard(std::span<const DividingCurve> partings, const HeadDistance& head, double step, double reach);

    [[nodiscard]] Sides sides(const Eigen::Vector3d& root) const;

    /// Whether a root lies so near to a line that it has no side.
    [[nodiscard]] bool on_line(const Eigen::Vector3d& root) const;

    /// The point, moved straight across to its side of each parting where it had come too near or beyond. Higher
    /// over the skin it keeps farther off, so that hair which leans a little still does not cross.
    [[nodiscard]] Eigen::Vector3d kept(const Eigen::Vector3d& p, const Sides& sides) const;

    /// The direction without what leads to a parting, where p lies near it.
    [[nodiscard]] Eigen::Vector3d outward(const Eigen::Vector3d& p, const Eigen::Vector3d& direction, const Sides& sides) const;

    /// Whether one parting lies between two strands.
    [[nodiscard]] static bool apart(const Sides& a, const Sides& b);

private:
    struct Line {
        Polyline points, normals;
    };
    /// A place in the frame of the nearest piece of a line.
    struct Place {
        Eigen::Vector3d across; ///< unit, towards the side 1
        double off;             ///< along it
        double above;           ///< along the skin's normal
        double beyond;          ///< how far past the line's ends
    };
    [[nodiscard]] std::optional<Place> place(const Eigen::Vector3d& p, const Line& line) const;

    std::vector<Line> lines_;
    double gap_, reach_;
};

} // namespace lissom
