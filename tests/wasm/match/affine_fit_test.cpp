#include "lissom/match/affine_fit.h"

#include "shapes.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>

#include <cmath>

using namespace lissom;
using Eigen::Vector3d;

namespace {

/// Every vertex to where `map` carries it.
template <class Map>
std::vector<Pull> all_pulled(const Points& points, Map map, int every = 1) {
    std::vector<Pull> pulls;
    for (int v = 0; v < points.rows(); v += every) pulls.push_back(Pull::of_vertex(v, map(Vector3d(points.row(v))), 1));
    return pulls;
}
TriangleMesh ball() {
    TriangleMesh mesh = shapes::bumpy_sphere();
    mesh.points *= 0.3;
    return mesh;
}
double apart(const Points& a, const Points& b) { return (a - b).rowwise().norm().maxCoeff(); }

} // namespace

TEST_CASE("pulled to where it is a surface stays, pulled by an affine map it follows nearly exactly") {
    const TriangleMesh mesh = ball();
    const NodeGraph graph(edge_graph(mesh), 0.1);
    AffineFit fit(mesh.points, mesh.triangles, graph, mesh.points);
    const auto same = [](const Vector3d& x) { return x; };
    for (const double stiffness : {5.0, 0.02}) CHECK(apart(fit.solve(all_pulled(mesh.points, same), stiffness), mesh.points) < 1e-12);
    const Eigen::Affine3d map = Eigen::Translation3d(0.2, -0.1, 0.4) * Eigen::AngleAxisd(1.5, Vector3d(1, 2, 1).normalized()) * Eigen::Scaling(1.0, 1.5, 0.8);
    const Points image = shapes::moved(mesh, map).points;
    CHECK(apart(fit.solve(all_pulled(mesh.points, [&](const Vector3d& x) -> Vector3d { return map * x; }), 0.02), image) < 1e-5); // but for the 10⁻⁴ λ that keeps the shape
    // Places inside triangles and few of them do it as well.
    std::vector<Pull> inside;
    for (int t = 0; t < mesh.triangle_count(); t += 5) {
        Pull pull{{mesh.triangles(t, 0), mesh.triangles(t, 1), mesh.triangles(t, 2)}, {0.2, 0.5, 0.3}, Vector3d::Zero(), 2};
        for (int k = 0; k < 3; ++k) pull.target += pull.weights[k] * image.row(pull.vertices[k]).transpose();
        inside.push_back(pull);
    }
    CHECK(apart(fit.solve(inside, 0.02), image) < 1e-5);
}

TEST_CASE("the softer, the nearer to where it is pulled") {
    const TriangleMesh mesh = ball();
    const NodeGraph graph(edge_graph(mesh), 0.1);
    const auto bent = [](const Vector3d& x) -> Vector3d { return x + 0.05 * Vector3d(std::sin(9 * x.y()), std::cos(7 * x.z()), std::sin(8 * x.x())); };
    double last = INFINITY;
    for (const double stiffness : {5.0, 0.5, 0.05, 0.005}) {
        AffineFit fit(mesh.points, mesh.triangles, graph, mesh.points);
        const Points moved = fit.solve(all_pulled(mesh.points, bent), stiffness);
        double sum = 0;
        for (int v = 0; v < mesh.vertex_count(); ++v) sum += (moved.row(v).transpose() - bent(mesh.points.row(v))).squaredNorm();
        CHECK(sum < last);
        last = sum;
    }
    CHECK(std::sqrt(last / mesh.vertex_count()) < 0.01);
}

TEST_CASE("scaling and turning source and places goes along") {
    const TriangleMesh mesh = ball();
    const Eigen::Affine3d map = Eigen::Translation3d(3, 1, 2) * Eigen::AngleAxisd(2, Vector3d(1, -1, 1).normalized()) * Eigen::Scaling(4.0);
    const auto bent = [](const Vector3d& x) -> Vector3d { return x + 0.05 * Vector3d(std::sin(9 * x.y()), std::cos(7 * x.z()), std::sin(8 * x.x())); };
    const TriangleMesh other = shapes::moved(mesh, map);
    const NodeGraph graph(edge_graph(mesh), 0.1), other_graph(edge_graph(other), 0.4);
    REQUIRE(graph.nodes() == other_graph.nodes());
    std::vector<Pull> pulls = all_pulled(mesh.points, bent, 3), others = pulls;
    for (Pull& pull : others) pull.target = map * pull.target;
    AffineFit here(mesh.points, mesh.triangles, graph, mesh.points), there(other.points, other.triangles, other_graph, other.points);
    CHECK(apart(there.solve(others, 0.1), shapes::moved({here.solve(pulls, 0.1), mesh.triangles}, map).points) < 1e-8);
}

TEST_CASE("a piece that nothing pulls stays where it was, and without any pull all does") {
    const TriangleMesh mesh = shapes::with_extra_shell(ball());
    const NodeGraph graph(edge_graph(mesh), 0.1);
    const int n = ball().vertex_count();
    Points now = mesh.points;
    now.col(0).array() += 0.5;
    AffineFit fit(mesh.points, mesh.triangles, graph, now);
    std::vector<Pull> pulls = all_pulled(ball().points, [](const Vector3d& x) -> Vector3d { return x + Vector3d(0, 1, 0); });
    const Points moved = fit.solve(pulls, 1);
    CHECK(apart(moved.bottomRows(mesh.vertex_count() - n), now.bottomRows(mesh.vertex_count() - n)) < 1e-6);
    CHECK(apart(moved.topRows(n), mesh.points.topRows(n).rowwise() + Eigen::RowVector3d(0, 1, 0)) < 1e-5); // a millionth of what pulls it holds it
    AffineFit still(mesh.points, mesh.triangles, graph, now);
    CHECK(apart(still.solve({}, 1), now) < 1e-6);
}

TEST_CASE("flat sheets and single triangles are carried by finite maps") {
    for (const TriangleMesh& mesh : {shapes::sheet(), TriangleMesh{(Points(3, 3) << 0, 0, 0, 1, 0, 0, 0, 1, 0).finished(), (Triangles(1, 3) << 0, 1, 2).finished()}}) {
        const NodeGraph graph(edge_graph(mesh), 0.15);
        AffineFit fit(mesh.points, mesh.triangles, graph, mesh.points);
        CHECK(fit.solve(all_pulled(mesh.points, [](const Vector3d& x) -> Vector3d { return x + Vector3d(0, 0, x.x() * x.y()); }), 0.1).allFinite());
    }
}
