#include "lissom/match/denoise.h"

#include "lissom/mesh/chance.h"
#include "refusal.h"
#include "shapes.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace lissom;

namespace {

Points noisy(Points points, double amount) {
    for (Eigen::Index i = 0; i < points.rows(); ++i)
        for (int k = 0; k < 3; ++k) points(i, k) += amount * (2 * chance(7, static_cast<std::uint64_t>(i), static_cast<std::uint64_t>(k)) - 1);
    return points;
}

double off_ball(const Points& points) { return (points.rowwise().norm().array() - 1).abs().mean(); }

} // namespace

TEST_CASE("points of a plane stay to the last digits, those of a line and of one place wholly") {
    const Points sheet = shapes::sheet(12, 12).points;
    CHECK((denoised(sheet) - sheet).cwiseAbs().maxCoeff() < 1e-12);
    Points line = Points::Zero(30, 3);
    line.col(1).setLinSpaced(0, 1);
    CHECK(denoised(line) == line);
    CHECK(denoised(Points::Ones(30, 3)) == Points::Ones(30, 3));
    CHECK(denoised(Points::Zero(0, 3)).rows() == 0);
    CHECK(denoised(sheet.topRows(3)) == sheet.topRows(3));
    CHECK(refusal([&] { (void)denoised(sheet, 3); }) == "bad-option");
}

TEST_CASE("noise on a ball falls to less than half in one pass, a ball without hardly changes") {
    const Points ball = shapes::icosphere(5).points; // spacing 0.035
    CHECK(off_ball(denoised(ball)) < 0.0025);
    const Points rough = noisy(ball, 0.0175);
    const double before = off_ball(rough), after = off_ball(denoised(rough));
    MESSAGE("noise " << before << " -> " << after << " -> " << off_ball(denoised(denoised(rough))));
    CHECK(after < 0.5 * before);
}

TEST_CASE("turned, moved, scaled and renumbered points are denoised alike") {
    const Points rough = noisy(shapes::bumpy_sphere(3).points, 0.02);
    const Eigen::Affine3d map = Eigen::Translation3d(1e3, 0, 5) * Eigen::AngleAxisd(1, Eigen::Vector3d(1, 2, 3).normalized()) * Eigen::Scaling(1e3);
    const auto through = [&](const Points& points) { return shapes::moved({points, Triangles(0, 3)}, map).points; };
    CHECK((through(denoised(rough)) - denoised(through(rough))).cwiseAbs().maxCoeff() < 1e-7 * 1e3);
    const Points reversed = rough.colwise().reverse();
    CHECK((Points(denoised(reversed).colwise().reverse()) - denoised(rough)).cwiseAbs().maxCoeff() < 1e-12);
}
