#include "lissom/match/fine_fit.h"

#include "lissom/mesh/topology.h"
#include "shapes.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace lissom;
using Eigen::Vector3d;

namespace {

template <class Move>
std::vector<Pull> pulled(const TriangleMesh& mesh, Move move, int every = 1) {
    std::vector<Pull> pulls;
    for (int v = 0; v < mesh.vertex_count(); v += every) pulls.push_back(Pull::of_vertex(v, mesh.points.row(v).transpose() + move(Vector3d(mesh.points.row(v))), 1));
    return pulls;
}

} // namespace

TEST_CASE("what is pulled to where it is stays; what is pulled alike moves alike, however stiff, pulled at all vertices or at some") {
    for (const TriangleMesh& mesh : {shapes::bumpy_sphere(), shapes::bumpy_sheet()}) {
        FineFit fit(mesh);
        for (const double stiffness : {20.0, 0.3}) {
            CHECK(fit.solve(mesh.points, pulled(mesh, [](const Vector3d&) -> Vector3d { return Vector3d::Zero(); }), {}, stiffness).norm() < 1e-12);
            for (const int every : {1, 5}) {
                const Points moves = fit.solve(mesh.points, pulled(mesh, [](const Vector3d&) { return Vector3d(0.1, -0.2, 0.3); }, every), {}, stiffness);
                CHECK((moves.rowwise() - Eigen::RowVector3d(0.1, -0.2, 0.3)).rowwise().norm().maxCoeff() < 1e-5);
            }
        }
    }
}

TEST_CASE("places inside triangles pull their corners") {
    const TriangleMesh mesh = shapes::bumpy_sheet();
    std::vector<Pull> pulls;
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        Pull pull{{mesh.triangles(t, 0), mesh.triangles(t, 1), mesh.triangles(t, 2)}, {0.2, 0.3, 0.5}, Vector3d(0, 0, 0.1)};
        for (int k = 0; k < 3; ++k) pull.target += pull.weights[k] * mesh.points.row(pull.vertices[k]).transpose();
        pulls.push_back(pull);
    }
    const Points moves = FineFit(mesh).solve(mesh.points, pulls, {}, 1);
    CHECK((moves.rowwise() - Eigen::RowVector3d(0, 0, 0.1)).rowwise().norm().maxCoeff() < 1e-6);
}

TEST_CASE("it is the least of what the header says") {
    const TriangleMesh mesh = shapes::bumpy_sphere(1);
    const auto pulls = pulled(mesh, [](const Vector3d& x) -> Vector3d { return 0.2 * Vector3d(std::sin(9 * x.y()), std::cos(7 * x.z()), std::sin(8 * x.x())); }, 2);
    const double stiffness = 0.7;
    const Points best = FineFit(mesh).solve(mesh.points, pulls, {}, stiffness);
    const VertexRings rings = vertex_rings(mesh);
    const auto energy = [&](const Points& d) {
        double sum = 0;
        for (const Pull& pull : pulls) sum += (mesh.points.row(pull.vertices[0]) + d.row(pull.vertices[0]) - pull.target.transpose()).squaredNorm();
        for (int v = 0; v < mesh.vertex_count(); ++v) {
            Eigen::RowVector3d mean = Eigen::RowVector3d::Zero();
            for (const int w : rings[v]) mean += d.row(w) / static_cast<double>(rings[v].size());
            sum += stiffness * (d.row(v) - mean).squaredNorm();
        }
        return sum;
    };
    const double least = energy(best);
    for (int v = 0; v < mesh.vertex_count(); v += 5)
        for (const double by : {-1e-3, 1e-3}) {
            Points other = best;
            other(v, v % 3) += by;
            CHECK(energy(other) > least);
        }
}

TEST_CASE("held vertices move exactly as told, and take along what nothing else pulls") {
    const TriangleMesh mesh = shapes::bumpy_sphere();
    const std::vector<FineFit::Held> held{{3, mesh.points.row(3).transpose() + Vector3d(0.1, 0, 0)}, {100, mesh.points.row(100).transpose() + Vector3d(0.1, 0, 0)}};
    const Points moves = FineFit(mesh).solve(mesh.points, {}, held, 20);
    CHECK(((moves.row(3) + mesh.points.row(3)).transpose() - held[0].target).norm() < 1e-15);
    CHECK((moves.rowwise() - Eigen::RowVector3d(0.1, 0, 0)).rowwise().norm().maxCoeff() < 0.01);
}

TEST_CASE("isolated vertices, single triangles and needles give finite moves") {
    const TriangleMesh one{(Points(3, 3) << 0, 0, 0, 1, 0, 0, 0, 1, 0).finished(), (Triangles(1, 3) << 0, 1, 2).finished()};
    for (const TriangleMesh& mesh : {one, shapes::with_unused_vertices(shapes::sheet(3, 3)), shapes::with_needles(shapes::sheet(3, 3)), shapes::three_sheets(3)})
        CHECK(FineFit(mesh).solve(mesh.points, pulled(mesh, [](const Vector3d& x) -> Vector3d { return 0.1 * x; }, 2), {}, 5).allFinite());
}
