#include "lissom/hair/scalp_roots.h"

#include "lissom/mesh/errors.h"
#include "shapes.h"

#include <doctest/doctest.h>

#include <numeric>

using namespace lissom;
using Eigen::Vector3d;

namespace {

std::vector<int> above(const TriangleMesh& mesh, double y) {
    std::vector<int> out;
    for (int v = 0; v < mesh.vertex_count(); ++v)
        if (mesh.points(v, 1) > y) out.push_back(v);
    return out;
}

} // namespace

TEST_CASE("roots lie on the scalp, look out of the skin and are spread by area") {
    const TriangleMesh ball = shapes::bumpy_sphere(4);
    std::vector<int> all(static_cast<std::size_t>(ball.vertex_count()));
    std::iota(all.begin(), all.end(), 0);
    const ScalpRoots roots(ball, all);
    const int n = 20000;
    Eigen::VectorXd share = Eigen::VectorXd::Zero(ball.triangle_count());
    for (int i = 0; i < n; ++i) {
        const Root root = roots.root(static_cast<std::uint64_t>(i), 1);
        share[root.triangle] += 1.0 / n;
        CHECK(root.b + root.c <= 1);
        CHECK(root.normal.dot(root.position) > 0);
    }
    // By octant: far from any triangle's own luck.
    for (int octant = 0; octant < 8; ++octant) {
        double wanted = 0, got = 0;
        for (int t = 0; t < ball.triangle_count(); ++t) {
            const Vector3d a = ball.points.row(ball.triangles(t, 0)), b = ball.points.row(ball.triangles(t, 1)),
                           c = ball.points.row(ball.triangles(t, 2));
            const Vector3d m = a + b + c;
            if ((m.x() > 0) + 2 * (m.y() > 0) + 4 * (m.z() > 0) != octant) continue;
            wanted += (b - a).cross(c - a).norm() / 2 / roots.area();
            got += share[t];
        }
        CHECK(got == doctest::Approx(wanted).epsilon(0.01));
    }
}

TEST_CASE("a prefix of the roots is evenly spread too: no two of them sit together") {
    const TriangleMesh ball = shapes::icosphere(4);
    const ScalpRoots roots(ball, above(ball, 0));
    const int n = 500;
    std::vector<Vector3d> points;
    for (int i = 0; i < n; ++i) points.push_back(roots.root(static_cast<std::uint64_t>(i), 9).position);
    const double even = std::sqrt(roots.area() / n);
    int close = 0;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < i; ++j) close += (points[static_cast<std::size_t>(i)] - points[static_cast<std::size_t>(j)]).norm() < 0.25 * even;
    CHECK(close < n / 25); // random places would make about n/10
}

TEST_CASE("another seed is another head of hair, the same seed the same") {
    const TriangleMesh ball = shapes::icosphere(3);
    const ScalpRoots roots(ball, above(ball, 0));
    CHECK(roots.root(5, 1).position == roots.root(5, 1).position);
    CHECK(roots.root(5, 1).position != roots.root(5, 2).position);
}

TEST_CASE("a scalp without a whole triangle is refused") {
    const TriangleMesh ball = shapes::icosphere(2);
    CHECK_THROWS_AS(ScalpRoots(ball, std::vector<int>{0, 1}), InvalidInput);
}
