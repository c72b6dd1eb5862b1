#include "lissom/hair/tail_tie.h"

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

double smooth(double t) {
    t = std::clamp(t, 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

} // namespace

TailPassage passage_of(const std::vector<Vector3d>& points, const TailSection& section) {
    TailPassage out;
    if (!(section.radius > 0)) return out;
    const double reach = k_region * section.radius, wide = k_pull * section.radius;
    double before = 0;
    for (std::size_t k = 0; k < points.size(); ++k) {
        const Vector3d q = points[k] - section.centre;
        out.reaches = out.reaches || q.squaredNorm() < reach * reach;
        const double along = q.dot(section.axis);
        if (k > 0 && before < 0 && along >= 0 && !out.passes) {
            const double t = before / (before - along);
            const Vector3d crossing = points[k - 1] + t * (points[k] - points[k - 1]) - section.centre;
            out.passes = crossing.squaredNorm() < wide * wide;
            if (out.passes) out.at = static_cast<int>(k);
        }
        before = along;
    }
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

Vector3d TailTie::drawn(const Vector3d& p) const {
    Vector3d q = p;
    for (const TailSection& s : sections_) {
        if (!(s.radius > 0)) continue;
        const Vector3d from = q - s.centre;
        const double along = from.dot(s.axis);
        const Vector3d across = from - along * s.axis;
        const double r = across.norm(), R = k_fill * s.radius;
        if (r < 1e-9 * R || r > k_by * s.radius || std::abs(along) > k_by * s.radius) continue;
        const double ratio = r / R, squared = ratio * ratio;
        const double drawn_in = 1 / std::sqrt(std::sqrt(1 + squared * squared)); // r to R (1 + (R/r)^4)^-1/4
        const double share = (1 - smooth(std::abs(along) / (k_by * s.radius))) * (1 - smooth((r / s.radius - 1.5) / (k_by - 1.5)));
        q += share * (drawn_in - 1) * across;
    }
    return q;
}

} // namespace lissom
