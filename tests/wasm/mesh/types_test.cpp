#include "lissom/mesh/types.h"

#include <doctest/doctest.h>

using namespace lissom;

TEST_CASE("points and triangles lie row by row in memory, as files and the page hold them") {
    Points points(2, 3);
    points << 1, 2, 3, 4, 5, 6;
    Triangles triangles(2, 3);
    triangles << 0, 1, 2, 3, 4, 5;
    for (int k = 0; k < 6; ++k) {
        CHECK(points.data()[k] == k + 1);
        CHECK(triangles.data()[k] == k);
    }
}

TEST_CASE("counts are those of what is stored, and nothing has none") {
    CHECK(TriangleMesh{}.vertex_count() == 0);
    CHECK(TriangleMesh{}.triangle_count() == 0);
    CHECK(PolygonMesh{}.face_count() == 0);
    const PolygonMesh mesh{Points::Zero(5, 3), {0, 3, 3, 7}, {0, 1, 2, 0, 2, 3, 4}};
    CHECK(mesh.vertex_count() == 5);
    CHECK(mesh.face_count() == 3); // one of them without corners
    CHECK(PolygonMesh{Points(0, 3), {0}, {}}.face_count() == 0);
}
