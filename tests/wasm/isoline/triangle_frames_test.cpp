#include "lissom/isoline/triangle_frames.h"

#include "shapes.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>

using namespace lissom;

TEST_CASE("a common rotation is every triangle's and every vertex's, on flat surfaces, too") {
    const Eigen::Matrix3d R = Eigen::AngleAxisd(2.1, Eigen::Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();
    for (const TriangleMesh& mesh : {shapes::bumpy_sphere(2), shapes::sheet(), shapes::bar()}) {
        const Points moved = (mesh.points * R.transpose()).rowwise() + Eigen::RowVector3d(3, 1, -4);
        for (const Eigen::Matrix3d& F : triangle_gradients(mesh, moved)) CHECK((F - R).norm() < 1e-9);
        for (const Eigen::Matrix3d& F : vertex_rotations(mesh, moved)) CHECK((F - R).norm() < 1e-9);
    }
}

TEST_CASE("edges map as the surface does, the normal to the normal") {
    const TriangleMesh mesh = shapes::bumpy_sphere(1);
    Points moved = mesh.points;
    for (Eigen::Index v = 0; v < moved.rows(); ++v) moved.row(v) << 2 * moved(v, 0), moved(v, 1) + moved(v, 0) * moved(v, 0), moved(v, 2);
    const auto gradients = triangle_gradients(mesh, moved);
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        const auto frame = [&](const Points& p) { return triangle_frame(p.row(mesh.triangles(t, 0)), p.row(mesh.triangles(t, 1)), p.row(mesh.triangles(t, 2))); };
        CHECK((gradients[t] * frame(mesh.points) - frame(moved)).norm() < 1e-12);
    }
}

TEST_CASE("a triangle without area is left as it is, and hurts no neighbour") {
    const TriangleMesh mesh = shapes::with_zero_area_faces(shapes::bumpy_sphere(2));
    const Eigen::Matrix3d R = Eigen::AngleAxisd(1, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    const Points moved = mesh.points * R.transpose();
    for (const Eigen::Matrix3d& F : triangle_gradients(mesh, moved)) CHECK(F.allFinite());
    for (const Eigen::Matrix3d& F : vertex_rotations(mesh, moved)) CHECK((F - R).norm() < 1e-9);
}
