#include "lissom/curve/territory.h"

#include "shapes.h"

#include <doctest/doctest.h>

#include <algorithm>

using namespace lissom;

namespace {

/// A field whose inside are vertices with y in (low, high), rows along y.
CurveField band(const TriangleMesh& mesh, double low, double high) {
    CurveField field;
    for (int v = 0; v < mesh.vertex_count(); ++v) {
        const double y = mesh.points(v, 1), share = std::clamp((y - low) / (high - low), 0.0, 1.0);
        field.side.push_back(y > low && y < high ? CurveSide::inside : CurveSide::none);
        field.row.push_back(static_cast<float>(255 * share));
        field.distance.push_back(0.5f);
    }
    return field;
}

int count(const CurveField& field, CurveSide side) { return static_cast<int>(std::count(field.side.begin(), field.side.end(), side)); }

} // namespace

TEST_CASE("the rest of a bar is its two ends, and a piece apart is neither") {
    const TriangleMesh bar = shapes::box(4, 40, 4, {1, 10, 1});
    const TriangleMesh mesh = shapes::joined({bar, shapes::moved(shapes::icosphere(1), Eigen::Affine3d(Eigen::Translation3d(5, 30, 0)))});
    CurveField field = band(mesh, 3.1, 7.1);
    sort_remainder(vertex_rings(mesh), field);
    for (int v = 0; v < mesh.vertex_count(); ++v) {
        const double y = mesh.points(v, 1);
        const CurveSide wanted = v >= bar.vertex_count() ? CurveSide::none : y <= 3.1 ? CurveSide::start : y >= 7.1 ? CurveSide::end : CurveSide::inside;
        CHECK(field.side[v] == wanted);
    }
    for (const double share : between_shares(mesh, field)) CHECK(share == 0);
}

TEST_CASE("the rest of a ring lies between both ends, and its shares run from one to the other") {
    TriangleMesh mesh = shapes::torus(48, 16);
    if (mesh.points.col(1).cwiseAbs().maxCoeff() < 0.5) mesh.points.col(1).swap(mesh.points.col(2));
    // One half of the ring, its rows along x.
    CurveField field;
    for (int v = 0; v < mesh.vertex_count(); ++v) {
        field.side.push_back(mesh.points(v, 1) > 0 ? CurveSide::inside : CurveSide::none);
        field.row.push_back(static_cast<float>(std::clamp((mesh.points(v, 0) + 1.4) / 2.8 * 255, 0.0, 255.0)));
        field.distance.push_back(0);
    }
    sort_remainder(vertex_rings(mesh), field);
    CHECK(count(field, CurveSide::between) > 100);
    CHECK(count(field, CurveSide::start) == 0);
    const std::vector<double> shares = between_shares(mesh, field);
    for (int v = 0; v < mesh.vertex_count(); ++v) {
        CHECK(shares[v] >= 0);
        CHECK(shares[v] <= 1);
        if (field.side[v] != CurveSide::between) CHECK(shares[v] == 0);
        else if (mesh.points(v, 1) > -0.2 && mesh.points(v, 0) < 0) CHECK(shares[v] < 0.3);
        else if (mesh.points(v, 1) > -0.2) CHECK(shares[v] > 0.7);
    }
}

TEST_CASE("rows are evened where they jump, and nowhere else") {
    const TriangleMesh mesh = shapes::box(8, 80, 8, {1, 10, 1});
    const VertexRings rings = vertex_rings(mesh);
    const CurveField straight = band(mesh, 0.1, 9.9);
    CurveField field = straight;
    smooth_rows(mesh, rings, field, 9.8 / 255, 0.5);
    CHECK(field.row == straight.row);
    for (int v = 0; v < mesh.vertex_count(); ++v)
        if (mesh.points(v, 0) > 0.2 && std::abs(mesh.points(v, 1) - 5) < 0.4) field.row[v] += 60; // a jump
    const CurveField jumping = field;
    smooth_rows(mesh, rings, field, 9.8 / 255, 0.5);
    double before = 0, after = 0;
    for (int v = 0; v < mesh.vertex_count(); ++v) {
        for (const int u : rings[v]) {
            before = std::max(before, static_cast<double>(std::abs(jumping.row[u] - jumping.row[v])));
            after = std::max(after, static_cast<double>(std::abs(field.row[u] - field.row[v])));
        }
        if (std::abs(mesh.points(v, 1) - 5) > 3) CHECK(field.row[v] == straight.row[v]);
    }
    CHECK(after < 0.6 * before);
}
