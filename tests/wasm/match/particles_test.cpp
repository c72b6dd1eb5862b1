#include "lissom/match/particles.h"

#include "lissom/match/distances.h"
#include "shapes.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace lissom;
using Eigen::RowVector3d;

TEST_CASE("a particle goes where Eq 1 and 2 say") {
    const TriangleMesh ball = shapes::icosphere(5);
    TriangleMesh skin = shapes::icosphere(0);
    skin.points *= 2;
    const FitSurface surface(ball);
    std::vector<char> held(12, 0);
    held[3] = 1;
    const ParticleWeights weights{0.3, 0.2, 0.5};
    const Points moved = repositioned(skin, surface, held, weights);
    CHECK(moved.row(3) == skin.points.row(3));
    // Of a regular icosahedron's vertex the neighbours' centre is 1/√5 of it, and the ball's nearest place half of it.
    for (int v = 0; v < 12; ++v)
        if (v != 3) CHECK((moved.row(v) - (0.3 + 0.2 / std::sqrt(5.0) + 0.5 * 0.75) * skin.points.row(v)).norm() < 1e-3);
}

TEST_CASE("smoothing decays and the three weights are shares") {
    CHECK(ParticleWeights::at(0).smooth == doctest::Approx(0.5));
    CHECK(ParticleWeights::at(20).smooth == doctest::Approx(0.5 / M_E));
    CHECK(ParticleWeights::at(1000).smooth == 0.02);
    CHECK(ParticleWeights::at(0).stay == 0.3);
}

TEST_CASE("passes bring a box onto a ball that it stands around, and leave out what is ignored") {
    const TriangleMesh ball = shapes::icosphere(4);
    TriangleMesh skin = shapes::box(12, 12, 12, {2.4, 2.4, 2.4});
    skin.points.col(1).array() -= 1.2;
    FitSurface surface(ball);
    const std::vector<char> held(static_cast<std::size_t>(skin.vertex_count()), 0);
    for (int pass = 0; pass < 60; ++pass) skin.points = repositioned(skin, surface, held, ParticleWeights::at(pass));
    const SurfaceDistances apart = surface_distances(skin, ball);
    CHECK(apart.mean_there < 0.01);
    CHECK(apart.mean_back < 0.01);
    surface.ignore(std::vector<char>(static_cast<std::size_t>(ball.vertex_count()), 1));
    const Points alone = repositioned(skin, surface, held, {0.3, 0, 1});
    CHECK((alone - skin.points).norm() < 1e-12);
}
