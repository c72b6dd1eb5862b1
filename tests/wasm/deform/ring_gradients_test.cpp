#include "handles.h"

#include "lissom/deform/ring_gradients.h"

#include <doctest/doctest.h>

using namespace handles;

namespace {

lissom::RingGradients all_gradients(const TriangleMesh& mesh) {
    const std::vector<char> yes(static_cast<std::size_t>(mesh.vertex_count()), 1);
    return lissom::ring_gradients(mesh, lissom::vertex_rings(mesh), {yes, yes});
}

Eigen::Matrix3d gradient(const lissom::RingGradients& g, int i, const Points& deformed) {
    Eigen::Matrix3d M = Eigen::Matrix3d::Zero();
    for (int e = g.offsets[i]; e < g.offsets[i + 1]; ++e) M += deformed.row(g.vertices[e]).transpose() * g.coefficients.row(e);
    return M;
}

} // namespace

TEST_CASE("the gradient of an affine map is its linear part at every vertex, flat or not") {
    const Affine3d map = some_affine();
    std::vector<Named> all = models();
    all.push_back({"flat sheet", shapes::sheet(12, 9)}); // corners of valence 2, collinear boundary rings
    all.push_back({"single quad", shapes::sheet(1, 1)});
    for (const Named& model : all) {
        CAPTURE(model.name);
        const lissom::RingGradients g = all_gradients(model.mesh);
        const Points deformed = images(map, g.rest);
        for (int i = 0; i < model.mesh.vertex_count(); ++i) {
            REQUIRE(g.offsets[i] < g.offsets[i + 1]);
            CHECK((gradient(g, i, deformed) - map.linear()).norm() < 1e-7);
        }
        CHECK(g.borrowed == 0);
    }
}

TEST_CASE("only degenerate vertices are displaced, along the normal and by a fifth of their edges") {
    CHECK(all_gradients(shapes::bumpy_sphere(3)).displaced.empty());
    const TriangleMesh flat = shapes::sheet(12, 9);
    const lissom::RingGradients g = all_gradients(flat);
    CHECK(static_cast<int>(g.displaced.size()) > flat.vertex_count() / 8);
    CHECK(static_cast<int>(g.displaced.size()) < flat.vertex_count() / 2);
    for (const int v : g.displaced) {
        CHECK((g.rest.row(v) - flat.points.row(v)).head<2>().norm() < 1e-12);
        CHECK(std::abs(g.rest(v, 2)) < 0.2 * 0.2);
        CHECK(std::abs(g.rest(v, 2)) > 0.2 * 0.05);
    }
}

TEST_CASE("a triangle has no gradient of its own") {
    TriangleMesh one;
    one.points.resize(3, 3);
    one.points << 0, 0, 0, 1, 0, 0, 0, 1, 0;
    one.triangles.resize(1, 3);
    one.triangles << 0, 1, 2;
    const lissom::RingGradients g = all_gradients(one);
    CHECK(g.vertices.empty());
    CHECK(g.displaced.empty());
}
