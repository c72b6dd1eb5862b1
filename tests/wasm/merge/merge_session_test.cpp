// Configuration-independent merging (Fu 3.3.1): what must hold exactly.

#include "lissom/merge/merge_session.h"

#include "refusal.h"
#include "tubes.h"

#include "lissom/mesh/operators.h"
#include "lissom/mesh/topology.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace lissom;
using namespace tubes;
using Eigen::Affine3d;

namespace {

struct Pair {
    const char* name;
    TriangleMesh source, target;
    std::vector<MergeBoundary> boundaries;
    std::vector<MergeKeys> keys;
    int euler;
};

std::vector<Pair> pairs() {
    std::vector<Pair> list;
    const auto two = [&](const char* name, TriangleMesh s, TriangleMesh t, int n, int m) {
        list.push_back({name, std::move(s), std::move(t), {{{first(n), {}}, {first(m), {}}}}, {{{0, 0}, {n / 2, m / 2}}}, 2});
    };
    two("dome 20 on bowl 31", tube(24, 20, dome), tube(24, 31, bowl, false), 20, 31);
    two("dome 60 on bowl 18", tube(30, 60, dome), tube(12, 18, bowl, false), 60, 18);
    two("dome 24 on bowl 24", tube(24, 24, dome), tube(24, 24, bowl, false), 24, 24);
    return list;
}

} // namespace

TEST_CASE("merged tubes are one watertight, consistently oriented surface of the Euler characteristic predicted") {
    for (const Pair& pair : pairs()) {
        CAPTURE(pair.name);
        const WorkingMesh source = shapes::working(pair.source), target = shapes::working(pair.target);
        const MergeResult result = merged(source, target, pair.boundaries, pair.keys, {.smoothing = 1});
        CHECK_FALSE(result.source_turned);
        CHECK(result.model.euler_characteristic == pair.euler);
        const TriangleMesh mesh = mesh_of(result.model, pair.source, pair.target);
        check_closed(mesh, pair.euler);
        CHECK(components(vertex_rings(mesh)).count == 1);
        CHECK(signed_volume(mesh) > 0);
        CHECK(result.seam.least_angle > 1);
        CHECK(result.seam.high_dihedral < result.seam.own_high_dihedral);
    }
}

TEST_CASE("where the source stands, how it is turned and how large it is do not matter") {
    for (const Pair& pair : pairs()) {
        CAPTURE(pair.name);
        const WorkingMesh target = shapes::working(pair.target);
        const WorkingMesh still = shapes::working(pair.source);
        const MergeResult plain = merged(still, target, pair.boundaries, pair.keys);
        double worst = 0;
        for (const Affine3d& map : twenty_similarities()) {
            const WorkingMesh source = shapes::working(shapes::moved(pair.source, map));
            const MergeResult other = merged(source, target, pair.boundaries, pair.keys);
            REQUIRE(other.model.positions.rows() == plain.model.positions.rows());
            CHECK(other.model.cut_vertices == plain.model.cut_vertices);
            worst = std::max(worst, (other.model.positions - plain.model.positions).rowwise().norm().maxCoeff());
        }
        CHECK(worst < 1e-6 * diagonal(pair.target.points));
    }
}

TEST_CASE("a source that faces inward is turned and merges as if it faced outward") {
    for (const Pair& pair : pairs()) {
        CAPTURE(pair.name);
        const WorkingMesh target = shapes::working(pair.target), outward = shapes::working(pair.source);
        const TriangleMesh inside_out = shapes::turned_inside_out(pair.source);
        const WorkingMesh inward = shapes::working(inside_out);
        const MergeResult plain = merged(outward, target, pair.boundaries, pair.keys), turned = merged(inward, target, pair.boundaries, pair.keys);
        CHECK(turned.source_turned);
        CHECK((turned.model.positions - plain.model.positions).rowwise().norm().maxCoeff() < 1e-3 * diagonal(pair.target.points));
        check_closed(mesh_of(turned.model, inside_out, pair.target), pair.euler);
    }
}

TEST_CASE("the target keeps every bit of its shape") {
    const Pair pair = pairs().front();
    const WorkingMesh source = shapes::working(pair.source), target = shapes::working(pair.target);
    const MergedModel model = merged(source, target, pair.boundaries, pair.keys).model;
    for (int v = 0; v < pair.target.vertex_count(); ++v) CHECK(model.positions.row(model.target.result_of_vertex[v]) == pair.target.points.row(v));
}

TEST_CASE("a part cut off and merged back to where it was returns to its place") {
    // Cut an icosphere along the loop around a cap, and join both pieces with the same loop: all vertices come together.
    const TriangleMesh ball = shapes::bumpy_sphere(4);
    std::vector<int> cap;
    for (int v = 0; v < ball.vertex_count(); ++v)
        if (ball.points(v, 1) > 0.4) cap.push_back(v);
    const auto loops = loops_around(ball, cap);
    REQUIRE(loops.size() == 1);
    std::vector<int> rest;
    for (int v = 0; v < ball.vertex_count(); ++v)
        if (ball.points(v, 1) < 0.2) rest.push_back(v);
    const WorkingMesh working = shapes::working(ball);
    const MergeResult result = merged(working, working, {{{loops[0], cap}, {loops[0], rest}}}, {{{loops[0][0], loops[0][0]}, {loops[0][5], loops[0][5]}}});
    CHECK(result.model.euler_characteristic == 2);
    double worst = 0;
    for (const int v : cap) worst = std::max(worst, (result.model.positions.row(result.model.source.result_of_vertex[v]) - ball.points.row(v)).norm());
    CHECK(worst < 0.05 * diagonal(ball.points));
}

TEST_CASE("a boundary that a vertex far away leaves no size beside its model is refused in either mode, in any unit") {
    for (const double far : {1e30, 1e9})
        for (const MergeMode mode : {MergeMode::independent, MergeMode::dependent})
            for (const bool of_source : {false, true})
                for (const int vertex : {0, 7, 100}) {
                    TriangleMesh s = tube(10, 20, dome), t = tube(10, 31, bowl, false);
                    (of_source ? s : t).points(vertex, 1) = far;
                    for (const double unit : {1e-3, 1.0, 1e3}) {
                        s.points *= unit;
                        t.points *= unit;
                        const WorkingMesh source = shapes::working(s), target = shapes::working(t);
                        CHECK(refusal([&] { MergeSession(source, target, std::vector<MergeBoundary>{{{first(20), {}}, {first(31), {}}}}, {.mode = mode}); }) == "boundary-too-small");
                    }
                }
}

TEST_CASE("a source placed where numbers do not tell its vertices apart is refused") {
    const WorkingMesh source = shapes::working(tube(10, 20, dome)), target = shapes::working(tube(10, 31, bowl, false));
    MergeOptions options{.mode = MergeMode::dependent};
    const auto place = [&](double scale, double away) {
        options.placement = Eigen::Translation3d(away, 0, 0) * Eigen::Scaling(scale);
        return refusal([&] { MergeSession(source, target, std::vector<MergeBoundary>{{{first(20), {}}, {first(31), {}}}}, options); });
    };
    CHECK(place(1, 3) == "none");
    CHECK(place(1, 1e6) == "none");
    CHECK(place(1e-3, 1e9) == "placed-too-far");
    CHECK(place(1e-30, 1) == "placed-too-far");
    CHECK(place(0, 1) == "placed-too-far");
}

TEST_CASE("keys that lead two thousand vertices onto one edge are merged all the same") {
    const TriangleMesh s = tube(10, 20, dome), t = tube(10, 2000, bowl, false);
    const WorkingMesh source = shapes::working(s), target = shapes::working(t);
    const MergeResult result = merged(source, target, {{{first(20), {}}, {first(2000), {}}}}, {{{0, 0}, {1, 1998}}});
    check_closed(mesh_of(result.model, s, t), 2);
}
