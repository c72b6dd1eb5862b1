#include "lissom/wear/dress_session.h"

#include "refusal.h"
#include "shapes.h"

#include "lissom/mesh/triangle_tree.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

using Eigen::Affine3d;
using Eigen::AngleAxisd;
using Eigen::Scaling;
using Eigen::Vector3d;
using lissom::Dressed;
using lissom::DressSession;
using lissom::Points;
using lissom::TriangleMesh;

namespace {

/// A skirt around the lower half of a ball.
TriangleMesh skirt(int around = 60, int along = 30) {
    TriangleMesh mesh = shapes::cylinder(around, along, 1.4);
    for (Eigen::Index v = 0; v < mesh.points.rows(); ++v) {
        const double z = mesh.points(v, 2) - 1, r = z > 0 ? 1.03 * std::sqrt(1 - z * z / 1.06) : 1.03 + 0.1 * z * z;
        mesh.points.row(v) << r * mesh.points(v, 0), r * mesh.points(v, 1), z;
    }
    return mesh;
}

Points grown(const Points& points) {
    Points moved = points;
    for (Eigen::Index v = 0; v < moved.rows(); ++v) {
        moved(v, 0) *= 1.25;
        moved(v, 2) += 0.15 * std::sin(3 * moved(v, 0));
    }
    return moved;
}

Dressed dressed(const lissom::WorkingMesh& garment, const TriangleMesh& from, const Points& to, double ease = 0, const lissom::WorkingMesh* model = nullptr) {
    DressSession session(garment, from.triangles, from.points, to, model);
    while (session.step()) CHECK(session.fraction() <= 1);
    return session.dress(ease);
}

Points applied(const Affine3d& map, const Points& points) { return (points * map.linear().transpose()).rowwise() + map.translation().transpose(); }

double farthest(const Points& a, const Points& b) { return (a - b).rowwise().norm().maxCoeff(); }

} // namespace

TEST_CASE("for the body that it was made for a garment stays as it is") {
    const TriangleMesh ball = shapes::icosphere(4);
    const lissom::WorkingMesh garment = shapes::working(skirt());
    const Dressed same = dressed(garment, ball, ball.points);
    CHECK(farthest(same.positions, garment.source) < 1e-6);
    CHECK(same.before.none());
    CHECK(same.warnings.empty());
}

TEST_CASE("on another body nothing of it is inside, and more ease takes it farther out") {
    const TriangleMesh ball = shapes::icosphere(4);
    const TriangleMesh body{grown(ball.points), ball.triangles};
    const lissom::WorkingMesh garment = shapes::working(skirt()), model = shapes::working(body);
    const lissom::TriangleTree tree(body);
    const auto apart = [&](const Points& points) {
        double sum = 0;
        for (Eigen::Index v = 0; v < points.rows(); ++v) sum += tree.nearest(points.row(v)).distance;
        return sum / static_cast<double>(points.rows());
    };
    const Dressed plain = dressed(garment, ball, body.points, 0, &model);
    CHECK(plain.after.none());
    CHECK(plain.warnings.empty());
    for (const double ease : {0.05, 0.2}) {
        const Dressed worn = dressed(garment, ball, body.points, ease, &model);
        CHECK(worn.after.none());
        CHECK(apart(worn.positions) - apart(plain.positions) == doctest::Approx(ease).epsilon(0.15));
    }
    // Tighter than the body it is pushed out, and that is told.
    const Dressed tight = dressed(garment, ball, body.points, -0.1, &model);
    CHECK(tight.before.vertices > 100);
    CHECK(tight.after.none());
    CHECK(tight.rounds > 0);
}

TEST_CASE("moved, turned and in another unit a garment is dressed alike") {
    const TriangleMesh ball = shapes::icosphere(3);
    const Points to = grown(ball.points);
    const Dressed plain = dressed(shapes::working(skirt()), ball, to, 0.02);
    for (const double size : {1e-4, 1e5}) {
        const Affine3d a(Eigen::Translation3d(size, -7 * size, 0) * AngleAxisd(1.9, Vector3d(2, 1, 1).normalized()) * Scaling(size)),
            b(Eigen::Translation3d(5 * size, 0, 0) * AngleAxisd(-0.6, Vector3d::UnitX()) * Scaling(size));
        const Dressed moved = dressed(shapes::working(shapes::moved(skirt(), a)), shapes::moved(ball, a), applied(b, to), 0.02 * size);
        CHECK(farthest(moved.positions, applied(b, plain.positions)) < 1e-6 * size);
        CHECK(moved.before.vertices == plain.before.vertices);
    }
}

TEST_CASE("how the garment and the bodies are cut into triangles hardly matters") {
    const TriangleMesh coarse = shapes::icosphere(4), fine = shapes::icosphere(5);
    const TriangleMesh few = skirt(40, 20), many = skirt(80, 40);
    const Dressed a = dressed(shapes::working(few), coarse, grown(coarse.points)), b = dressed(shapes::working(many), fine, grown(fine.points));
    const TriangleMesh there{b.positions, many.triangles};
    const lissom::TriangleTree tree(there);
    double worst = 0;
    for (Eigen::Index v = 0; v < a.positions.rows(); ++v) worst = std::max(worst, tree.nearest(a.positions.row(v)).distance);
    CHECK(worst < 0.02);
}

TEST_CASE("a soup of a garment keeps together, stray vertices go along, those without a place stay") {
    const TriangleMesh ball = shapes::icosphere(3), cloth = skirt(), torn = shapes::soup(cloth);
    const Points to = grown(ball.points), whole = dressed(shapes::working(cloth), ball, to).positions, apart = dressed(shapes::working(torn), ball, to).positions;
    for (int t = 0; t < cloth.triangle_count(); t += 11)
        for (int k = 0; k < 3; ++k) CHECK((apart.row(torn.triangles(t, k)) - whole.row(cloth.triangles(t, k))).norm() < 1e-8);
    CHECK(dressed(shapes::working(shapes::with_unused_vertices(cloth, 2)), ball, to).positions.allFinite());
    CHECK(!dressed(shapes::working(shapes::with_nan_vertex(cloth, 5)), ball, to).positions.row(5).allFinite());
}

TEST_CASE("a model without an inside is told, and an ease that is no number refused") {
    const TriangleMesh ball = shapes::icosphere(3);
    const lissom::WorkingMesh garment = shapes::working(skirt()), sheets = shapes::working(shapes::three_sheets(6));
    const Dressed worn = dressed(garment, ball, grown(ball.points), 0, &sheets);
    REQUIRE(worn.warnings.size() == 1);
    CHECK(worn.warnings[0].code == "model-without-inside");
    CHECK(worn.after.none());
    CHECK(refusal([&] { dressed(garment, ball, ball.points, std::numeric_limits<double>::quiet_NaN()); }) == "bad-option");
}
