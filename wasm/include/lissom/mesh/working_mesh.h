#pragma once

#include "lissom/mesh/types.h"

#include <Eigen/Geometry>

#include <string>
#include <vector>

namespace lissom {

/// One line of the import report: what was found, how often, where, and what was done about it.
struct Finding {
    std::string code;          ///< kebab-case, e.g. "duplicate-vertices"; the app translates it
    int count = 0;             ///< how many elements
    std::vector<int> examples; ///< at most 8 source indices (vertices or faces, by the code)
    bool repaired = false;     ///< true: mended in the working copy; false: tolerated
};

/// The copy of a model that solvers work on: triangulated, welded, finite, oriented where it can be,
/// moved to the origin and scaled to a unit diagonal; with the way back to the source vertices.
///
/// Source vertices, faces and their order are never changed: results are written back through
/// `working_of_source`, so what goes out has the topology that came in.
struct WorkingMesh {
    TriangleMesh mesh;
    std::vector<int> working_of_source;   ///< per source vertex; −1: unused or not finite, left alone
    std::vector<int> source_of_working;   ///< a representative (the first) source vertex per working vertex
    std::vector<int> polygon_of_triangle; ///< source face of each working triangle
    Triangles display;                    ///< every drawable triangle in SOURCE indices, faces in file order
    std::vector<int> polygon_of_display;  ///< source face of each display triangle
    Eigen::Vector3d centre = Eigen::Vector3d::Zero(); ///< of the source bounding box
    double scale = 1;                                 ///< source bounding box diagonal, > 0
    int component_count = 0;
    int boundary_loop_count = 0;
    int euler_characteristic = 0;
    bool oriented = true;   ///< triangles agree across every edge (after repair)
    bool closed = true;     ///< no boundary edge
    std::vector<Finding> findings;

    /// A map of source space seen from working space: N W N⁻¹ with N the normalisation.
    [[nodiscard]] Eigen::Affine3d to_working(const Eigen::Affine3d& source_map) const;
    [[nodiscard]] Eigen::Vector3d to_working(const Eigen::Vector3d& source_point) const;
    [[nodiscard]] Eigen::Vector3d to_source(const Eigen::Vector3d& working_point) const;
};

/// Makes the working copy and the report.
///
/// Findings (code: what is done): `non-finite-vertex` (left alone, its faces left out),
/// `index-out-of-range` (face left out), `face-too-small` (fewer than three different corners, left out),
/// `zero-area-face` (kept where its corners differ; collapsed where welding makes them equal),
/// `duplicate-vertices` (exact equals welded), `near-duplicate-vertices` (within 1e-7 of the diagonal AND
/// both on a boundary of the exactly welded mesh: welded), `duplicate-face` (left out),
/// `unused-vertex` (left alone), `inconsistent-orientation` (turned in the working copy),
/// `non-orientable` (tolerated), `non-manifold-edge`, `non-manifold-vertex` (tolerated),
/// `several-components`, `open-boundary` (information), `far-from-origin` (moved in the working copy),
/// `needle-face` (tolerated).
///
/// @throws InvalidInput `no-vertices`, `no-faces`, `no-usable-faces`, `zero-size`
[[nodiscard]] WorkingMesh make_working_mesh(const PolygonMesh& source);

/// The triangles of each polygon, in source indices: quads along their better diagonal, larger polygons by
/// ear clipping in their best-fit plane; never fewer than k − 2 triangles for k different corners.
/// Degenerate polygons and those with an index out of range or a non-finite corner give none.
struct Triangulation {
    Triangles triangles;
    std::vector<int> polygon_of_triangle;
};
[[nodiscard]] Triangulation triangulate(const PolygonMesh& source);

} // namespace lissom
