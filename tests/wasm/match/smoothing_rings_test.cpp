#include "lissom/match/smoothing_rings.h"

#include "shapes.h"

#include <doctest/doctest.h>

#include <algorithm>

using namespace lissom;

TEST_CASE("inside a surface it is the ring, on a border the neighbours along it") {
    const TriangleMesh ball = shapes::bumpy_sphere();
    CHECK(smoothing_rings(ball).neighbours == vertex_rings(ball).neighbours);
    const TriangleMesh sheet = shapes::sheet(5, 4);
    const VertexRings rings = smoothing_rings(sheet), all = vertex_rings(sheet);
    const std::vector<bool> border = boundary_vertices(sheet);
    for (int v = 0; v < sheet.vertex_count(); ++v) {
        CHECK(std::is_sorted(rings[v].begin(), rings[v].end()));
        if (!border[v]) CHECK(std::ranges::equal(rings[v], all[v]));
        else {
            CHECK(rings[v].size() == 2);
            for (const int w : rings[v]) CHECK(border[w]);
        }
    }
}

TEST_CASE("means are those of the neighbours; a vertex alone is its own") {
    const TriangleMesh mesh = shapes::with_unused_vertices(shapes::sheet(4, 4), 1);
    const VertexRings rings = smoothing_rings(mesh);
    for (int v = 0; v < mesh.vertex_count(); ++v) {
        Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
        for (const int w : rings[v]) sum += mesh.points.row(w);
        if (rings[v].empty()) sum = mesh.points.row(v);
        else sum /= static_cast<double>(rings[v].size());
        CHECK((ring_mean(mesh.points, rings, v) - sum).norm() < 1e-15);
    }
}
