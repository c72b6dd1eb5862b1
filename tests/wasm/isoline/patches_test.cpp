#include "lissom/isoline/patches.h"

#include "sessions.h"

#include <doctest/doctest.h>

#include <set>

using namespace lissom;
using namespace sessions;

TEST_CASE("patches cover what handles reach, each with triangles of its own") {
    const Fielded f(shapes::bumpy_sphere(4), axis_caps(shapes::bumpy_sphere(4).points, 3));
    const Patches patches = cut_patches(f.mesh, f.fields, f.handle, 3, {.count = 60});
    CHECK(patches.count == 63);
    std::vector<int> sizes(63, 0);
    for (int v = 0; v < f.mesh.vertex_count(); ++v) {
        REQUIRE(patches.of_vertex[v] >= 0);
        if (f.handle[v] >= 0) CHECK(patches.of_vertex[v] == f.handle[v]);
        else CHECK(patches.of_vertex[v] >= 3);
        ++sizes[patches.of_vertex[v]];
    }
    for (int c = 3; c < patches.count; ++c) {
        CHECK(sizes[c] > 0);
        CHECK(!patches.triangles[c].empty());
        CHECK(patches.triangles[c].size() <= 4);
        std::set<int> different(patches.triangles[c].begin(), patches.triangles[c].end());
        CHECK(different.size() == patches.triangles[c].size());
    }
    for (int h = 0; h < 3; ++h) CHECK(patches.triangles[h].empty());
}

TEST_CASE("a piece that nothing holds is in no patch") {
    const TriangleMesh two = shapes::two_spheres(2);
    DeformHandle one;
    one.vertices = {0, 1, 2};
    const Fielded f(two, {one});
    const Patches patches = cut_patches(f.mesh, f.fields, f.handle, 1, {.count = 10});
    for (int v = 0; v < two.vertex_count(); ++v) CHECK((patches.of_vertex[v] >= 0) == (v < two.vertex_count() / 2));
}

TEST_CASE("fewer vertices than patches make as many patches as vertices") {
    const Fielded f(shapes::icosphere(1), axis_caps(shapes::icosphere(1).points, 2));
    const Patches patches = cut_patches(f.mesh, f.fields, f.handle, 2, {.count = 500});
    CHECK(patches.count <= 2 + f.mesh.vertex_count());
    for (const int p : patches.of_vertex) CHECK(p >= 0);
}

TEST_CASE("needles are not sampled") {
    const TriangleMesh spoilt = shapes::with_needles(shapes::bumpy_sphere(2), 12, 1e-6);
    const Fielded f(spoilt, axis_caps(spoilt.points, 2));
    const Patches patches = cut_patches(f.mesh, f.fields, f.handle, 2, {.count = 20});
    for (const auto& triangles : patches.triangles)
        for (const int t : triangles) {
            const Eigen::Vector3d a = f.mesh.points.row(f.mesh.triangles(t, 0)), b = f.mesh.points.row(f.mesh.triangles(t, 1)),
                                  c = f.mesh.points.row(f.mesh.triangles(t, 2));
            CHECK((b - a).cross(c - a).norm() > 1e-4 * (b - a).squaredNorm());
        }
}
