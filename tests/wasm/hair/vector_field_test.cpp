#include "lissom/hair/vector_field.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace lissom;
using Eigen::Vector3d;

namespace {

const Grid k_grid{{-1, 2, 0.5}, 0.3, {6, 4, 5}};
const Eigen::Matrix3d k_linear = (Eigen::Matrix3d() << 1, 2, -1, 0.5, -3, 2, 4, 0, 1).finished();

Vector3d linear(const Vector3d& p) { return k_linear * p + Vector3d(1, -2, 3); }

VectorField linear_field() {
    VectorField field{k_grid, Points(k_grid.count(), 3)};
    for (int node = 0; node < k_grid.count(); ++node) field.vectors.row(node) = linear(k_grid.position(node)).transpose();
    return field;
}

} // namespace

TEST_CASE("a linear field is read exactly everywhere, at the walls too") {
    const VectorField field = linear_field();
    const Vector3d extent = k_grid.step * (k_grid.size.array() - 1).cast<double>();
    for (int i = 0; i < 300; ++i) {
        Vector3d share = 0.5 * (Vector3d::Ones() + Vector3d(std::sin(1.7 * i), std::cos(2.9 * i), std::sin(0.6 * i + 1)));
        if (i % 4 == 0) share[i % 3] = i % 8 ? 1 : 0;
        const Vector3d p = k_grid.origin + share.cwiseProduct(extent);
        CHECK((field.at(p) - linear(p)).norm() < 1e-12);
    }
}

TEST_CASE("nodes are read as they are") {
    const VectorField field = linear_field();
    for (int node = 0; node < k_grid.count(); ++node) CHECK((field.at(k_grid.position(node)) - field.vectors.row(node).transpose()).norm() < 1e-12);
}

TEST_CASE("a point outside reads its nearest place inside") {
    const VectorField field = linear_field();
    const Vector3d last = k_grid.position(k_grid.count() - 1);
    CHECK((field.at(last + Vector3d(1, 2, 3)) - linear(last)).norm() < 1e-12);
    CHECK((field.at(k_grid.origin - Vector3d(1e6, 0, 0)) - linear(k_grid.origin)).norm() < 1e-9);
    const Vector3d inside(-0.7, 2.2, 0.9);
    CHECK((field.at({99, inside.y(), inside.z()}) - linear({last.x(), inside.y(), inside.z()})).norm() < 1e-12);
}
