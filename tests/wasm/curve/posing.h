#pragma once

// Sessions of curves made in one line, and what their poses are measured by.

#include "shapes.h"

#include "lissom/curve/pose.h"

#include <memory>
#include <span>
#include <vector>

namespace posing {

using lissom::CurveOptions;
using lissom::CurvePosture;
using lissom::CurveSession;
using lissom::CurveSpec;
using lissom::Points;
using lissom::TriangleMesh;

/// A session that is prepared. Its points are those of the mesh: nothing is welded away.
[[nodiscard]] CurveSession session(const TriangleMesh& mesh, std::vector<CurveSpec> curves, std::vector<lissom::CurveLink> links = {}, CurveOptions options = {});

/// Points at equal steps of a straight line.
[[nodiscard]] Points line(const Eigen::Vector3d& from, const Eigen::Vector3d& to, int count);
[[nodiscard]] Points row_list(const std::vector<Eigen::Vector3d>& points);
[[nodiscard]] Points mapped(const Points& points, const Eigen::Affine3d& map);

/// The bar 1 × 10 × 1 that figures are measured on, and its axis.
[[nodiscard]] TriangleMesh bar(int cells);
[[nodiscard]] Points axis(int count);
/// An arc of so many degrees as long as the bar, from its foot.
[[nodiscard]] Points arc(double degrees, int count);

[[nodiscard]] double gap(const Points& a, const Points& b); ///< largest distance of two rows

/// Changes of the angles between neighbouring triangles, degrees, ascending.
[[nodiscard]] std::vector<double> dihedral_changes(const TriangleMesh& mesh, const Points& moved);
[[nodiscard]] double percentile(const std::vector<double>& ascending, double share);
/// Largest ratio of an edge's length to that at rest, of edges that `counts` says yes to (both ends).
[[nodiscard]] double edge_stretch(const TriangleMesh& mesh, const Points& moved);
/// Triangles that face against the motion of the nearest row: normals that turned by more than 90 degrees from where `expected` has them.
[[nodiscard]] int flipped(const TriangleMesh& mesh, const Points& moved, const Points& expected_normals);
/// Pairs of triangles that cross.
[[nodiscard]] int crossings(const TriangleMesh& mesh, const Points& moved);

/// What a vertex shader makes of the attributes and the table, in single precision.
[[nodiscard]] Points drawn(const CurveSession& session, std::span<const CurvePosture> postures, const Points& rest);
/// Normals turned by the blended motion alone.
[[nodiscard]] Points turned(const CurveSession& session, std::span<const CurvePosture> postures, const Points& normals);

} // namespace posing
