#pragma once

// Open shapes to be merged, by formula: tubes closed at one end, with an open loop of vertices 0 … m−1.

#include "lissom/merge/merge_session.h"
#include "lissom/merge/stitch.h"
#include "shapes.h"

#include <functional>

namespace tubes {

using Profile = std::function<Eigen::Vector3d(double along, double around)>; ///< along in [0, 1], around in [0, 2π)

/// n rows of m vertices, the open loop first, closed by one vertex at the far end. `upward`: the profile rises as seen
/// from inside, so that faces look outward; false: the other way.
[[nodiscard]] lissom::TriangleMesh tube(int n, int m, const Profile& profile, bool upward = true);

/// Radius 1 at the loop, rising along y; no symmetry.
[[nodiscard]] Eigen::Vector3d dome(double s, double t);
/// Radius 1.4 at the loop, going down along y.
[[nodiscard]] Eigen::Vector3d bowl(double s, double t);

[[nodiscard]] std::vector<int> first(int count);

/// Vertices whose height (y) lies between two.
[[nodiscard]] std::vector<int> within(const lissom::TriangleMesh& mesh, double low, double high);

/// The tube of `dome` with a loop of `n`, stitched onto one of `bowl` with a loop of `m`, its loop laid on the other's.
struct Stitched {
    lissom::Part target, source;
    lissom::LoopMatch match;
    lissom::JoinedMesh joined;
};
[[nodiscard]] Stitched stitched(int n, int m);

/// Checks that a surface is closed, manifold and agrees with itself across every edge.
void check_closed(const lissom::TriangleMesh& mesh, int euler);

/// Runs a session to its end and merges.
[[nodiscard]] lissom::MergeResult merged(const lissom::WorkingMesh& source, const lissom::WorkingMesh& target,
                                         const std::vector<lissom::MergeBoundary>& boundaries, const std::vector<lissom::MergeKeys>& keys,
                                         lissom::MergeOptions options = {});

/// The result as triangles (polygons of the inputs must be triangles), vertices in the result's order.
[[nodiscard]] lissom::TriangleMesh mesh_of(const lissom::MergedModel& model, const lissom::TriangleMesh& source, const lissom::TriangleMesh& target);

/// Twenty similarities with scales from 0.01 to 100, all different.
[[nodiscard]] std::vector<Eigen::Affine3d> twenty_similarities();

} // namespace tubes
