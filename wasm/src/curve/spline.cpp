#include "lissom/curve/spline.h"

#include "lissom/mesh/errors.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace lissom {

using Eigen::Vector3d;

namespace {

constexpr int k_pieces = 32; ///< a span, of the table of arc length
constexpr int k_block = 8;   ///< samples that nearest() passes over at once

struct Tangents {
    Vector3d start, end; ///< dp/du of one span
};

/// p′ at the middle of three control points for a span of knot length `own`: the non-uniform Catmull–Rom (Barry and Goldman 1988).
Vector3d tangent_between(const Vector3d& before, const Vector3d& here, const Vector3d& after, double knot_before, double knot_after, double own) {
    return own * ((here - before) / knot_before - (after - before) / (knot_before + knot_after) + (after - here) / knot_after);
}

std::vector<Tangents> tangents_of(const Points& controls, const SplineOptions& options) {
    const int spans = static_cast<int>(controls.rows()) - 1;
    const auto p = [&](int i) -> Vector3d { return controls.row(i).transpose(); };
    std::vector<double> knots(spans);
    double longest = 0;
    for (int i = 0; i < spans; ++i) longest = std::max(longest, (p(i + 1) - p(i)).norm());
    // Coincident neighbours would divide by zero: a span counts as a millionth of the longest at least.
    for (int i = 0; i < spans; ++i) knots[i] = std::sqrt(std::max((p(i + 1) - p(i)).norm(), longest > 0 ? 1e-6 * longest : 1.0));

    std::vector<Tangents> result(spans);
    for (int i = 0; i < spans; ++i) {
        const Vector3d chord = p(i + 1) - p(i);
        result[i].start = i > 0 ? tangent_between(p(i - 1), p(i), p(i + 1), knots[i - 1], knots[i], knots[i]) : chord;
        result[i].end = i + 1 < spans ? tangent_between(p(i), p(i + 1), p(i + 2), knots[i], knots[i + 1], knots[i]) : chord;
    }
    const auto clamp = [](Vector3d& tangent, const std::optional<Vector3d>& direction) {
        if (direction) tangent = tangent.norm() * direction->normalized();
    };
    clamp(result.front().start, options.start_direction);
    clamp(result.back().end, options.end_direction);
    for (const int i : options.rigid) {
        const double size = options.rigid_tangent * (p(i + 1) - p(i)).norm();
        result[i].start = size * result[i].start.normalized();
        result[i].end = size * result[i].end.normalized();
    }
    return result;
}

} // namespace

SplineCurve::SplineCurve(const Points& controls, const SplineOptions& options) : controls_(controls) {
    if (controls.rows() < 2)
        throw InvalidInput("curve-points", "A curve has " + std::to_string(controls.rows()) + " control points; it needs two or more.");
    for (int i = 0; i < controls.rows(); ++i)
        if (!controls.row(i).allFinite()) throw InvalidInput("non-finite-curve", "Control point " + std::to_string(i) + " of a curve is not finite.");
    const int spans = static_cast<int>(controls.rows()) - 1;
    for (const int i : options.rigid)
        if (i < 0 || i >= spans)
            throw InvalidInput("rigid-span", "There is no segment " + std::to_string(i) + " to keep rigid; the curve has segments 0 to " + std::to_string(spans - 1) + ".");

    const std::vector<Tangents> tangents = tangents_of(controls, options);
    spans_.resize(spans);
    for (int i = 0; i < spans; ++i) {
        const Vector3d p0 = controls.row(i).transpose(), p1 = controls.row(i + 1).transpose();
        const auto& [m0, m1] = tangents[i];
        spans_[i].power = {p0, m0, 3 * (p1 - p0) - 2 * m0 - m1, 2 * (p0 - p1) + m0 + m1};
    }

    static constexpr double nodes[] = {0, 0.5384693101056831, 0.9061798459386640}, weights[] = {0.5688888888888889, 0.4786286704993665, 0.2369268850561891};
    const int pieces = k_pieces * spans;
    const double half = 0.5 / pieces; // of a piece, in t
    arc_.assign(1, 0.0);
    for (int k = 0; k < pieces; ++k) {
        const double middle = (2 * k + 1) * half;
        double sum = weights[0] * derivative(middle).norm();
        for (int q = 1; q < 3; ++q) sum += weights[q] * (derivative(middle - nodes[q] * half).norm() + derivative(middle + nodes[q] * half).norm());
        arc_.push_back(arc_.back() + half * sum);
    }
    for (int k = 0; k <= pieces; ++k) samples_.push_back(point(static_cast<double>(k) / pieces));
}

std::pair<int, double> SplineCurve::at(double t) const {
    const double x = std::clamp(t, 0.0, 1.0) * span_count();
    const int i = std::min(static_cast<int>(x), span_count() - 1);
    return {i, x - i};
}

Vector3d SplineCurve::point(double t) const {
    const auto [i, u] = at(t);
    const auto& [a, b, c, d] = spans_[i].power;
    return a + u * (b + u * (c + u * d));
}

Vector3d SplineCurve::derivative(double t) const {
    const auto [i, u] = at(t);
    const auto& [a, b, c, d] = spans_[i].power;
    return span_count() * (b + u * (2 * c + 3 * u * d));
}

Vector3d SplineCurve::second_derivative(double t) const {
    const auto [i, u] = at(t);
    const auto& [a, b, c, d] = spans_[i].power;
    return span_count() * span_count() * (2 * c + 6 * u * d);
}

Vector3d SplineCurve::tangent(double t) const {
    const double at_t = std::clamp(t, 0.0, 1.0);
    const Vector3d d = derivative(at_t);
    if (d.norm() > 1e-9 * length()) return d.normalized();
    // Where the curve stands still: the direction of the nearest piece of it with length, onward first.
    const int pieces = static_cast<int>(arc_.size()) - 1, here = std::min(static_cast<int>(at_t * pieces), pieces - 1);
    for (int reach = 1; reach <= pieces; ++reach) {
        const Vector3d onward = samples_[std::min(here + reach, pieces)] - samples_[std::max(here + 1 - reach, 0)];
        if (onward.norm() > 1e-9 * length()) return onward.normalized();
    }
    return Vector3d::Zero();
}

double SplineCurve::curvature(double t) const {
    const Vector3d d = derivative(t);
    const double speed = d.norm();
    return speed > 1e-9 * length() ? d.cross(second_derivative(t)).norm() / (speed * speed * speed) : 0.0;
}

double SplineCurve::arc_length(double t) const {
    const int pieces = static_cast<int>(arc_.size()) - 1;
    const double x = std::clamp(t, 0.0, 1.0) * pieces;
    const int k = std::min(static_cast<int>(x), pieces - 1);
    const double from = static_cast<double>(k) / pieces, half = (std::clamp(t, 0.0, 1.0) - from) / 2, middle = from + half;
    constexpr double node = 0.7745966692414834; // Gauss–Legendre of three places, within a piece
    const double sum = 8 * derivative(middle).norm() + 5 * (derivative(middle - node * half).norm() + derivative(middle + node * half).norm());
    return arc_[k] + half * sum / 9;
}

double SplineCurve::parameter(double s) const {
    if (!(s > 0)) return 0;
    if (s >= length()) return 1;
    const int pieces = static_cast<int>(arc_.size()) - 1;
    const int k = static_cast<int>(std::upper_bound(arc_.begin(), arc_.end(), s) - arc_.begin()) - 1;
    double low = static_cast<double>(k) / pieces, high = static_cast<double>(k + 1) / pieces;
    double t = low + (high - low) * (s - arc_[k]) / std::max(arc_[k + 1] - arc_[k], 1e-300);
    for (int i = 0; i < 8; ++i) { // Newton, kept within the piece
        const double miss = arc_length(t) - s, speed = derivative(t).norm();
        if (std::abs(miss) <= 1e-15 * length()) break;
        (miss > 0 ? high : low) = t;
        const double next = speed > 0 ? t - miss / speed : low;
        t = next > low && next < high ? next : (low + high) / 2;
    }
    return t;
}

NearestOnCurve SplineCurve::nearest(const Vector3d& p) const {
    const int last = static_cast<int>(samples_.size()) - 1;
    int best = 0;
    double least = (samples_[0] - p).squaredNorm();
    const auto look_at = [&](int k) {
        const double squared = (samples_[k] - p).squaredNorm();
        if (squared < least || (squared == least && k < best)) {
            least = squared;
            best = k;
        }
        return squared;
    };
    for (int k = k_block; k <= last; k += k_block) look_at(k);
    double nearest = std::sqrt(least), from = (samples_[0] - p).norm();
    for (int k = 0; k < last; k += k_block) {
        const double to = (samples_[k + k_block] - p).norm();
        // Whoever is within such a way of both ends is no nearer than this.
        if ((from + to - (arc_[k + k_block] - arc_[k])) / 2 <= nearest * (1 + 1e-12)) {
            for (int i = k + 1; i < k + k_block; ++i) look_at(i);
            nearest = std::sqrt(least);
        }
        from = to;
    }
    return refined(p, best);
}

NearestOnCurve SplineCurve::nearest(const Vector3d& p, double near) const {
    const int last = static_cast<int>(samples_.size()) - 1;
    int best = static_cast<int>(std::lround(std::clamp(near, 0.0, 1.0) * last));
    double least = (samples_[best] - p).squaredNorm();
    for (const int way : {-1, 1})
        for (int k = best + way; k >= 0 && k <= last; k += way) {
            const double squared = (samples_[k] - p).squaredNorm();
            if (squared >= least) break;
            least = squared;
            best = k;
        }
    return refined(p, best);
}

NearestOnCurve SplineCurve::refined(const Vector3d& p, int best) const {
    const int last = static_cast<int>(samples_.size()) - 1;
    const double least = (samples_[best] - p).norm();
    double low = static_cast<double>(std::max(best - 1, 0)) / last, high = static_cast<double>(std::min(best + 1, last)) / last;
    double t = static_cast<double>(best) / last;
    for (int i = 0; i < 12; ++i) { // f = ½ |C − p|², f′ = (C − p)·C′
        const Vector3d gap = point(t) - p, d = derivative(t);
        const double slope = gap.dot(d);
        if (std::abs(slope) <= 1e-15 * gap.norm() * d.norm()) break;
        (slope > 0 ? high : low) = t;
        const double bend = d.squaredNorm() + gap.dot(second_derivative(t));
        const double next = bend > 0 ? t - slope / bend : (low + high) / 2;
        const double to = next >= low && next <= high ? next : (low + high) / 2;
        const bool close = std::abs(to - t) <= 1e-9; // the next step would be its square
        t = to;
        if (close) break;
    }
    const double found = (point(t) - p).norm();
    return found <= least ? NearestOnCurve{t, found} : NearestOnCurve{static_cast<double>(best) / last, least};
}

} // namespace lissom
