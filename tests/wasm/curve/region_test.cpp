#include "lissom/curve/region.h"

#include "refusal.h"
#include "shapes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

using namespace lissom;
using Eigen::Vector3d;

namespace {

SplineCurve line(const std::vector<Vector3d>& through) {
    Points controls(std::ssize(through), 3);
    for (std::size_t i = 0; i < through.size(); ++i) controls.row(static_cast<Eigen::Index>(i)) = through[i].transpose();
    return SplineCurve(controls);
}

/// An arc of the torus's circle (in the plane across its axis).
SplineCurve arc(const TriangleMesh& torus, double from, double to) {
    Eigen::Index thin = 0;
    (torus.points.colwise().maxCoeff() - torus.points.colwise().minCoeff()).minCoeff(&thin);
    const Vector3d u = Vector3d::Unit((thin + 1) % 3), v = Vector3d::Unit((thin + 2) % 3);
    std::vector<Vector3d> at;
    for (int k = 0; k <= 8; ++k) {
        const double angle = from + (to - from) * k / 8;
        at.push_back(std::cos(angle) * u + std::sin(angle) * v);
    }
    return line(at);
}

void check_apart(const CurveRegion& region, int count) {
    std::set<int> all;
    for (const auto* list : {&region.vertices, &region.startSide, &region.endSide, &region.between}) {
        CHECK(std::is_sorted(list->begin(), list->end()));
        for (const int v : *list) {
            CHECK(all.insert(v).second);
            CHECK(v >= 0);
            CHECK(v < count);
        }
    }
}

} // namespace

TEST_CASE("along the middle of a bar: what is between the end disks, and the two ends") {
    for (const double scale : {1e-6, 1.0, 1e6}) {
        TriangleMesh mesh = shapes::bar();
        mesh.points *= scale;
        const WorkingMesh working = shapes::working(mesh);
        const CurveRegion region = curve_region(working, line({Vector3d(0, 2.05, 0) * scale, Vector3d(0, 4, 0) * scale, Vector3d(0, 6.05, 0) * scale}));
        check_apart(region, mesh.vertex_count());
        CHECK(region.between.empty());
        CHECK(std::ssize(region.vertices) + std::ssize(region.startSide) + std::ssize(region.endSide) == mesh.vertex_count());
        for (const int v : region.startSide) CHECK(mesh.points(v, 1) < 2.05 * scale);
        for (const int v : region.endSide) CHECK(mesh.points(v, 1) > 6.05 * scale);
        for (const int v : region.vertices) CHECK(std::abs(mesh.points(v, 1) / scale - 4.05) <= 2.01);
    }
}

TEST_CASE("around part of a ring the rest touches both ends") {
    const TriangleMesh mesh = shapes::torus(64, 32);
    const WorkingMesh working = shapes::working(mesh);
    const CurveRegion region = curve_region(working, arc(mesh, 0.05, 2.05));
    check_apart(region, mesh.vertex_count());
    CHECK(region.startSide.empty());
    CHECK(region.endSide.empty());
    CHECK(std::ssize(region.vertices) + std::ssize(region.between) == mesh.vertex_count());
    CHECK(std::ssize(region.vertices) == doctest::Approx(mesh.vertex_count() * 2.0 / (2 * std::numbers::pi)).epsilon(0.1));
}

TEST_CASE("two infinite planes cut a bent limb in pieces, the local region does not") {
    const TriangleMesh mesh = shapes::torus(96, 24);
    const CurveSurface surface(std::make_shared<WorkingMesh>(shapes::working(mesh)));
    const SplineCurve most = arc(mesh, 0.1, 5.0); // the plane at one end crosses the limb again at its far side
    const auto share = [&](RegionMethod method) {
        return static_cast<double>(curve_region(surface, most, {}, {.method = method}).vertices.size()) / mesh.vertex_count();
    };
    CHECK(share(RegionMethod::local) == doctest::Approx(4.9 / (2 * std::numbers::pi)).epsilon(0.05));
    CHECK(share(RegionMethod::planes) < 0.6);
}

TEST_CASE("coincident vertices, soups and several pieces: nothing is left behind") {
    const TriangleMesh bar = shapes::bar();
    const SplineCurve curve = line({{0, 2.05, 0}, {0, 6.05, 0}});
    const auto whole = curve_region(shapes::working(bar), curve);
    const TriangleMesh torn = shapes::soup(bar);
    const auto of_soup = curve_region(shapes::working(torn), curve);
    for (const int v : of_soup.vertices) CHECK(std::abs(torn.points(v, 1) - 4.05) <= 2.01);
    CHECK(std::ssize(of_soup.vertices) + std::ssize(of_soup.startSide) + std::ssize(of_soup.endSide) == torn.vertex_count());
    // A ring around the middle, and one beyond the end, are pieces of their own.
    const Eigen::Affine3d small = Eigen::Translation3d(0, 4, 0.55) * Eigen::Scaling(0.05), beyond = Eigen::Translation3d(0, 8.4, 0) * Eigen::Scaling(0.2),
                          far = Eigen::Translation3d(5, 4, 0) * Eigen::Scaling(0.2);
    const TriangleMesh several = shapes::joined({bar, shapes::moved(shapes::icosphere(1), small), shapes::moved(shapes::icosphere(1), beyond), shapes::moved(shapes::icosphere(1), far)});
    const auto region = curve_region(shapes::working(several), curve, {0.56, 0.56});
    const int each = shapes::icosphere(1).vertex_count(), n = bar.vertex_count();
    CHECK(std::ssize(region.vertices) == std::ssize(whole.vertices) + each);
    CHECK(std::ssize(region.endSide) == std::ssize(whole.endSide) + each);
    const auto has_far = [&](const std::vector<int>& list) { return std::any_of(list.begin(), list.end(), [&](int v) { return v >= n + 2 * each; }); };
    CHECK_FALSE(has_far(region.vertices));
    CHECK_FALSE(has_far(region.startSide));
    CHECK_FALSE(has_far(region.endSide));
}

TEST_CASE("one-sided and branching surfaces are sorted without a vertex twice") {
    for (const TriangleMesh& mesh : {shapes::moebius(), shapes::klein_bottle(), shapes::three_sheets(), shapes::bow_tie(), shapes::with_fin(shapes::bar())}) {
        const Vector3d low = mesh.points.colwise().minCoeff(), high = mesh.points.colwise().maxCoeff();
        const CurveRegion region = curve_region(shapes::working(mesh), line({low + 0.3 * (high - low), low + 0.5 * (high - low), low + 0.7 * (high - low)}));
        check_apart(region, mesh.vertex_count());
    }
}

TEST_CASE("far from everything there is no region; nonsense is refused") {
    const TriangleMesh mesh = shapes::bar();
    const WorkingMesh working = shapes::working(mesh);
    const CurveRegion none = curve_region(working, line({{30, 0, 0}, {30, 5, 0}}), {0.1, 0.1});
    CHECK(none.vertices.empty());
    CHECK(none.startSide.empty());
    CHECK(refusal([&] { (void)curve_region(working, line({{0, 1, 0}, {0, 5, 0}}), {1}); }) == "curve-radius");
    CHECK(refusal([&] { (void)curve_region(working, line({{0, 1, 0}, {0, 5, 0}}), {1, -1}); }) == "curve-radius");
    CHECK(refusal([&] { (void)curve_region(working, line({{0, 1, 0}, {0, 5, 0}}), {}, 0); }) == "curve-reach");
}

TEST_CASE("the radius is that of the limb, at its tips as well") {
    const TriangleMesh mesh = shapes::bar();
    const CurveSurface surface(std::make_shared<WorkingMesh>(shapes::working(mesh)));
    for (const double r : curve_radius(surface, line({{0, -0.5, 0}, {0, 4, 0}, {0, 8, 0}}))) CHECK(r == doctest::Approx(1 / std::sqrt(std::numbers::pi)).epsilon(1e-6));
    for (const double r : curve_radius(surface, line({{0, 2, 0.5}, {0, 6, 0.5}}))) CHECK(r == doctest::Approx(0.7 * std::hypot(0.5, 1)).epsilon(1e-3));
}
