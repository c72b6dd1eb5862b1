#include "lissom/curve/surface.h"

#include "shapes.h"

#include <doctest/doctest.h>

using namespace lissom;

TEST_CASE("a soup hangs together on the surface, and its vertices come back all") {
    const TriangleMesh soup = shapes::soup(shapes::icosphere(2));
    const CurveSurface surface(std::make_shared<WorkingMesh>(shapes::working(soup)));
    CHECK(components(surface.rings()).count == 1);
    std::vector<int> all(static_cast<std::size_t>(surface.mesh().vertex_count()));
    for (int v = 0; v < surface.mesh().vertex_count(); ++v) all[v] = v;
    CHECK(std::ssize(surface.source_vertices(all)) == soup.vertex_count());
    const std::vector<int> corner = surface.source_vertices({0});
    CHECK(corner.size() >= 5);
    for (const int v : corner) CHECK((soup.points.row(v) - soup.points.row(corner[0])).norm() == 0);
    CHECK(surface.tree().nearest({0, 0, 0}).triangle >= 0);
}
