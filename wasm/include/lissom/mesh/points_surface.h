#pragma once

#include "lissom/mesh/types.h"

namespace lissom {

/// A surface through scattered points, whose vertices they are: what a scan without faces is worked on.
///
/// Around each point its neighbours are laid into the plane that fits them best; those whose cells touch its own there make a
/// fan of triangles (the localized Delaunay triangulation of Gopi, Krishnan and Silva 2000). Triangles that the fans of all their
/// corners want come first, then those of two and of one, best shaped first, as long as no edge gets a third triangle or two
/// that lie on one another. Neighbours much farther away than the others, or around an empty corner, are left out: a border. Sheets stay apart
/// where five of their spacings lie between them.
///
/// Even spacing is not needed, an orientation neither: neighbours agree, and pieces that enclose something face outwards. Points in rows have no preferred
/// diagonal: they get the same one everywhere. Independent of scale and motion, but for clouds whose own axes are not
/// decided.
/// Linear but for sorting: a hundred thousand points in under a second.
///
/// @param points  n×3, finite. Points in one place count once; the first of them is the corner.
/// @return m×3 numbers of points; empty for fewer than three places or for points on a line
[[nodiscard]] Triangles surface_through(const Points& points);

} // namespace lissom
