#include "lissom/merge/loop_frames.h"

#include "lissom/mesh/similarity.h"

#include <algorithm>
#include <cmath>

namespace lissom {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Columns tangent, normal, their cross product; false where they do not span a frame.
bool make_frame(const Vector3d& tangent, const Vector3d& normal, Matrix3d& frame) {
    const double length = tangent.norm();
    if (!(length > 0)) return false;
    const Vector3d t = tangent / length, n = normal - normal.dot(t) * t;
    if (!(n.norm() > 1e-3)) return false;
    frame.col(0) = t;
    frame.col(1) = n.normalized();
    frame.col(2) = frame.col(0).cross(frame.col(1));
    return true;
}

} // namespace

LoopImage image_of_loop(const LoopMatch& match, const Points& source, const Points& source_normals, const Points& target,
                        const Points& target_normals) {
    const int n = static_cast<int>(match.source.size()), m = static_cast<int>(match.target.size());
    const auto on_target = [&](const Points& values, int edge, double fraction) -> Vector3d {
        return ((1 - fraction) * values.row(match.target[edge]) + fraction * values.row(match.target[(edge + 1) % m])).transpose();
    };
    Points rest(n, 3), along(n, 3); // by arc length alone: what snapping moves must not tilt the frames
    for (int i = 0; i < n; ++i) {
        rest.row(i) = source.row(match.source[i]);
        along.row(i) = on_target(target, match.at_target[i].first, match.at_target[i].second).transpose();
    }
    const Similarity whole = fit_similarity(rest, along);
    const int reach = std::min(std::max(1, static_cast<int>(std::lround(n / 40.0))), (n - 1) / 2);

    LoopImage image;
    image.positions = along;
    for (const SeamPoint& point : match.points)
        if (point.source >= 0)
            image.positions.row(point.source) = point.target >= 0 ? Eigen::RowVector3d(target.row(match.target[point.target]))
                                                                  : Eigen::RowVector3d(on_target(target, point.target_edge, point.target_fraction).transpose());
    for (int i = 0; i < n; ++i) {
        const int next = (i + reach) % n, before = (i - reach + n) % n;
        const Vector3d tangent = (rest.row(next) - rest.row(before)).transpose(), image_tangent = (along.row(next) - along.row(before)).transpose();
        Matrix3d from, to;
        const bool framed = make_frame(tangent, source_normals.row(match.source[i]).transpose(), from) &&
                            make_frame(image_tangent, on_target(target_normals, match.at_target[i].first, match.at_target[i].second), to);
        image.rotation.push_back(framed ? Matrix3d(to * from.transpose()) : whole.rotation);
        image.scale.push_back(framed ? image_tangent.norm() / tangent.norm() : whole.scale);
    }
    return image;
}

} // namespace lissom
