#include "lissom/hair/style.h"
#include "node_vectors.h"

#include <algorithm>
#include <cmath>

namespace lissom {

using Eigen::Vector3d;

namespace {

constexpr double k_inner = 1.3, k_outer = 1.9; // radii of R1 and R2 beside that of C1 (Fu 4.5)

/// Where the line passes the plane through c across the axis, nearest to c; false when it does not.
bool crossing(const Polyline& line, const Vector3d& c, const Vector3d& axis, Vector3d& where) {
    double best = -1;
    for (std::size_t i = 1; i < line.size(); ++i) {
        const double a = (line[i - 1] - c).dot(axis), b = (line[i] - c).dot(axis);
        if (a * b > 0 || a == b) continue;
        const Vector3d p = line[i - 1] + a / (a - b) * (line[i] - line[i - 1]);
        if (best >= 0 && (p - c).norm() >= best) continue;
        best = (p - c).norm();
        where = p;
    }
    return best >= 0;
}

} // namespace

std::vector<TailSection> tail_sections(const Ponytail& tail, double step) {
    const Polyline spine = resampled(tail.spine, step);
    if (spine.size() < 2 || tail.section.size() < 3) return {};
    Vector3d middle = Vector3d::Zero();
    for (const Vector3d& p : tail.section) middle += p / static_cast<double>(tail.section.size());
    double radius = 0;
    for (const Vector3d& p : tail.section) radius += (p - middle).norm() / static_cast<double>(tail.section.size());
    if (!(radius > 0)) return {};

    // C1 lies where the spine passes the drawn section; C2 where the profiles end, at least one step on.
    const auto nearest = [&](const Vector3d& p) {
        return static_cast<std::size_t>(std::min_element(spine.begin(), spine.end(), [&](const auto& a, const auto& b) {
                                            return (a - p).squaredNorm() < (b - p).squaredNorm();
                                        }) - spine.begin());
    };
    const std::size_t first = std::min(nearest(middle), spine.size() - 2);
    std::size_t last = first + 1;
    for (const Polyline& profile : tail.profiles)
        if (profile.size() > 1) last = std::max({last, nearest(profile.front()), nearest(profile.back())});
    if (tail.profiles[0].size() < 2 && tail.profiles[1].size() < 2)
        last = std::min(spine.size() - 1, first + std::max<std::size_t>(2, static_cast<std::size_t>(2 * radius / step)));

    std::vector<TailSection> sections;
    for (std::size_t i = first; i <= last; ++i) {
        const Vector3d axis = (spine[std::min(i + 1, spine.size() - 1)] - spine[i == 0 ? 0 : i - 1]).normalized();
        double sum = 0;
        int count = 0;
        for (const Polyline& profile : tail.profiles) {
            Vector3d p;
            if (!crossing(profile, spine[i], axis, p)) continue;
            sum += (p - spine[i]).norm();
            ++count;
        }
        const double before = sections.empty() ? radius : sections.back().radius;
        sections.push_back({spine[i], axis, i == first || count == 0 ? before : sum / count});
    }
    return sections;
}

void add_ponytail(NodeVectors& out, const Ponytail& tail) {
    const double d = out.grid().step;
    const std::vector<TailSection> sections = tail_sections(tail, d);
    if (sections.empty()) return;

    for (std::size_t i = 0; i < sections.size(); ++i) { // longitudinal
        const TailSection& s = sections[i];
        const TailSection& next = sections[std::min(i + 1, sections.size() - 1)];
        const double widening = (next.radius - s.radius) / d;
        for_nodes_near(out.grid(), s.centre, s.centre, s.radius + d, [&](int node, const Vector3d& at) {
            const Vector3d q = at - s.centre;
            const double along = q.dot(s.axis);
            const Vector3d across = q - along * s.axis;
            if (std::abs(along) > 0.6 * d || across.norm() > s.radius + 0.5 * d) return;
            out.add(node, (s.axis + widening / std::max(s.radius, 1e-9) * across).normalized(), 1 - std::abs(along) / d);
        });
    }

    const Polyline spine = resampled(tail.spine, d); // spine, from C2 on
    StreamCurve rest;
    rest.fade = true;
    bool beyond = false;
    for (const Vector3d& p : spine) {
        beyond = beyond || p == sections.back().centre;
        if (beyond) rest.points.push_back(p);
    }
    add_stream(out, rest);

    const TailSection& c1 = sections.front(); // centripetal
    for_nodes_near(out.grid(), c1.centre, c1.centre, k_outer * c1.radius + d, [&](int node, const Vector3d& at) {
        const Vector3d q = at - c1.centre;
        const double along = q.dot(c1.axis);
        const Vector3d across = q - along * c1.axis;
        const double r = across.norm();
        if (std::abs(along) > 0.75 * d || r < k_inner * c1.radius || r > std::max(k_outer * c1.radius, k_inner * c1.radius + d)) return;
        out.add(node, -tail.tightness * across / r, 1 - std::abs(along) / d);
    });
}

} // namespace lissom
