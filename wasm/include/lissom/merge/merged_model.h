#pragma once

#include "lissom/merge/stitch.h"
#include "lissom/mesh/working_mesh.h"

namespace lissom {

/// What of one file goes into the merged model. Vertices and polygons are the file's.
struct Contribution {
    std::vector<int> result_of_vertex; ///< per file vertex: its number in the result; −1: left out
    std::vector<int> faces;            ///< polygons that go in whole, ascending
    std::vector<char> turned;          ///< per such polygon: its corners in reverse
};

/// The merged model in the terms of its two files: whatever the seam does not touch keeps its vertices, polygons and
/// corners, so that whoever holds the files can carry colours and texture coordinates along.
///
/// Vertices: kept target vertices in file order, kept source vertices in file order, new ones. Faces: whole target
/// polygons, whole source polygons, then the triangles that were cut.
struct MergedModel {
    Points positions;
    Contribution target, source;
    std::vector<char> new_from_source;  ///< per new vertex: which file its origin is in
    std::vector<Origin> new_origin;     ///< per new vertex: file vertices and weights
    std::vector<int> cut_vertices;      ///< three a cut triangle, of the result
    std::vector<char> cut_from_source;  ///< per cut triangle: which file it is from
    std::vector<int> cut_face;          ///< per cut triangle: its polygon in that file
    std::vector<Origin> cut_corners;    ///< three a cut triangle: vertices of that polygon and weights
    std::vector<std::vector<int>> seams; ///< vertices of each seam in the result, the source's surface to the left
    int euler_characteristic = 0;       ///< of the joined, welded surface
};

/// @param joined  in the target's working space; vertices of the target that did not move keep their file's positions
///                bit for bit
/// @param moved   per joined vertex below `joined.target_vertices`: it did move
[[nodiscard]] MergedModel to_files(const JoinedMesh& joined, const Part& target_part, const WorkingMesh& target, const Part& source_part,
                                   const WorkingMesh& source, const std::vector<char>& moved);

} // namespace lissom
