#include "lissom/curve/stroke.h"

#include "limbs.h"
#include "refusal.h"
#include "shapes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

using namespace lissom;
using Eigen::Vector3d;

namespace {

/// A wave across the screen, 500 pixels wide.
std::vector<Vector3d> wave(double pixel) {
    std::vector<Vector3d> through;
    for (int k = 0; k <= 40; ++k) through.emplace_back(pixel * 500 * (k / 40.0 - 0.5), pixel * 60 * std::sin(k / 40.0 * 2 * std::numbers::pi), 0);
    return through;
}

double angle(const Eigen::RowVector2d& a, const Eigen::RowVector2d& b) { return std::acos(std::clamp(a.normalized().dot(b.normalized()), -1.0, 1.0)) * 180 / std::numbers::pi; }

} // namespace

TEST_CASE("samples stand six pixels apart, and each keeps the ray through it") {
    const limbs::View view = limbs::view_of(shapes::bar(), {0.2, -0.1, -1});
    const Stroke line = filtered(limbs::drawn(view, wave(view.pixel), 1.5, 3));
    for (int i = 1; i < line.size(); ++i) CHECK((line.pixels.row(i) - line.pixels.row(i - 1)).norm() == doctest::Approx(6).epsilon(0.05));
    for (int i = 0; i < line.size(); ++i) {
        const Eigen::Vector2d seen = view.to_screen(line.origins.row(i).transpose());
        CHECK((seen - line.pixels.row(i).transpose()).norm() < 1e-9);
    }
}

TEST_CASE("a trembling hand draws the same direction at the end") {
    const limbs::View view = limbs::view_of(shapes::bar(), {0, 0, -1});
    std::vector<double> errors;
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
        const Stroke rough = limbs::drawn(view, {{-view.pixel * 200, 0, 0}, {view.pixel * 200, 40 * view.pixel, 0}}, 1.5, seed);
        const Stroke line = filtered(rough);
        errors.push_back(angle(line.pixels.row(line.size() - 1) - line.pixels.row(line.size() - 6), Eigen::RowVector2d(400, 40)));
    }
    std::sort(errors.begin(), errors.end());
    std::printf("end direction of strokes with 1.5 px of noise: median %.1f, 90 %% %.1f, most %.1f degrees\n", errors[50], errors[90], errors[99]);
    CHECK(errors[50] < 4);
    CHECK(errors[90] < 10);
    CHECK(errors[99] < 35);
}

TEST_CASE("few control points follow a stroke within the error asked for") {
    const limbs::View view = limbs::view_of(shapes::bar(), {0, 0, -1});
    const Stroke straight = filtered(limbs::drawn(view, {{-view.pixel * 200, 0, 0}, {view.pixel * 200, 0, 0}}, 0, 1));
    CHECK(control_samples(straight).size() == 4);
    const Stroke bent = filtered(limbs::drawn(view, wave(view.pixel), 1.5, 1));
    const std::vector<double> coarse = control_samples(bent, 8), fine = control_samples(bent, 2);
    CHECK(coarse.size() < fine.size());
    CHECK(fine.size() < 14);
    CHECK(fine.front() == 0);
    CHECK(fine.back() == doctest::Approx(bent.size() - 1));
}

TEST_CASE("the same stroke on a screen twice as wide needs no fewer points; a click is none") {
    const limbs::View view = limbs::view_of(shapes::bar(), {0, 0, -1});
    const Stroke click = limbs::drawn(view, {{0, 0, 0}, {view.pixel * 5, 0, 0}}, 0, 1);
    CHECK(refusal([&] { (void)filtered(click); }) == "stroke-too-short");
    const Stroke longer = limbs::drawn(view, {{0, 0, 0}, {view.pixel * 50, 0, 0}}, 0, 1);
    CHECK(part_of(longer, 2, 5).size() == 4);
    CHECK(longer.length() == doctest::Approx(50));
}
