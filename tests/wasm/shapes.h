#pragma once

// Meshes made by formula: every C++ test draws its input from here. All are deterministic; closed ones face outward.

#include "lissom/mesh/working_mesh.h"

#include <cstdint>
#include <vector>

namespace shapes {

using lissom::Points;
using lissom::PolygonMesh;
using lissom::TriangleMesh;
using lissom::Triangles;

/// Closed box, its sides regular grids of exactly coplanar vertices; x and z centred, y from 0 to size.y.
/// The bar of 2,050 vertices, 1 × 8 × 1, is box(8, 60, 8, {1, 8, 1}).
[[nodiscard]] TriangleMesh box(int nx, int ny, int nz, const Eigen::Vector3d& size = {1, 1, 1});
[[nodiscard]] TriangleMesh bar();

/// Unit sphere by meridians and parallels: slivers near the poles.
[[nodiscard]] TriangleMesh uv_sphere(int parallels = 16, int meridians = 32);
/// Unit sphere of 20·4^levels even triangles.
[[nodiscard]] TriangleMesh icosphere(int levels = 3);
/// The icosphere with waves in its radius: no symmetry, no flat side.
[[nodiscard]] TriangleMesh bumpy_sphere(int levels = 3);
/// Genus 1, radii 1 and 0.38.
[[nodiscard]] TriangleMesh torus(int around = 32, int across = 16);
/// Genus 2: a block with two square tunnels, 5k × 3k × k cells.
[[nodiscard]] TriangleMesh double_torus(int k = 2);
/// Flat open sheet in z = 0, (nx+1)×(ny+1) vertices, unit width, rows along x first.
[[nodiscard]] TriangleMesh sheet(int nx = 10, int ny = 10);
/// The sheet with hills: no two triangles coplanar.
[[nodiscard]] TriangleMesh bumpy_sheet(int nx = 10, int ny = 10);
/// Flat ring in z = 0, radius 1 to 2, `rows` rows of `around` vertices, the inner border first, facing +z.
[[nodiscard]] TriangleMesh flat_ring(int rows = 8, int around = 20);
/// Open at both ends, radius 1, along z from 0 to height.
[[nodiscard]] TriangleMesh cylinder(int around = 24, int along = 12, double height = 3);
/// One-sided strip with one boundary loop.
[[nodiscard]] TriangleMesh moebius(int around = 60, int across = 6);
/// Closed and one-sided; crosses itself.
[[nodiscard]] TriangleMesh klein_bottle(int around = 48, int across = 24);
/// Two unit icospheres, two diameters apart.
[[nodiscard]] TriangleMesh two_spheres(int levels = 2);
/// Three half sheets on one line, whose edges have three triangles each.
[[nodiscard]] TriangleMesh three_sheets(int n = 6);
/// Two sheets that share one corner vertex only.
[[nodiscard]] TriangleMesh bow_tie(int n = 4);

/// Several meshes in one, vertices and triangles in the order given.
[[nodiscard]] TriangleMesh joined(const std::vector<TriangleMesh>& parts);
[[nodiscard]] TriangleMesh moved(TriangleMesh mesh, const Eigen::Affine3d& map);
[[nodiscard]] TriangleMesh turned_inside_out(TriangleMesh mesh);

// Broken inputs. ------------------------------------------------------------------------------------------

/// Every triangle has corners of its own; each coordinate is off by up to ± jitter.
[[nodiscard]] TriangleMesh soup(const TriangleMesh& mesh, double jitter = 0);
/// One more triangle on the first edge, with a new vertex: that edge has three.
[[nodiscard]] TriangleMesh with_fin(TriangleMesh mesh);
/// Triangle `face` runs the other way.
[[nodiscard]] TriangleMesh with_flipped_face(TriangleMesh mesh, int face = 0);
/// Every `every`-th triangle runs the other way.
[[nodiscard]] TriangleMesh with_mixed_orientation(TriangleMesh mesh, int every = 3);
/// `count` vertices that no triangle uses, spread between the others and not at the end alone.
[[nodiscard]] TriangleMesh with_unused_vertices(const TriangleMesh& mesh, int count = 3);
/// Splits the first edge by a vertex exactly at its start: two triangles without area, positions repeated.
[[nodiscard]] TriangleMesh with_zero_area_faces(TriangleMesh mesh);
/// Splits `count` triangles at a point `thinness` of the way from their first edge: needles.
[[nodiscard]] TriangleMesh with_needles(TriangleMesh mesh, int count = 4, double thinness = 1e-9);
/// A small tetrahedron beside the mesh, in no handle's reach.
[[nodiscard]] TriangleMesh with_extra_shell(const TriangleMesh& mesh);
/// Every triangle of the first `count` a second time.
[[nodiscard]] TriangleMesh with_duplicate_faces(TriangleMesh mesh, int count = 3);
/// Vertex v has no finite position.
[[nodiscard]] TriangleMesh with_nan_vertex(TriangleMesh mesh, int v = 0);

/// A name and a mesh: the eight inputs that defeat other libraries.
struct Broken {
    const char* name;
    TriangleMesh mesh;
};
[[nodiscard]] std::vector<Broken> eight_broken(const TriangleMesh& mesh);

// Other views of a mesh. ----------------------------------------------------------------------------------

/// A shuffle of 0 … n−1: new place of each old index.
[[nodiscard]] std::vector<int> permutation(int n, std::uint64_t seed);
/// Vertex i of the mesh becomes vertex new_place[i]; triangles keep their order.
[[nodiscard]] TriangleMesh permuted(const TriangleMesh& mesh, const std::vector<int>& new_place);
/// The mesh as a file would give it.
[[nodiscard]] PolygonMesh polygons(const TriangleMesh& mesh);
[[nodiscard]] PolygonMesh polygons(const Points& points, const std::vector<std::vector<int>>& faces);
/// What solvers see of it.
[[nodiscard]] inline lissom::WorkingMesh working(const TriangleMesh& mesh) {
    return lissom::make_working_mesh(polygons(mesh));
}

} // namespace shapes
