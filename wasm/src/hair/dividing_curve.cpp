#include "lissom/hair/style.h"
#include "node_vectors.h"

#include <cmath>
#include <numbers>

namespace lissom {

using Eigen::Vector3d;

namespace {

constexpr double k_parting_magnitude = 0.3; // of the vectors that keep the parting open (Fu Fig 4.4)
constexpr double k_reach = 2.5;             // how far to the side the Gaussian's vectors go, in sigma
constexpr double k_thickness = 0.8;         // nodes this near to the profile take its tangent, in grid steps
constexpr double k_wall = 2.5;              // height of the separating vectors, in grid steps

/// The Gaussian that passes through the origin at its inflexion point: centred one sigma to the side.
struct Profile {
    double sigma, height;
    [[nodiscard]] double at(double x) const {
        const double u = (x - sigma) / sigma;
        return height * (std::exp(-0.5 * u * u) - std::exp(-0.5));
    }
    [[nodiscard]] double slope(double x) const {
        const double u = (x - sigma) / sigma;
        return -height * u / sigma * std::exp(-0.5 * u * u);
    }
};

} // namespace

std::vector<PartingFrame> parting_frames(const DividingCurve& curve, const HeadDistance& head, double step) {
    const Polyline line = resampled(curve.points, step);
    std::vector<PartingFrame> frames;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const Vector3d along = line[std::min(i + 1, line.size() - 1)] - line[i == 0 ? 0 : i - 1];
        Vector3d y = head.gradient(line[i]);
        if (y.norm() < 1e-6) continue; // at a medial point no side is out
        y.normalize();
        const Vector3d tangent = along - along.dot(y) * y;
        if (tangent.norm() < 1e-9 * step) continue;
        const double t = line.size() > 1 ? static_cast<double>(i) / static_cast<double>(line.size() - 1) : 0;
        const double angle = ((1 - t) * curve.tilt[0] + t * curve.tilt[1]) * std::numbers::pi / 180;
        const Vector3d z = Eigen::AngleAxisd(angle, y) * tangent.normalized();
        frames.push_back({line[i], y.cross(z), y, z});
    }
    return frames;
}

void add_parting(NodeVectors& out, const DividingCurve& curve, const HeadDistance& head) {
    const double d = out.grid().step;
    const std::vector<PartingFrame> frames = parting_frames(curve, head, d);
    const Profile profile{curve.sigma * d, curve.height * d};
    const double reach = k_reach * profile.sigma;
    // By node, not by sample: the field jumps across the line, so a node must know its side.
    for (const PartingFrame& f : frames)
        for_nodes_near(out.grid(), f.p, f.p, std::max(reach, k_wall * d) + d, [&](int node, const Vector3d& at) {
            const Vector3d q = at - f.p;
            const double x = q.dot(f.x), y = q.dot(f.y), z = q.dot(f.z);
            if (std::abs(z) > 0.75 * d || std::abs(x) > reach) return;
            const double side = x < 0 ? -1 : 1, a = std::abs(x);
            const double above = y - profile.at(a), near = 1 - std::abs(z) / d;
            if (std::abs(above) <= k_thickness * d)
                out.add(node, (side * f.x + profile.slope(a) * f.y).normalized(), near);
            else if (above > 0 && above <= k_wall * d && a <= d)
                out.add(node, k_parting_magnitude * side * f.x, near);
        });
}

} // namespace lissom
