#include "lissom/mesh/operators.h"

#include "lissom/mesh/topology.h"
#include "shapes.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <string>

using namespace lissom;

namespace {

std::vector<TriangleMesh> a_few_shapes() {
    return {shapes::box(3, 4, 5), shapes::bumpy_sphere(2), shapes::uv_sphere(), shapes::torus(), shapes::bumpy_sheet(),
            shapes::moebius(), shapes::with_fin(shapes::icosphere(2)), shapes::three_sheets()};
}

Eigen::Affine3d similarity(double scale) {
    return Eigen::Translation3d(3, -2, 5) * Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized())
           * Eigen::Scaling(scale);
}

} // namespace

TEST_CASE("the Laplacian is symmetric, its rows sum to zero, and no vector gives it positive energy") {
    for (const TriangleMesh& mesh : a_few_shapes()) {
        const SparseMatrix L = cotangent_laplacian(mesh);
        CHECK((L - SparseMatrix(L.transpose())).norm() == 0);
        CHECK((L * Eigen::VectorXd::Ones(L.rows())).cwiseAbs().maxCoeff() < 1e-10);
        for (int axis = 0; axis < 3; ++axis) {
            const Eigen::VectorXd x = mesh.points.col(axis).array().sin();
            CHECK(x.dot(L * x) <= 1e-12);
        }
    }
}

TEST_CASE("the Laplacian of linear functions vanishes inside a plane") {
    TriangleMesh mesh = shapes::sheet(9, 7);
    for (int v = 0; v < mesh.vertex_count(); ++v) { // uneven, but flat
        const double x = mesh.points(v, 0), y = mesh.points(v, 1);
        mesh.points(v, 0) += 0.03 * std::sin(9 * y);
        mesh.points(v, 1) += 0.03 * std::sin(8 * x + y);
    }
    mesh = shapes::moved(mesh, similarity(3));
    const Points Lx = cotangent_laplacian(mesh) * mesh.points;
    const std::vector<bool> on_boundary = boundary_vertices(mesh);
    for (int v = 0; v < mesh.vertex_count(); ++v)
        if (!on_boundary[v])
            CHECK(Lx.row(v).norm() < 1e-12);
}

TEST_CASE("Dirichlet energy of the coordinates is twice the area") { // Σ over axes of ½∫|∇x|² is the area
    for (const TriangleMesh& mesh : a_few_shapes()) {
        const Points Lx = cotangent_laplacian(mesh) * mesh.points;
        CHECK(-0.5 * mesh.points.cwiseProduct(Lx).sum() == doctest::Approx(triangle_areas(mesh).sum()).epsilon(1e-10));
    }
}

TEST_CASE("the Laplacian does not know the unit of length") {
    const TriangleMesh mesh = shapes::bumpy_sphere(2);
    const SparseMatrix L = cotangent_laplacian(mesh), scaled = cotangent_laplacian(shapes::moved(mesh, similarity(1e-6)));
    CHECK((L - scaled).norm() < 1e-7 * L.norm());
}

TEST_CASE("vertex areas sum to the surface") {
    for (const TriangleMesh& mesh : a_few_shapes()) {
        const Eigen::VectorXd areas = vertex_areas(mesh);
        CHECK(areas.sum() == doctest::Approx(triangle_areas(mesh).sum()).epsilon(1e-9));
        CHECK(areas.minCoeff() > 0);
    }
}

TEST_CASE("box and sphere enclose their volume, near the origin and far from it") {
    const TriangleMesh box = shapes::box(3, 4, 5, {1, 2, 3});
    CHECK(signed_volume(box) == doctest::Approx(6).epsilon(1e-12));
    CHECK(triangle_areas(box).sum() == doctest::Approx(22).epsilon(1e-12));
    CHECK(signed_volume(shapes::moved(box, Eigen::Affine3d(Eigen::Translation3d(1e8, -1e8, 1e8)))) == doctest::Approx(6));
    CHECK(signed_volume(shapes::turned_inside_out(box)) == doctest::Approx(-6).epsilon(1e-12));
    CHECK(signed_volume(shapes::icosphere(5)) == doctest::Approx(4 * std::numbers::pi / 3).epsilon(2e-3));
    CHECK(signed_volume(shapes::double_torus(2)) == doctest::Approx(13).epsilon(1e-12)); // 15 blocks less two tunnels
}

TEST_CASE("a sphere's normals are its positions") {
    for (const TriangleMesh& mesh : {shapes::icosphere(4), shapes::uv_sphere(64, 128)})
        CHECK((vertex_normals(mesh) - mesh.points).rowwise().norm().maxCoeff() < 4e-3);
}

TEST_CASE("normals turn with the mesh and are not moved by its scale") {
    const TriangleMesh mesh = shapes::bumpy_sphere(2);
    const Eigen::Affine3d map = similarity(1e-6);
    const Points turned = vertex_normals(mesh) * Eigen::Matrix3d(map.linear() * 1e6).transpose();
    CHECK((vertex_normals(shapes::moved(mesh, map)) - turned).norm() < 1e-6);
}

TEST_CASE("degenerate triangles leave every operator finite") {
    const TriangleMesh base = shapes::bumpy_sphere(2);
    TriangleMesh point = base;
    point.points.rowwise() = Eigen::RowVector3d(1, 1, 1);
    for (const TriangleMesh& mesh : {shapes::with_zero_area_faces(base), shapes::with_needles(base),
                                     shapes::with_unused_vertices(base), shapes::with_needles(base, 4, 0), point}) {
        const SparseMatrix L = cotangent_laplacian(mesh);
        CHECK(std::isfinite(L.norm()));
        for (int k = 0; k < L.nonZeros(); ++k)
            CHECK(std::abs(L.valuePtr()[k]) < 1e6);
        CHECK(vertex_normals(mesh).allFinite());
        CHECK(vertex_areas(mesh).allFinite());
        if (triangle_areas(mesh).sum() > 0)
            CHECK(vertex_areas(mesh).minCoeff() > 0);
    }
}

TEST_CASE("needles hardly change the energy of smooth functions") { // the floor only ever softens
    const TriangleMesh mesh = shapes::with_needles(shapes::bumpy_sphere(2), 10, 1e-9);
    const Points Lx = cotangent_laplacian(mesh) * mesh.points;
    CHECK(-0.5 * mesh.points.cwiseProduct(Lx).sum() == doctest::Approx(triangle_areas(mesh).sum()).epsilon(1e-6));
}

TEST_CASE("diagonal and mean edge length are those of a cube") {
    const TriangleMesh cube = shapes::box(1, 1, 1);
    CHECK(diagonal(cube.points) == doctest::Approx(std::sqrt(3.0)));
    CHECK(mean_edge_length(cube) == doctest::Approx((12 + 6 * std::sqrt(2.0)) / 18));
    CHECK(diagonal(Points(0, 3)) == 0);
    CHECK(mean_edge_length({Points(0, 3), Triangles(0, 3)}) == 0);
}
