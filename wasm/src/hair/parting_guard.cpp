#include "lissom/hair/parting_guard.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace lissom {

using Eigen::Vector3d;

namespace {
constexpr double k_gap = 0.02;      // nearest that kept hair comes to the line, in grid steps
constexpr double k_outward = 0.15;  // least part of a direction that leads away from the parting
constexpr int k_rounds = 6;         // of keeping: at a bend, leaving one piece's plane can lead to the next one's
}

PartingGuard::PartingGuard(std::span<const DividingCurve> partings, const HeadDistance& head, double step, double reach)
    : gap_(k_gap * step), reach_(reach) {
    for (const DividingCurve& curve : partings) {
        Line line;
        for (const Vector3d& p : curve.points) {
            const Vector3d normal = head.gradient(p);
            if (normal.norm() < 1e-6) continue; // at a medial point no side is out
            line.points.push_back(p);
            line.normals.push_back(normal.normalized());
        }
        lines_.push_back(std::move(line));
    }
}

std::optional<PartingGuard::Place> PartingGuard::place(const Vector3d& p, const Line& line) const {
    std::optional<Place> best;
    double nearest = INFINITY;
    const std::size_t last = line.points.size() < 2 ? 0 : line.points.size() - 2;
    for (std::size_t i = 0; i + 1 < line.points.size(); ++i) {
        const Vector3d by = line.points[i + 1] - line.points[i];
        const double square = by.squaredNorm();
        if (!(square > 0)) continue;
        const double t = (p - line.points[i]).dot(by) / square, held = std::clamp(t, 0.0, 1.0);
        const Vector3d from = p - line.points[i] - held * by;
        if (from.squaredNorm() >= nearest) continue;
        const Vector3d normal = ((1 - held) * line.normals[i] + held * line.normals[i + 1]).normalized();
        const Vector3d across = by.cross(normal);
        if (across.norm() < 1e-6 * std::sqrt(square)) continue; // straight out of the skin: it parts nothing
        nearest = from.squaredNorm();
        const bool past = (i == 0 && t < 0) || (i == last && t > 1);
        best = Place{across.normalized(), from.dot(across.normalized()), from.dot(normal),
                     past ? std::abs(t - held) * std::sqrt(square) : 0.0};
    }
    return best;
}

PartingGuard::Sides PartingGuard::sides(const Vector3d& root) const {
    Sides out(lines_.size(), 0);
    for (std::size_t c = 0; c < lines_.size(); ++c)
        if (const auto at = place(root, lines_[c]); at && std::abs(at->off) <= reach_ && at->beyond <= gap_)
            out[c] = at->off < 0 ? -1 : 1;
    return out;
}

bool PartingGuard::on_line(const Vector3d& root) const {
    return std::any_of(lines_.begin(), lines_.end(), [&](const Line& line) {
        const auto at = place(root, line);
        return at && std::abs(at->off) < gap_ && at->beyond <= gap_;
    });
}

Vector3d PartingGuard::kept(const Vector3d& p, const Sides& sides) const {
    Vector3d q = p;
    for (int round = 0; round < k_rounds; ++round) {
        bool moved = false;
        for (std::size_t c = 0; c < sides.size(); ++c) {
            if (sides[c] == 0) continue;
            const auto at = place(q, lines_[c]);
            if (!at) continue;
            const double lacking = gap_ + k_outward * std::max(0.0, at->above) - sides[c] * at->off;
            if (lacking <= 0) continue;
            q += sides[c] * (lacking + 1e-3 * gap_) * at->across;
            moved = true;
        }
        if (!moved) break;
    }
    return q;
}

Vector3d PartingGuard::outward(const Vector3d& p, const Vector3d& direction, const Sides& sides) const {
    Vector3d out = direction;
    for (std::size_t c = 0; c < sides.size(); ++c) {
        if (sides[c] == 0) continue;
        const auto at = place(p, lines_[c]);
        if (!at || std::abs(at->off) > reach_) continue;
        const double away = sides[c] * out.dot(at->across);
        if (away < k_outward) out = (out + sides[c] * (k_outward - away) * at->across).normalized();
    }
    return out;
}

bool PartingGuard::apart(const Sides& a, const Sides& b) {
    for (std::size_t c = 0; c < a.size(); ++c)
        if (a[c] * b[c] < 0) return true;
    return false;
}

} // namespace lissom
