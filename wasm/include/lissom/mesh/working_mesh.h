#pragma once

#include "lissom/mesh/triangulate.h"
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
    Points source; ///< n×3 source positions, bit for bit as given (NaN and all): what an edit leaves alone
    std::vector<int> working_of_source;   ///< per source vertex; −1: in no working triangle, left alone
    std::vector<int> source_of_working;   ///< a representative (the first) source vertex per working vertex
    std::vector<int> polygon_of_triangle; ///< source face of each working triangle
    Triangles display;                    ///< every drawable triangle in SOURCE indices, faces in file order
    std::vector<int> polygon_of_display;  ///< source face of each display triangle
    Eigen::Vector3d centre = Eigen::Vector3d::Zero(); ///< of the source bounding box
    double scale = 1;                                 ///< source bounding box diagonal, > 0
    int component_count = 0;
    int boundary_loop_count = 0;
    int euler_characteristic = 0;
    bool oriented = true;   ///< triangles agree across every edge of two (after repair)
    bool closed = true;     ///< no boundary edge
    std::vector<Finding> findings;

    /// A map of source space seen from working space: N W N⁻¹ with N the normalisation.
    [[nodiscard]] Eigen::Affine3d to_working(const Eigen::Affine3d& source_map) const;
    [[nodiscard]] Eigen::Vector3d to_working(const Eigen::Vector3d& source_point) const;
    [[nodiscard]] Eigen::Vector3d to_source(const Eigen::Vector3d& working_point) const;
};

/// Makes the working copy and the report.
///
/// Points without faces get a surface to work on (`surface_through`); what goes out are the points.
///
/// Findings (code: what is done): `points-only` (a surface drawn through them), `non-finite-vertex` (left alone, its faces left out),
/// `index-out-of-range` (face left out), `face-too-small` (fewer than three different corners, left out),
/// `zero-area-face` (kept where its corners differ; collapsed, and then repaired, where welding makes them equal),
/// `duplicate-vertices` (exact equals of an earlier vertex: welded), `near-duplicate-vertices` (within 1e-6 of the
/// diagonal, both on a boundary of the exactly welded mesh, and with edges at least four times as long: welded),
/// `duplicate-face` (same vertices as an earlier one: left out), `unused-vertex` (in no working triangle: left
/// alone), `inconsistent-orientation` (faces turned in the working copy), `inside-out` (faces of closed components
/// that faced inward: turned in the working copy), `non-orientable` (tolerated; one per one-sided piece),
/// `non-manifold-edge` (examples are one end of each), `non-manifold-vertex` (tolerated), `several-components`,
/// `open-boundary` (information; one example vertex each), `far-from-origin` (farther than a thousand diagonals:
/// moved in the working copy), `needle-face` (lower than a thousandth of its longest side: tolerated).
/// Each stands once, in this order.
///
/// Centre and scale are those of the vertices that usable faces use, so that a stray one cannot shrink the model.
/// Numbers are counted in the order of the source: renumbering the source renumbers the copy and no more.
/// Cost: linear but for sorting the edges of one vertex; half a million triangles take well under a second.
///
/// @throws InvalidInput `no-vertices`, `no-faces`, `bad-offsets`, `no-usable-faces`, `zero-size`
[[nodiscard]] WorkingMesh make_working_mesh(const PolygonMesh& source);

} // namespace lissom
