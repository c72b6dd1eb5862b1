#include "lissom/match/sharp_paths.h"

#include "lissom/match/sharp_curves.h"
#include "lissom/mesh/operators.h"
#include "sharp_truth.h"
#include "shapes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>

using namespace lissom;

namespace {

std::vector<SharpLine> lines_of(const TriangleMesh& mesh) { return sharp_lines(mesh.points, sharp_curves(mesh)); }

/// A circle on the sheet (which is 1 wide), of many more points than the sheet has edges there.
SharpLine circle(const TriangleMesh& sheet, double radius, int n = 200) {
    const Eigen::RowVector3d middle = sheet.points.colwise().mean();
    SharpLine line{Points(n, 3), true};
    for (int i = 0; i < n; ++i) line.points.row(i) = middle + radius * Eigen::RowVector3d(std::cos(6.283185307179586 * i / n), std::sin(6.283185307179586 * i / n), 0);
    return line;
}

} // namespace

TEST_CASE("on a copy of the model the paths are the model's own edges, and nothing needs to move") {
    const TriangleMesh box = shapes::box(4, 5, 6, {1, 2, 3});
    const auto curves = sharp_curves(box);
    const SharpPaths found = find_sharp_paths(box, sharp_lines(box.points, curves), {}, {mean_edge_length(box)});
    CHECK(found.failed.empty());
    REQUIRE(found.paths.size() == curves.size());
    for (std::size_t k = 0; k < curves.size(); ++k) {
        CHECK(found.paths[k].line == static_cast<int>(k));
        CHECK(found.paths[k].curve.vertices == curves[k].vertices);
        for (std::size_t i = 0; i < curves[k].vertices.size(); ++i) CHECK((found.paths[k].places.row(static_cast<Eigen::Index>(i)) - box.points.row(curves[k].vertices[i])).norm() < 1e-12);
    }
    CHECK(sharp_truth::are_single(box, found.paths));
}

TEST_CASE("a coarser skin beside the model's edges: all found, none twice, ends at corners, places on the lines in order") {
    const TriangleMesh model = shapes::box(24, 24, 24, {1, 1, 1});
    TriangleMesh skin = shapes::box(9, 10, 11, {1, 1, 1});
    for (int v = 0; v < skin.vertex_count(); ++v) skin.points.row(v) += 0.02 * Eigen::RowVector3d(std::sin(7.0 * v), std::sin(5.0 * v), std::cos(3.0 * v));
    const auto lines = lines_of(model);
    const SharpPaths found = find_sharp_paths(skin, lines, {}, {mean_edge_length(skin)});
    CHECK(found.failed.empty());
    CHECK(found.paths.size() == 12);
    CHECK(sharp_truth::are_single(skin, found.paths));
    std::set<int> ends;
    for (const SharpPath& path : found.paths) {
        const auto& line = lines[static_cast<std::size_t>(path.line)].points;
        CHECK(path.places.row(0) == line.row(0));
        CHECK(path.places.row(path.places.rows() - 1) == line.row(line.rows() - 1));
        ends.insert({path.curve.vertices.front(), path.curve.vertices.back()});
        const Eigen::RowVector3d along = (line.row(line.rows() - 1) - line.row(0)).normalized();
        double last = -1;
        for (Eigen::Index i = 0; i < path.places.rows(); ++i) {
            const Eigen::RowVector3d to = path.places.row(i) - line.row(0);
            CHECK(to.dot(along) > last);
            CHECK((to - to.dot(along) * along).norm() < 1e-12);
            last = to.dot(along);
        }
    }
    CHECK(ends.size() == 8);
}

TEST_CASE("a closed line is found in pieces that meet") {
    const TriangleMesh sheet = shapes::bumpy_sheet(30, 30);
    SharpLine line = circle(sheet, 0.3);
    for (Eigen::Index i = 0; i < line.points.rows(); ++i) line.points(i, 2) = 0;
    TriangleMesh flat = sheet;
    flat.points.col(2).setZero();
    const SharpPaths found = find_sharp_paths(flat, {line}, {}, {mean_edge_length(flat)});
    CHECK(found.failed.empty());
    REQUIRE(found.paths.size() == 4);
    for (std::size_t k = 0; k < 4; ++k) {
        CHECK(found.paths[k].curve.vertices.back() == found.paths[(k + 1) % 4].curve.vertices.front());
        CHECK((found.paths[k].places.row(found.paths[k].places.rows() - 1) - found.paths[(k + 1) % 4].places.row(0)).norm() < 1e-12);
    }
    CHECK(sharp_truth::are_single(flat, found.paths));
    // No edge joins two vertices of the ring but its own: no triangle lies on the line.
    std::set<int> ring;
    for (const SharpPath& path : found.paths) ring.insert(path.curve.vertices.begin(), path.curve.vertices.end());
    for (int t = 0; t < flat.triangle_count(); ++t) {
        int on = 0;
        for (const int v : flat.triangles.row(t)) on += static_cast<int>(ring.count(v));
        CHECK(on < 3);
    }
}

TEST_CASE("a path goes around a marker that is not meant, and through one that is near, which moves onto the line") {
    TriangleMesh sheet = shapes::sheet(20, 20); // rows of 21, width 1
    const double left = sheet.points.col(0).minCoeff(), bottom = sheet.points.col(1).minCoeff(), L = 0.05;
    SharpLine line{Points(2, 3)};
    line.points << left, bottom + 0.5, 0, left + 1, bottom + 0.5, 0;
    const auto vertex = [](int x, int y) { return 21 * y + x; };
    const Anchor off{vertex(5, 10), sheet.points.row(vertex(5, 10)).transpose() + Eigen::Vector3d(0, 0.8 * L, 0)};
    const Anchor near{vertex(12, 10), sheet.points.row(vertex(12, 10)).transpose() + Eigen::Vector3d(0.01, 0.3 * L, 0)};
    sheet.points.row(off.vertex) = off.place.transpose();
    sheet.points.row(near.vertex) = near.place.transpose();
    const SharpPaths found = find_sharp_paths(sheet, {line}, {off, near}, {L});
    CHECK(found.failed.empty());
    REQUIRE(found.moved_markers.size() == 1);
    CHECK(found.moved_markers[0].vertex == near.vertex);
    CHECK((found.moved_markers[0].place - (near.place - Eigen::Vector3d(0, 0.3 * L, 0))).norm() < 1e-12);
    REQUIRE(found.paths.size() == 2);
    CHECK(found.paths[0].curve.vertices.back() == near.vertex);
    CHECK(found.paths[1].curve.vertices.front() == near.vertex);
    for (const SharpPath& path : found.paths)
        for (const int v : path.curve.vertices) CHECK(v != off.vertex);
    const auto anchors = anchors_of(found.paths);
    const auto at = std::find_if(anchors.begin(), anchors.end(), [&](const Anchor& a) { return a.vertex == near.vertex; });
    REQUIRE(at != anchors.end());
    CHECK((at->place - found.moved_markers[0].place).norm() < 1e-12);
}

TEST_CASE("what has no way is told: no free vertex near an end, or locked all around") {
    const TriangleMesh sheet = shapes::sheet(10, 10);
    const double left = sheet.points.col(0).minCoeff(), bottom = sheet.points.col(1).minCoeff();
    std::vector<SharpLine> lines(2, {Points(2, 3)});
    lines[0].points << left + 0.2, bottom + 0.5, 0, left + 0.8, bottom + 0.5, 0;
    lines[1].points << left + 0.2, bottom + 0.7, 5, left + 0.8, bottom + 0.7, 5; // not on the sheet at all
    CHECK(find_sharp_paths(sheet, lines, {}, {0.1}).failed == std::vector<int>{1});
    std::vector<Anchor> wall;
    for (int y = 0; y <= 10; ++y) wall.push_back({11 * y + 5, sheet.points.row(11 * y + 5).transpose()});
    lines[0].points.col(1).array() += 0.02; // beside the markers
    CHECK(find_sharp_paths(sheet, lines, wall, {0.1, 4, 50, 0}).failed == std::vector<int>{0, 1});
    CHECK(find_sharp_paths(sheet, {}, {}, {0.1}).paths.empty());
}

TEST_CASE("two models' paths lock one mesh: each is a layer, and they may cross") {
    const TriangleMesh sheet = shapes::sheet(10, 10);
    const double left = sheet.points.col(0).minCoeff(), bottom = sheet.points.col(1).minCoeff();
    std::vector<SharpPaths> all;
    for (const bool up : {false, true}) {
        SharpLine line{Points(2, 3)};
        if (up) line.points << left + 0.5, bottom, 0, left + 0.5, bottom + 1, 0;
        else line.points << left, bottom + 0.5, 0, left + 1, bottom + 0.5, 0;
        all.push_back(find_sharp_paths(sheet, {line}, {}, {.edge_length = 0.1, .layer = up}));
    }
    const EdgeCurves locks = SharpPaths::locks(sheet.vertex_count(), all, {0});
    CHECK(locks.through(60) == std::vector<int>{0, 1});
    CHECK_FALSE(locks.may_swap(60, 61));
    CHECK_FALSE(locks.may_swap(60, 71));
    CHECK(locks.may_swap(61, 72));
    CHECK_FALSE(locks.may_collapse(61, 71).allowed);
    CHECK(locks.may_collapse(61, 72).kept == 61);
    CHECK(locks.is_corner(0));
    CHECK_FALSE(locks.is_corner(60));
}

TEST_CASE("a turned, moved and scaled skin has the same paths") {
    const Eigen::Affine3d map = Eigen::Translation3d(100, 20, 0) * Eigen::AngleAxisd(1, Eigen::Vector3d(1, 2, 3).normalized()) * Eigen::Scaling(1e3);
    const TriangleMesh model = shapes::box(24, 24, 24), skin = shapes::box(9, 10, 11), there = shapes::moved(skin, map);
    const double L = mean_edge_length(skin);
    const SharpPaths a = find_sharp_paths(skin, lines_of(model), {}, {L}), b = find_sharp_paths(there, lines_of(shapes::moved(model, map)), {}, {1e3 * L});
    REQUIRE(a.paths.size() == b.paths.size());
    for (std::size_t k = 0; k < a.paths.size(); ++k) {
        CHECK(a.paths[k].curve.vertices == b.paths[k].curve.vertices);
        CHECK((shapes::moved({a.paths[k].places, Triangles(0, 3)}, map).points - b.paths[k].places).norm() < 1e-8 * 1e3);
    }
}
