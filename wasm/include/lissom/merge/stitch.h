#pragma once

#include "lissom/merge/boundary_correspondence.h"
#include "lissom/merge/part.h"

namespace lissom {

/// Two parts joined along their loops. Vertices: the target part's, then the source part's (those that became one with
/// a target vertex stay in the list, unused).
struct JoinedMesh {
    TriangleMesh mesh;
    int target_vertices = 0;            ///< of the target part
    std::vector<int> vertex_of_source;  ///< per source part vertex, its vertex here
    std::vector<char> from_source;      ///< per triangle
    std::vector<int> part_triangle;     ///< per triangle, of its part
    std::vector<int> made;              ///< per triangle: −1, or its place in `made_corners`: it was cut at the seam
    std::vector<char> is_new;           ///< per triangle: none of its input's, but cut or made for the seam
    std::vector<std::array<Origin, 3>> made_corners; ///< in vertices of the input that the triangle is from
    std::vector<std::vector<int>> seams; ///< vertices of each seam, the source's surface to the left
};

/// Joins the parts along their matched loops. Both loops receive each other's vertices, and the triangles along them
/// are cut anew so that the least angle is largest; nothing else changes. The target keeps its shape exactly.
/// The seam is manifold by construction, and the Euler characteristic is the sum of the two parts'.
///
/// @param source_turned  the source's triangles are turned over
/// @param positions      of the source part, with its loops already on the target's
[[nodiscard]] JoinedMesh stitch(const Part& target, const Part& source, bool source_turned, const Points& positions,
                                std::span<const LoopMatch> matches);

/// The triangulation of a polygon (in order, in space) whose least angle is largest, counting triangles that face
/// away from `normal` as worst. n³/6 steps and n² numbers. @returns corner numbers, three a triangle
[[nodiscard]] std::vector<std::array<int, 3>> widest_triangulation(const std::vector<Eigen::Vector3d>& polygon, const Eigen::Vector3d& normal);

/// A triangulation of a triangle with many more vertices on its sides, in n steps: one side is joined to the other two
/// from end to end, each time by the wider of the two triangles that could come next.
/// @param side  corners at which that side begins and ends, at least two edges apart either way
[[nodiscard]] std::vector<std::array<int, 3>> zipped(const std::vector<Eigen::Vector3d>& polygon, std::pair<int, int> side, const Eigen::Vector3d& normal);

} // namespace lissom
