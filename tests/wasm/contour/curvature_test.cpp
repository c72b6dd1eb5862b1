#include "lissom/contour/curvature.h"

#include "round.h"
#include "shapes.h"

#include <doctest/doctest.h>

#include <Eigen/Eigenvalues>

#include <cmath>

using namespace lissom;
using Eigen::Vector3d;

namespace {

CurvatureField field_of(const TriangleMesh& mesh, int sweeps) {
    CurvatureField field(mesh, sweeps);
    while (field.step()) {
    }
    return field;
}

} // namespace

TEST_CASE("the shape of a sphere is 1/R everywhere, of any size") {
    for (const double R : {1e-4, 1.0, 1e4}) {
        TriangleMesh mesh = shapes::icosphere(3);
        mesh.points *= R;
        const CurvatureField field = field_of(mesh, 4);
        CHECK(field.fraction() == 1);
        for (int v = 0; v < mesh.vertex_count(); ++v) {
            const Vector3d n = mesh.points.row(v).transpose().normalized();
            CHECK((field.normals().row(v).transpose() - n).norm() < 1e-9); // Max's weights are exact here
            CHECK((R * field.tensors()[v] - (Eigen::Matrix3d::Identity() - n * n.transpose())).norm() < 0.03);
        }
    }
}

TEST_CASE("the principal curvatures of a torus are those of its formula") {
    const rounds::Torus torus;
    const TriangleMesh mesh = torus.mesh(192, 96);
    for (const int sweeps : {0, 10}) {
        const CurvatureField field = field_of(mesh, sweeps);
        double squared = 0;
        for (int v = 0; v < mesh.vertex_count(); ++v) {
            const Vector3d e = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(field.tensors()[v]).eigenvalues();
            const auto [small, large] = torus.curvatures(mesh.points.row(v).transpose());
            // One eigenvalue is the normal's 0; the trace and the sum of squares are told without it.
            squared += std::pow(e.sum() - small - large, 2) + std::pow(e.norm() - std::hypot(small, large), 2);
        }
        CHECK(std::sqrt(squared / mesh.vertex_count()) < 0.02 * torus.curvatures({torus.R + torus.r, 0, 0}).second * (sweeps == 0 ? 1 : 2));
    }
}

TEST_CASE("a tensor that is carried keeps its eigenvalues and lies across the new normal") {
    const Vector3d m = Vector3d(1, 2, 3).normalized(), n = Vector3d(-1, 2, 1).normalized();
    const Vector3d u = m.unitOrthogonal(), v = m.cross(u);
    const Eigen::Matrix3d tensor = 2 * u * u.transpose() - 3 * v * v.transpose() + 0.5 * (u * v.transpose() + v * u.transpose());
    const Eigen::Matrix3d there = carried(tensor, m, n);
    CHECK((there * n).norm() < 1e-12);
    CHECK((there - there.transpose()).norm() < 1e-12);
    const Eigen::Quaterniond turn = Eigen::Quaterniond::FromTwoVectors(m, n);
    CHECK((there - turn * tensor * turn.conjugate().toRotationMatrix()).norm() < 1e-12);
    CHECK((carried(there, n, m) - tensor).norm() < 1e-12);
}

TEST_CASE("broken meshes give numbers, none of them without meaning to a computer") {
    for (const TriangleMesh& mesh : {shapes::moebius(), shapes::with_zero_area_faces(shapes::bar()), shapes::with_needles(shapes::icosphere(2)), shapes::three_sheets(), shapes::soup(shapes::icosphere(2))}) {
        const CurvatureField field = field_of(mesh, 5);
        for (const ShapeTensor& tensor : field.tensors()) CHECK(tensor.allFinite());
        CHECK(field.smooth_normals().allFinite());
    }
}
