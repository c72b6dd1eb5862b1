#include "lissom/wear/synthesis.h"

#include "shapes.h"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

using Eigen::Vector3d;
using Eigen::VectorXd;
using lissom::Measure;
using lissom::Points;
using Kind = lissom::Measure::Kind;

namespace {

/// Tall and thin, short and thick, and with a waist.
struct People {
    lissom::TriangleMesh first = shapes::icosphere(4);
    std::vector<Points> bodies;
    lissom::Measurer measurer{first.triangles, first.vertex_count()};

    People() {
        for (const Vector3d& by : {Vector3d(1, 2, 1), Vector3d(1.6, 1.5, 1.4), Vector3d(1.3, 1.8, 0.8)}) {
            Points body = first.points * by.asDiagonal();
            for (Eigen::Index v = 0; v < body.rows() && bodies.size() == 2; ++v) {
                const double thin = 1 - 0.25 * std::exp(-std::pow(first.points(v, 1) / 0.4, 2));
                body(v, 0) *= thin, body(v, 2) *= thin;
            }
            bodies.push_back(body);
        }
    }
    [[nodiscard]] Measure girth(const Eigen::RowVector3d& at, bool hull) const {
        Eigen::Index v = 0;
        (first.points.rowwise() - at).rowwise().norm().minCoeff(&v);
        return {.kind = Kind::section, .vertex = static_cast<int>(v), .vertices = {}, .hull = hull, .wanted = {}};
    }
    /// The first `count` measures of the body that these weights make.
    [[nodiscard]] std::vector<Measure> of(const VectorXd& weights, std::size_t count) const {
        std::vector<Measure> asked{Measure{}, girth({1, 0, 0}, true), girth({0.8, 0.6, 0}, false)};
        asked.resize(count);
        const Points body = lissom::blended(bodies, weights);
        for (Measure& one : asked) one.wanted = measurer.measure(body, one, 0).value;
        return asked;
    }
};

Measure tall(double wanted) { return {.vertices = {}, .wanted = wanted}; }

} // namespace

TEST_CASE("the measures of a body that is a sum give its weights back") {
    const People people;
    for (const Vector3d& truth : {Vector3d(0.2, 0.5, 0.3), Vector3d(0.9, -0.2, 0.3), Vector3d(0, 0, 1)}) {
        const auto found = lissom::synthesised(people.measurer, people.bodies, people.of(truth, 3), Vector3d::Constant(1.0 / 3));
        CHECK((found.weights - truth).cwiseAbs().maxCoeff() < 1e-3);
        CHECK(found.weights.sum() == doctest::Approx(1));
        CHECK(found.iterations < 30);
    }
}

TEST_CASE("what measures leave open stays as near as may be to what was given") {
    const People people;
    const Vector3d given(0.1, 0.8, 0.1);
    const auto asked = people.of(Vector3d(0.5, 0.3, 0.2), 1);
    const auto found = lissom::synthesised(people.measurer, people.bodies, asked, given);
    CHECK(found.reached[0] == doctest::Approx(*asked[0].wanted).epsilon(1e-4));
    // Heights are linear in the weights: the nearest weights of the right height, by hand.
    Vector3d heights;
    for (int k = 0; k < 3; ++k) heights[k] = people.measurer.measure(people.bodies[static_cast<std::size_t>(k)], asked[0], 0).value;
    const Vector3d way = heights.array() - heights.mean();
    CHECK((found.weights - given - (*asked[0].wanted - heights.dot(given)) / way.squaredNorm() * way).norm() < 1e-3);
    // Nothing asked: as given, brought to a whole.
    CHECK((lissom::synthesised(people.measurer, people.bodies, {}, 2 * given).weights - given).norm() < 1e-12);
    CHECK((lissom::synthesised(people.measurer, people.bodies, {}, Vector3d::Zero()).weights - Vector3d::Constant(1.0 / 3)).norm() < 1e-12);
}

TEST_CASE("contradicting measures come out by least squares, unreachable ones come to an end") {
    const People people;
    const std::vector<Measure> twice{tall(3.0), tall(3.2)}, giant{tall(50)};
    const auto between = lissom::synthesised(people.measurer, people.bodies, twice, Vector3d::Constant(1.0 / 3));
    CHECK(between.reached[0] > 3.0);
    CHECK(between.reached[0] < 3.2);
    const std::vector<Points> same{people.bodies[0], people.bodies[0]};
    CHECK((lissom::synthesised(people.measurer, same, giant, Eigen::Vector2d(0.3, 0.7)).weights - Eigen::Vector2d(0.3, 0.7)).norm() < 1e-9);
}

TEST_CASE("another unit gives the same weights") {
    const People people;
    const auto asked = people.of(Vector3d(0.2, 0.5, 0.3), 3);
    const auto plain = lissom::synthesised(people.measurer, people.bodies, asked, Vector3d(1, 0, 0));
    for (const double size : {1e-5, 1e5}) {
        std::vector<Points> bodies = people.bodies;
        for (Points& body : bodies) body *= size;
        auto scaled = asked;
        for (Measure& one : scaled) *one.wanted *= size;
        CHECK((lissom::synthesised(people.measurer, bodies, scaled, Vector3d(1, 0, 0)).weights - plain.weights).norm() < 1e-6);
    }
}
