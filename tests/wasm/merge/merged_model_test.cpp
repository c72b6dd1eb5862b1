#include "lissom/merge/merged_model.h"

#include "lissom/mesh/operators.h"
#include "tubes.h"

#include <doctest/doctest.h>

#include <algorithm>

using namespace lissom;
using namespace tubes;

namespace {

/// A dome merged onto a bowl whose file has vertices that no face uses.
struct Merged {
    TriangleMesh source = tube(20, 24, dome), target = shapes::with_unused_vertices(tube(16, 31, bowl, false), 2);
    WorkingMesh source_copy = shapes::working(source), target_copy = shapes::working(target);
    MergedModel model;

    Merged() {
        std::vector<int> rim; // of the target's file, numbered around its unused vertices
        for (int v = 0; v < target.vertex_count() && rim.size() < 31; ++v)
            if (target_copy.working_of_source[v] >= 0) rim.push_back(v);
        const std::vector<MergeBoundary> boundaries{{{first(24), {}}, {rim, {}}}};
        model = merged(source_copy, target_copy, boundaries, {{{0, rim[0]}}}).model;
    }
};

Eigen::RowVector3d place_of(const Origin& origin, const Points& points) {
    Eigen::RowVector3d out = Eigen::RowVector3d::Zero();
    for (std::size_t k = 0; k < 3; ++k) out += origin.weight[k] * points.row(origin.vertex[k]);
    return out;
}

} // namespace

TEST_CASE("kept vertices come in file order, the target's before the source's before new ones") {
    const Merged m;
    int next = 0;
    for (const int r : m.model.target.result_of_vertex)
        if (r >= 0) CHECK(r == next++);
    const int of_target = next;
    for (const int r : m.model.source.result_of_vertex)
        if (r >= of_target) CHECK(r == next++); // the others are left out, or became one with a target vertex
    CHECK(next > of_target);
    CHECK(m.model.positions.rows() == next + std::ssize(m.model.new_origin));
    CHECK(m.model.new_origin.size() == m.model.new_from_source.size());
}

TEST_CASE("what did not move of the target keeps its file's positions bit for bit") {
    const Merged m;
    int kept = 0;
    for (int v = 0; v < m.target.vertex_count(); ++v)
        if (const int r = m.model.target.result_of_vertex[v]; r >= 0) {
            ++kept;
            CHECK(m.model.positions.row(r) == m.target.points.row(v));
        }
    CHECK(kept == 16 * 31 + 1); // all that faces use
}

TEST_CASE("every polygon of the target goes in whole, or in pieces that cover it") {
    const Merged m;
    CHECK(std::is_sorted(m.model.target.faces.begin(), m.model.target.faces.end()));
    Eigen::VectorXd covered = Eigen::VectorXd::Zero(m.target.triangle_count());
    const Eigen::VectorXd areas = triangle_areas(m.target);
    for (const int f : m.model.target.faces) covered[f] += areas[f];
    for (std::size_t k = 0; k < m.model.cut_face.size(); ++k) {
        if (m.model.cut_from_source[k]) continue;
        TriangleMesh piece{Points(3, 3), Triangles(1, 3)};
        piece.triangles << 0, 1, 2;
        for (int c = 0; c < 3; ++c) piece.points.row(c) = m.model.positions.row(m.model.cut_vertices[3 * k + static_cast<std::size_t>(c)]);
        covered[m.model.cut_face[k]] += triangle_areas(piece)[0];
    }
    CHECK((covered - areas).cwiseAbs().maxCoeff() < 1e-9);
}

TEST_CASE("corners of cut triangles and new vertices lie where they say on the target's file") {
    const Merged m;
    for (std::size_t k = 0; k < m.model.cut_face.size(); ++k)
        for (std::size_t c = 0; c < 3; ++c) {
            const Origin& origin = m.model.cut_corners[3 * k + c];
            CHECK(origin.weight[0] + origin.weight[1] + origin.weight[2] == doctest::Approx(1));
            if (!m.model.cut_from_source[k])
                CHECK((place_of(origin, m.target.points) - m.model.positions.row(m.model.cut_vertices[3 * k + c])).norm() < 1e-9);
            const TriangleMesh& file = m.model.cut_from_source[k] ? m.source : m.target;
            for (std::size_t w = 0; w < 3; ++w) // of that polygon
                if (origin.weight[w] > 0) CHECK((file.triangles.row(m.model.cut_face[k]).array() == origin.vertex[w]).any());
        }
}

TEST_CASE("whole and cut together are the joined surface, and the seam runs along it") {
    const Merged m;
    const TriangleMesh mesh = mesh_of(m.model, m.source, m.target);
    check_closed(mesh, m.model.euler_characteristic);
    CHECK(m.model.euler_characteristic == 2);
    REQUIRE(m.model.seams.size() == 1);
    CHECK(m.model.seams[0].size() >= 31);
    for (const int v : m.model.seams[0]) CHECK((v >= 0 && v < m.model.positions.rows()));
}
