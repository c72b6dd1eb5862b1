#include "lissom/hair/style.h"

#include "lissom/hair/dual_field.h"
#include "shapes.h"

#include <doctest/doctest.h>

using namespace lissom;
using Eigen::Vector3d;

namespace {

struct Ball {
    Grid grid{{-2, -2, -2}, 4.0 / 32, {33, 33, 33}};
    HeadDistance head{shapes::uv_sphere(48, 96), {{-2, -2, -2}, 4.0 / 64, {65, 65, 65}}};
};

Polyline line(const Vector3d& a, const Vector3d& b, int n = 20) {
    Polyline out;
    for (int i = 0; i <= n; ++i) out.push_back(a + (b - a) * i / n);
    return out;
}

} // namespace

TEST_CASE("a stream asks for its own direction, and a fading one dies away beyond its end") {
    const Ball ball;
    HairStyle style;
    style.streams.push_back({line({0, 1.2, 0}, {1, 1.2, 0}), false});
    const auto plain = style_constraints(style, ball.head, ball.grid);
    CHECK(plain.size() > 20);
    for (const auto& c : plain) CHECK((c.vector - Vector3d(1, 0, 0)).norm() < 1e-12);
    style.streams[0].fade = true;
    const auto fading = style_constraints(style, ball.head, ball.grid);
    CHECK(fading.size() > plain.size());
    for (const auto& c : fading)
        if (ball.grid.position(c.node).x() > 1.5) CHECK(c.vector.norm() < 0.3);
}

TEST_CASE("streams that contradict each other at one place ask for nothing there, and for each node once") {
    const Ball ball;
    HairStyle style;
    style.streams.push_back({line({0, 1.2, 0}, {1, 1.2, 0}), false});
    const auto one = style_constraints(style, ball.head, ball.grid);
    style.streams.push_back({line({1, 1.2, 0}, {0, 1.2, 0}), false});
    const auto both = style_constraints(style, ball.head, ball.grid);
    REQUIRE(both.size() == one.size());
    for (std::size_t i = 0; i < both.size(); ++i) {
        CHECK(both[i].node == one[i].node);
        CHECK(both[i].vector.norm() < 1e-9);
    }
}

TEST_CASE("on the two sides of a parting hair goes two ways, and the field keeps them apart") {
    const Ball ball;
    HairStyle style;
    DividingCurve parting;
    for (double a = -0.6; a <= 0.6; a += 0.05) parting.points.push_back({0.04, std::cos(a), std::sin(a)});
    style.partings.push_back(parting);
    const auto constraints = style_constraints(style, ball.head, ball.grid);
    CHECK(constraints.size() > 60);
    for (const auto& c : constraints) {
        const double x = ball.grid.position(c.node).x() - 0.04;
        if (std::abs(x) > 0.02) CHECK(c.vector.x() * x > 0);
    }
    DualField field(std::make_shared<GridBilaplacian>(ball.grid.size));
    field.set_constraints(constraints);
    const Points t = field.field();
    for (const double x : {-0.3, 0.38}) {
        const Cell cell = cell_of(ball.grid, {x, 1.02, 0});
        double sum = 0;
        for (int k = 0; k < 8; ++k) sum += cell.weights[k] * t(cell.nodes[k], 0);
        CHECK(sum * x > 0);
    }
}

TEST_CASE("tilt turns the hair of a parting about the skin's normal") {
    const Ball ball;
    DividingCurve parting{line({0, 1, -0.3}, {0, 1, 0.3}), {0, 0}, 1, 0.5};
    const auto straight = parting_frames(parting, ball.head, ball.grid.step);
    parting.tilt[0] = parting.tilt[1] = 30;
    const auto tilted = parting_frames(parting, ball.head, ball.grid.step);
    REQUIRE(straight.size() == tilted.size());
    for (std::size_t i = 0; i < straight.size(); ++i) {
        CHECK(straight[i].x.dot(tilted[i].x) == doctest::Approx(std::cos(30 * 3.14159265358979 / 180)).epsilon(1e-6));
        CHECK(straight[i].y.dot(tilted[i].y) == doctest::Approx(1));
    }
}

TEST_CASE("a ponytail pulls towards its knot, then runs along its spine") {
    const Ball ball;
    Ponytail tail;
    tail.spine = line({0, 0, -1}, {0, 0, -1.9});
    for (double a = 0; a < 6.2; a += 0.2) tail.section.push_back({0.2 * std::cos(a), 0.2 * std::sin(a), -1.1});
    const auto sections = tail_sections(tail, ball.grid.step);
    REQUIRE(sections.size() >= 2);
    CHECK(sections.front().radius == doctest::Approx(0.2).epsilon(0.01));
    HairStyle style;
    style.ponytails.push_back(tail);
    int pulling = 0, running = 0;
    for (const auto& c : style_constraints(style, ball.head, ball.grid)) {
        const Vector3d p = ball.grid.position(c.node);
        const double r = std::hypot(p.x(), p.y());
        if (r > 0.27 && c.vector.norm() > 0.1) {
            ++pulling;
            CHECK((c.vector.x() * p.x() + c.vector.y() * p.y()) < 0);
            CHECK(c.vector.norm() <= doctest::Approx(0.6));
        } else if (r < 0.18) {
            ++running;
            CHECK(c.vector.z() <= 0);
        }
    }
    CHECK(pulling > 5);
    CHECK(running > 5);
}

TEST_CASE("strokes without length or beside the grid ask for nothing") {
    const Ball ball;
    HairStyle style;
    style.streams.push_back({{{0, 1, 0}}, true});
    style.streams.push_back({line({9, 9, 9}, {10, 10, 10}), false});
    style.partings.push_back({{{0, 1, 0}}, {0, 0}, 1, 0.5});
    style.ponytails.push_back({{{0, 1, 0}}, {}, {}, 0.6});
    CHECK(style_constraints(style, ball.head, ball.grid).empty());
}
