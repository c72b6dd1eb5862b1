#include "lissom/isoline/free_handles.h"

#include "sessions.h"

#include <doctest/doctest.h>

using namespace lissom;
using namespace sessions;

namespace {

/// A sheet whose border is one handle and whose middle another: nothing along an isoline can tilt.
std::vector<DeformHandle> frame_and_middle(const Points& points) {
    std::vector<DeformHandle> two(2);
    for (int v = 0; v < points.rows(); ++v) {
        const double x = points(v, 0) - points.col(0).mean(), y = points(v, 1) - points.col(1).mean();
        if (std::max(std::abs(x), std::abs(y)) > 0.44) two[0].vertices.push_back(v);
        else if (std::hypot(x, y) < 0.08) two[1].vertices.push_back(v);
    }
    return two;
}

} // namespace

TEST_CASE("isolines around the middle of a sheet are flat, those around a limb are not") {
    const TriangleMesh sheet = shapes::bumpy_sheet(40, 40);
    const Fielded flat(sheet, frame_and_middle(sheet.points));
    const Eigen::VectorXd on_sheet = isoline_flatness(flat.mesh, vertex_rings(flat.mesh), flat.fields);
    CHECK(on_sheet.maxCoeff() <= 1 + 1e-9);
    double sum = 0;
    int count = 0;
    for (int v = 0; v < flat.mesh.vertex_count(); ++v)
        if (flat.handle[v] < 0) {
            sum += on_sheet[v];
            ++count;
        }
    CHECK(sum / count > 0.8);
    const TriangleMesh bar = shapes::box(8, 60, 8, {1, 8, 1});
    const Fielded round(bar, handles::two_ends(bar.points));
    const Eigen::VectorXd on_bar = isoline_flatness(round.mesh, vertex_rings(round.mesh), round.fields);
    for (int v = 0; v < round.mesh.vertex_count(); ++v)
        if (round.fields(v, 0) > 0.05 && round.fields(v, 1) > 0.05) CHECK(on_bar[v] < 0.2);
}

TEST_CASE("free handles are placed on the sheet, apart from each other and from the handles, and none on a bar") {
    const TriangleMesh sheet = shapes::bumpy_sheet(60, 60);
    const Fielded flat(sheet, frame_and_middle(sheet.points));
    const auto placed = place_free_handles(flat.mesh, vertex_rings(flat.mesh), flat.fields, flat.handle);
    REQUIRE(placed.size() == 8);
    std::vector<int> owner = flat.handle;
    for (const auto& disc : placed)
        for (const int v : disc) {
            CHECK(owner[v] == -1);
            owner[v] = 5;
        }
    for (std::size_t a = 0; a < placed.size(); ++a)
        for (std::size_t b = 0; b < a; ++b)
            CHECK((flat.mesh.points.row(placed[a].front()) - flat.mesh.points.row(placed[b].front())).norm() > 0.05);

    const TriangleMesh bar = shapes::box(8, 60, 8, {1, 8, 1});
    const Fielded round(bar, handles::two_ends(bar.points));
    CHECK(place_free_handles(round.mesh, vertex_rings(round.mesh), round.fields, round.handle).empty());
    CHECK(place_free_handles(flat.mesh, vertex_rings(flat.mesh), flat.fields, flat.handle, {.most = 3}).size() == 3);
}

TEST_CASE("a disc stays within its radius and on allowed vertices") {
    const TriangleMesh sheet = shapes::sheet(20, 20);
    const int middle = 10 * 21 + 10;
    const auto disc = disc_around(sheet, vertex_rings(sheet), sheet.points.row(middle), {middle}, 0.2, [](int v) { return v % 5 != 0; });
    CHECK(disc.size() > 10);
    for (const int v : disc) {
        CHECK((v % 5 != 0 || v == middle));
        CHECK((sheet.points.row(v) - sheet.points.row(middle)).norm() <= 0.2);
    }
}
