#include "lissom/isoline/harmonic_fields.h"

#include "shapes.h"

#include "lissom/mesh/operators.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace lissom;

namespace {

/// Handles where the k-th coordinate comes near its ends, `count` of them: ±x, ±y, ±z.
std::vector<int> caps(const TriangleMesh& mesh, int count, double share = 0.1) {
    std::vector<int> handle(static_cast<std::size_t>(mesh.vertex_count()), -1);
    for (int h = count - 1; h >= 0; --h) {
        const Eigen::VectorXd along = (h % 2 ? -1.0 : 1.0) * mesh.points.col(h / 2);
        const double high = along.maxCoeff(), low = along.minCoeff();
        for (int v = 0; v < mesh.vertex_count(); ++v)
            if (along[v] >= high - share * (high - low)) handle[v] = h;
    }
    return handle;
}

Columns fields_of(const TriangleMesh& mesh, const std::vector<int>& handle, int handles) {
    HarmonicFields fields(mesh, cotangent_laplacian(mesh), handle, handles);
    while (fields.step()) {
    }
    CHECK(fields.fraction() == 1);
    return fields.solve();
}

} // namespace

TEST_CASE("fields sum to one, lie in [0, 1], and are one on their handle and zero on the others") {
    for (const TriangleMesh& mesh : {shapes::bumpy_sphere(3), shapes::torus(), shapes::double_torus(3), shapes::bumpy_sheet(20, 20)})
        for (const int handles : {2, 3, 4}) {
            const std::vector<int> handle = caps(mesh, handles);
            const Columns fields = fields_of(mesh, handle, handles);
            CHECK((fields.rowwise().sum().array() - 1).abs().maxCoeff() < 1e-14);
            CHECK(fields.minCoeff() >= 0);
            for (int v = 0; v < mesh.vertex_count(); ++v)
                if (handle[v] >= 0) CHECK(fields(v, handle[v]) == 1);
        }
}

TEST_CASE("between two ends of a tube the field is the height") {
    const TriangleMesh tube = shapes::cylinder(24, 40, 3);
    std::vector<int> handle(static_cast<std::size_t>(tube.vertex_count()), -1);
    for (int v = 0; v < tube.vertex_count(); ++v) {
        if (tube.points(v, 2) < 1e-9) handle[v] = 0;
        if (tube.points(v, 2) > 3 - 1e-9) handle[v] = 1;
    }
    const Columns fields = fields_of(tube, handle, 2);
    for (int v = 0; v < tube.vertex_count(); ++v) CHECK(std::abs(fields(v, 1) - tube.points(v, 2) / 3) < 3e-4);
    const Columns rigidity = rigidity_fields(tube, fields);
    CHECK((rigidity.array() - 1.0 / 3).abs().maxCoeff() < 2e-3);
    CHECK(combined_rigidity(rigidity).maxCoeff() == doctest::Approx(std::sqrt(2.0) / 3).epsilon(5e-3));
    const Columns gradients = field_gradients(tube, fields);
    for (int v = 0; v < tube.vertex_count(); ++v) CHECK(std::abs(gradients(v, 5) - 1.0 / 3) < 2e-3);
}

TEST_CASE("what no handle holds has no field, one handle has all of it") {
    const TriangleMesh mesh = shapes::two_spheres(2);
    std::vector<int> handle(static_cast<std::size_t>(mesh.vertex_count()), -1);
    handle[0] = 0;
    const Columns fields = fields_of(mesh, handle, 1);
    for (int v = 0; v < mesh.vertex_count(); ++v) CHECK(fields(v, 0) == (v < mesh.vertex_count() / 2 ? 1 : 0));
}

TEST_CASE("a bulge that no path between handles crosses is rigid") {
    const TriangleMesh mesh = shapes::bumpy_sphere(4);
    std::vector<int> handle(static_cast<std::size_t>(mesh.vertex_count()), -1);
    for (int v = 0; v < mesh.vertex_count(); ++v) { // two handles close to each other at the top
        const Eigen::RowVector3d p = mesh.points.row(v).normalized();
        if ((p - Eigen::RowVector3d(0.3, 0.954, 0)).norm() < 0.15) handle[v] = 0;
        if ((p - Eigen::RowVector3d(-0.3, 0.954, 0)).norm() < 0.15) handle[v] = 1;
    }
    const Eigen::VectorXd psi = combined_rigidity(rigidity_fields(mesh, fields_of(mesh, handle, 2)));
    int top = 0, bottom = 0;
    mesh.points.col(1).maxCoeff(&top);
    mesh.points.col(1).minCoeff(&bottom);
    CHECK(psi[bottom] < 0.05 * psi[top]);
}

TEST_CASE("rigidity is one over length, fields have no unit") {
    TriangleMesh mesh = shapes::bumpy_sphere(3);
    const std::vector<int> handle = caps(mesh, 3);
    const Columns here = fields_of(mesh, handle, 3), psi = rigidity_fields(mesh, here);
    mesh.points *= 1e3;
    const Columns there = fields_of(mesh, handle, 3);
    CHECK((here - there).cwiseAbs().maxCoeff() < 1e-10);
    CHECK((rigidity_fields(mesh, there) * 1e3 - psi).cwiseAbs().maxCoeff() < 1e-8 * psi.maxCoeff());
}
