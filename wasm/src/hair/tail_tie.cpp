#include "lissom/hair/tail_tie.h"

#include "lissom/mesh/smooth.h"

#include <algorithm>
#include <cmath>

namespace lissom {

using Eigen::Vector3d;

namespace {

constexpr double k_region = 3, k_pull = 1.3; // in radii of C1
constexpr double k_tight = 0.25;             // of the detail that is left up to the tie
constexpr double k_loosen = 5;               // radii beyond the tie over which detail comes back
constexpr double k_by = 2.5;                 // radii around the tie in which hair is drawn in
constexpr double k_fill = 0.95;              // of C1 that drawn hair fills

/// Where a strand first crosses the section's plane along its axis, `within` of its centre; at −1: nowhere.
struct Crossing {
    int at = -1; // first point beyond
    double out = 0;
};
Crossing first_crossing(const std::vector<Vector3d>& points, const TailSection& section, double within) {
    double before = 0;
    for (std::size_t k = 0; k < points.size(); ++k) {
        const double along = (points[k] - section.centre).dot(section.axis);
        if (k > 0 && before < 0 && along >= 0) {
            const double t = before / (before - along);
            const double out = (points[k - 1] + t * (points[k] - points[k - 1]) - section.centre).norm();
            if (out < within) return {static_cast<int>(k), out};
        }
        before = along;
    }
    return {};
}

} // namespace

TailPassage passage_of(const std::vector<Vector3d>& points, const TailSection& section) {
    TailPassage out;
    if (!(section.radius > 0) || points.empty() || (points[0] - section.centre).dot(section.axis) >= 0) return out;
    const double reach = k_region * section.radius;
    for (const Vector3d& p : points) out.reaches = out.reaches || (p - section.centre).squaredNorm() < reach * reach;
    out.at = first_crossing(points, section, k_pull * section.radius).at;
    out.passes = out.at >= 0;
    return out;
}

std::vector<double> TailTie::looseness(const std::vector<Vector3d>& points, double segment) const {
    std::vector<double> out(points.size(), 1);
    for (const TailSection& s : sections_) {
        const TailPassage passage = passage_of(points, s);
        if (!passage.passes) continue;
        for (std::size_t k = 0; k < points.size(); ++k) {
            const double beyond = (static_cast<double>(k) - passage.at) * segment / (k_loosen * s.radius);
            out[k] = std::min(out[k], k_tight + (1 - k_tight) * smooth(beyond));
        }
    }
    return out;
}

void TailTie::draw(std::vector<Vector3d>& points) const {
    for (const TailSection& s : sections_) {
        if (!(s.radius > 0)) continue;
        const Crossing crossing = first_crossing(points, s, k_region * s.radius);
        if (crossing.at < 0) continue;
        const double ratio = crossing.out / (k_fill * s.radius), squared = ratio * ratio;
        const double drawn_in = 1 - 1 / std::sqrt(std::sqrt(1 + squared * squared)); // to R (1 + (R/r)^4)^-1/4
        for (std::size_t k = 1; k < points.size(); ++k) {
            const Vector3d from = points[k] - s.centre;
            const double along = from.dot(s.axis);
            const Vector3d across = from - along * s.axis;
            const double share = (1 - smooth(std::abs(along) / (k_by * s.radius))) *
                                 (1 - smooth(across.norm() / s.radius - k_region));
            points[k] -= share * drawn_in * across;
        }
    }
}

} // namespace lissom
