#include "lissom/isoline/taubin.h"

#include "shapes.h"

#include "lissom/mesh/operators.h"

#include <doctest/doctest.h>

#include <numbers>
#include <random>

using namespace lissom;

namespace {

TriangleMesh jittered(TriangleMesh mesh, double share) {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> amount(-1, 1);
    const double reach = share * mean_edge_length(mesh);
    for (Eigen::Index v = 0; v < mesh.points.rows(); ++v)
        for (int k = 0; k < 3; ++k) mesh.points(v, k) += reach * amount(random);
    return mesh;
}

double roughness(const TriangleMesh& mesh) {
    const VertexRings rings = vertex_rings(mesh);
    double sum = 0;
    for (int v = 0; v < mesh.vertex_count(); ++v) sum += std::abs(mesh.points.row(v).norm() - 1);
    return sum / mesh.vertex_count();
}

} // namespace

TEST_CASE("twenty pairs of steps take noise off a sphere and keep its volume") {
    const TriangleMesh clean = shapes::icosphere(4);
    TriangleMesh noisy = jittered(clean, 0.3);
    const double before = roughness(noisy);
    const VertexRings rings = vertex_rings(noisy);
    for (int k = 0; k < 20; ++k) taubin_step(noisy.points, rings);
    CHECK(roughness(noisy) < 0.4 * before);
    CHECK(signed_volume(noisy) == doctest::Approx(signed_volume(clean)).epsilon(0.02));
}

TEST_CASE("smoothing does not know the unit of length, nor where the origin is") {
    TriangleMesh here = jittered(shapes::icosphere(3), 0.2), there = here;
    there.points = 1000 * here.points;
    there.points.rowwise() += Eigen::RowVector3d(5, -7, 9);
    const VertexRings rings = vertex_rings(here);
    taubin_step(here.points, rings);
    taubin_step(there.points, rings);
    Points moved = 1000 * here.points;
    moved.rowwise() += Eigen::RowVector3d(5, -7, 9);
    CHECK((there.points - moved).cwiseAbs().maxCoeff() < 1e-9);
}

TEST_CASE("vertices that are kept stay") {
    TriangleMesh mesh = jittered(shapes::bumpy_sheet(12, 12), 0.2);
    const Points before = mesh.points;
    const std::vector<bool> border = boundary_vertices(mesh);
    taubin_step(mesh.points, vertex_rings(mesh), border);
    for (int v = 0; v < mesh.vertex_count(); ++v) CHECK((mesh.points.row(v) == before.row(v)) == border[v]);
}

TEST_CASE("ring areas sum to the surface, and need no good angle") {
    for (const TriangleMesh& mesh : {shapes::bumpy_sphere(3), shapes::torus(), shapes::with_needles(shapes::bumpy_sphere(2))})
        CHECK(ring_areas(mesh).sum() == doctest::Approx(triangle_areas(mesh).sum()).epsilon(1e-4));
}

TEST_CASE("the bending energy of a sphere is that of its curvature, whatever its size and its mesh") {
    for (const int levels : {3, 4})
        for (const double radius : {1.0, 1e3}) {
            TriangleMesh sphere = shapes::icosphere(levels);
            sphere.points *= radius;
            CHECK(bending_energy(sphere) == doctest::Approx(16 * std::numbers::pi).epsilon(0.03)); // |Δx| = 2/r over 4πr²
        }
}

TEST_CASE("smoothing takes most of the bending energy of noise, and next to none of a clean mesh's") {
    const auto left = [](TriangleMesh mesh) {
        const std::vector<bool> border = boundary_vertices(mesh);
        const double before = bending_energy(mesh, border);
        const VertexRings rings = vertex_rings(mesh);
        for (int k = 0; k < 3; ++k) taubin_step(mesh.points, rings, border);
        return bending_energy(mesh, border) / before;
    };
    for (const TriangleMesh& mesh : {shapes::bumpy_sphere(4), shapes::torus(64, 32), shapes::bumpy_sheet(40, 40)}) {
        CHECK(left(mesh) > 0.8);
        CHECK(left(jittered(mesh, 0.3)) < 0.5);
    }
}
