#include "lissom/match/marker_alignment.h"

#include "../refusal.h"
#include "shapes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace lissom;
using Eigen::RowVector3d;
using Eigen::Vector3d;

namespace {

/// Places on a figure of limbs that no mirror carries onto itself.
Points markers() {
    Points all(14, 3);
    all << 0, 1, 0, 0.1, 0.8, 0.12, 0.5, 0.5, 0.05, -0.45, 0.55, 0.1, 0.3, 0.6, -0.08, -0.28, 0.66, -0.05, 0.15, -0.9, 0.1, -0.2, -1, -0.1, 0.17, -0.4, 0.15, -0.12, -0.45, 0.2, 0, 0.1, 0.22,
        0.05, 0.15, -0.2, -0.2, 0.05, 0, 0.21, 0.08, 0.04;
    return all;
}
/// Another figure's: larger, turned, moved, and not quite the same.
Points of_another() {
    Points other = shapes::moved({markers(), Triangles(0, 3)}, Eigen::Affine3d(Eigen::Translation3d(3, 1, -2) * Eigen::AngleAxisd(0.8, Vector3d(1, 2, -1).normalized()) * Eigen::Scaling(1.4))).points;
    for (Eigen::Index i = 0; i < other.rows(); ++i) other.row(i) += 0.01 * RowVector3d(std::sin(3.0 * i), std::cos(5.0 * i), std::sin(7.0 * i));
    return other;
}
Points mirrored(Points points) {
    points.col(0) *= -1;
    return points;
}

} // namespace

TEST_CASE("markers all around bend the start so that each is met; flat or few ones only move and turn it") {
    const MarkerAlignment round = align_markers(markers(), of_another());
    CHECK(round.flatness > k_flat_markers);
    REQUIRE(round.radial);
    CHECK((round(markers()) - of_another()).norm() < 1e-10);

    Points flat = markers();
    flat.col(2) *= 0.1;
    const MarkerAlignment of_flat = align_markers(flat, of_another());
    CHECK(of_flat.flatness < k_flat_markers);
    CHECK_FALSE(of_flat.radial);
    CHECK(align_markers(of_another(), flat).flatness == doctest::Approx(of_flat.flatness));
    CHECK_FALSE(align_markers(markers().topRows(4), of_another().topRows(4)).radial);
    CHECK_FALSE(align_markers(markers(), of_another(), MatchStart::similarity).radial);
    CHECK(align_markers(flat, of_another(), MatchStart::radial).radial);
}

TEST_CASE("without markers nothing moves, with one or two nothing turns, with three in a line all stays finite") {
    CHECK(align_markers(Points(0, 3), Points(0, 3))(Vector3d(1, 2, 3)) == Vector3d(1, 2, 3));
    for (const int n : {1, 2}) {
        const MarkerAlignment few = align_markers(markers().topRows(n), of_another().topRows(n));
        CHECK(few.similarity.rotation.isIdentity());
        CHECK(few.similarity.scale == 1);
    }
    Points line(3, 3);
    line << 0, 0, 0, 1, 1, 1, 2, 2, 2;
    CHECK(align_markers(line, of_another().topRows(3))(markers()).allFinite());
    CHECK(align_markers(Points::Zero(7, 3), of_another().topRows(7))(markers()).allFinite());
    CHECK(align_markers(of_another().topRows(7), Points::Zero(7, 3))(markers()).allFinite());
}

TEST_CASE("left and right changed on one side is seen, and is not seen where it is not so") {
    const MarkerAlignment right = align_markers(markers(), of_another()), wrong = align_markers(mirrored(markers()), of_another());
    CHECK_FALSE(right.mirrored);
    CHECK(wrong.mirrored);
    CHECK(wrong.mirrored_misfit == doctest::Approx(right.misfit));
    CHECK(wrong.similarity.rotation.determinant() == doctest::Approx(1)); // the start itself never mirrors
    Points flat = markers();
    flat.col(2).setZero(); // fits its mirror image as well
    CHECK_FALSE(align_markers(flat, flat).mirrored);
}

TEST_CASE("one pair of markers changed for each other is named, whichever it is") {
    CHECK_FALSE(align_markers(markers(), of_another()).swapped);
    for (const auto& [i, j] : {std::pair{0, 6}, {2, 3}, {6, 7}, {4, 10}}) {
        Points to = of_another();
        to.row(i).swap(to.row(j));
        const MarkerAlignment found = align_markers(markers(), to);
        CAPTURE(i);
        REQUIRE(found.swapped);
        CHECK(*found.swapped == std::pair(i, j));
    }
}

TEST_CASE("what is said of markers has no unit and does not depend on how either side is turned") {
    Points to = of_another();
    to.row(2).swap(to.row(3));
    const MarkerAlignment here = align_markers(markers(), to);
    const auto moved = [](const Points& points, double scale) {
        return shapes::moved({points, Triangles(0, 3)}, Eigen::Affine3d(Eigen::Translation3d(scale * Vector3d(1, 2, 3)) * Eigen::AngleAxisd(2, Vector3d(1, 0, 1).normalized()) * Eigen::Scaling(scale))).points;
    };
    for (const double scale : {1e-6, 1e6}) {
        const MarkerAlignment there = align_markers(moved(markers(), scale), moved(to, 3 * scale));
        CHECK(there.flatness == doctest::Approx(here.flatness).epsilon(1e-9));
        CHECK(there.misfit == doctest::Approx(here.misfit).epsilon(1e-9));
        CHECK(there.swapped == here.swapped);
        for (std::size_t i = 0; i < here.surprises.size(); ++i) CHECK(there.surprises[i] == doctest::Approx(here.surprises[i]).epsilon(1e-6));
    }
}

TEST_CASE("markers that are none are refused") {
    CHECK(refusal([] { (void)align_markers(markers(), of_another().topRows(3)); }) == "marker-count");
    Points none = markers();
    none(4, 1) = INFINITY;
    CHECK(refusal([&] { (void)align_markers(none, of_another()); }) == "non-finite-marker");
}
