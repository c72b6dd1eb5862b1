#include "lissom/curve/ik.h"

#include "lissom/curve/frames.h"
#include "lissom/mesh/errors.h"

#include <algorithm>
#include <string>
#include <vector>

namespace lissom {

using Eigen::Vector3d;

namespace {

constexpr int k_passes = 200;
constexpr double k_tolerance = 1e-9; ///< of the chain's length
constexpr double k_bend = 1e-3;      ///< of the chain's length: what makes a straight chain bend

/// The point `length` from `from` towards `to`.
Vector3d towards(const Vector3d& from, const Vector3d& to, double length) {
    const Vector3d way = to - from;
    return way.norm() > 0 ? Vector3d(from + way.normalized() * length) : from + Vector3d(length, 0, 0);
}

} // namespace

Reached reached(const Points& points, int end, const Vector3d& target, std::span<const int> held) {
    const int count = static_cast<int>(points.rows());
    const auto check = [&](int i) {
        if (i < 0 || i >= count) throw InvalidInput("no-such-control", "There is no control point " + std::to_string(i) + "; the chain has " + std::to_string(count) + ".");
    };
    check(end);
    for (const int i : held) check(i);
    if (!points.allFinite() || !target.allFinite()) throw InvalidInput("non-finite-curve", "A control point, or where it is dragged to, is not finite.");

    const int way = end == 0 ? 1 : -1;
    std::vector<int> chain{end}; // from the dragged point to the held one
    for (int i = end + way; i >= 0 && i < count; i += way) {
        chain.push_back(i);
        if (std::find(held.begin(), held.end(), i) != held.end()) break;
    }
    Reached result{points, true};
    const int links = static_cast<int>(chain.size()) - 1;
    if (links == 0) return result;
    std::vector<Vector3d> at;
    for (const int i : chain) at.push_back(points.row(i).transpose());
    std::vector<double> lengths;
    double total = 0;
    for (int k = 0; k < links; ++k) total += lengths.emplace_back((at[k + 1] - at[k]).norm());
    const Vector3d root = at.back();

    if ((target - root).norm() >= total) {
        result.reached = (target - root).norm() <= total * (1 + k_tolerance);
        for (int k = links - 1; k >= 0; --k) at[k] = towards(at[k + 1], target, lengths[k]);
    } else {
        const Vector3d line = (target - root).norm() > 0 ? Vector3d(target - root) : Vector3d(at.front() - root);
        double off = 0;
        for (const Vector3d& p : at) off = std::max(off, (p - root).cross(line.normalized()).norm());
        if (off < k_bend * total && line.norm() > 0) {
            const Vector3d aside = axes_along(line.normalized()).col(1);
            for (int k = 1; k < links; ++k) at[k] += k_bend * total * (k % 2 ? 1 : 0.5) * aside;
        }
        for (int pass = 0; pass < k_passes && (at.front() - target).norm() > k_tolerance * total; ++pass) {
            at.front() = target;
            for (int k = 0; k < links; ++k) at[k + 1] = towards(at[k], at[k + 1], lengths[k]);
            at.back() = root;
            for (int k = links - 1; k >= 0; --k) at[k] = towards(at[k + 1], at[k], lengths[k]);
        }
        result.reached = (at.front() - target).norm() <= 1e-6 * total;
    }
    for (int k = 0; k < links; ++k) result.points.row(chain[k]) = at[k].transpose();
    const Vector3d moved = at.front() - points.row(end).transpose();
    for (int i = end - way; i >= 0 && i < count; i -= way)
        if (std::find(held.begin(), held.end(), i) == held.end()) result.points.row(i) += moved.transpose();
    return result;
}

} // namespace lissom
