// Overlapped transition regions (Fu 3.3.3), configuration-dependent merging (Fu 3.3.2), and what is refused.

#include "lissom/merge/transition.h"

#include "refusal.h"
#include "tubes.h"

#include "lissom/mesh/operators.h"
#include "lissom/mesh/topology.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

using namespace lissom;
using namespace tubes;
using Eigen::Affine3d;

namespace {

const MergeBoundary tube_loops(int n, int m) {
    return {{first(n), {}}, {first(m), {}}};
}

/// The bowl with ribs around it.
Eigen::Vector3d ribbed(double s, double t) {
    const double r = 1.4 * (1 - s * s * s * s) * (1 + 0.03 * std::cos(12 * t) * std::min(1.0, 4 * (1 - s)));
    return {r * std::cos(t), -2 * s, r * std::sin(t)};
}

constexpr int k_around = 72;

/// A smooth dome merged to the ribbed bowl with a transition between them.
struct Blended {
    TriangleMesh source, target;
    MergeResult result;
    TriangleMesh mesh; ///< of the result
};

const Blended& smooth_on_ribbed() {
    static const Blended blended = [] {
        const int m = k_around;
        TriangleMesh source = tube(40, m, [](double s, double t) { return Eigen::Vector3d((1 - s * s * s) * std::cos(t), 2 * s, (1 - s * s * s) * std::sin(t)); });
        TriangleMesh bowl = tube(40, m, ribbed, false);
        const WorkingMesh from = shapes::working(source), target = shapes::working(bowl);
        MergeResult result = merged(from, target, {tube_loops(m, m)}, {{{0, 0}, {m / 2, m / 2}}}, {.transition = Transition{0.6, 0.8}});
        TriangleMesh mesh = mesh_of(result.model, source, bowl);
        return Blended{std::move(source), std::move(bowl), std::move(result), std::move(mesh)};
    }();
    return blended;
}

/// How strongly the radius of a ring of vertices varies as twelve ribs do.
double ribs(const TriangleMesh& mesh, const std::vector<int>& ring) {
    double c = 0, s = 0, mean = 0;
    for (const int v : ring) {
        const double r = std::hypot(mesh.points(v, 0), mesh.points(v, 2)), a = std::atan2(mesh.points(v, 2), mesh.points(v, 0));
        c += r * std::cos(12 * a);
        s += r * std::sin(12 * a);
        mean += r;
    }
    return 2 * std::hypot(c, s) / mean;
}

std::string code(const TriangleMesh& s, const TriangleMesh& t, const MergeBoundary& boundary, const MergeKeys& keys, MergeOptions options = {}) {
    return refusal([&] {
        const WorkingMesh source = shapes::working(s), target = shapes::working(t);
        (void)merged(source, target, {boundary}, {keys}, options);
    });
}

} // namespace

TEST_CASE("a strip and what is left of the part make up the part") {
    const TriangleMesh mesh = tube(24, 40, bowl, false);
    const std::vector<BoundaryLoop> loops{{first(40), {}}};
    const Part part = cut_part(mesh, loops, "target");
    Part rest;
    const Strip strip = cut_strip(part, 0, 0.4, "target", rest);
    CHECK(euler_characteristic(strip.mesh) == 0);
    CHECK(euler_characteristic(rest.mesh) == 1);
    CHECK(triangle_areas(strip.mesh).sum() + triangle_areas(rest.mesh).sum() == doctest::Approx(triangle_areas(mesh).sum()));
    REQUIRE(rest.loops.size() == 1);
    CHECK(rest.loops[0].size() == strip.far.size());
    const SquareMap map = square_map(strip, strip.near[3], false);
    for (int t = 0; t < map.triangles.rows(); ++t) {
        const Eigen::RowVector2d a = map.points.row(map.triangles(t, 0)), b = map.points.row(map.triangles(t, 1)), c = map.points.row(map.triangles(t, 2));
        CHECK((b - a).x() * (c - a).y() - (b - a).y() * (c - a).x() > 0); // u along the loop, the surface to its left: nothing folds
    }
}

TEST_CASE("with transition regions the merged model is closed, and the source's pose does not matter") {
    const TriangleMesh source = tube(30, 48, dome), target_mesh = tube(30, 60, ribbed, false);
    const WorkingMesh target = shapes::working(target_mesh);
    const MergeKeys keys{{0, 0}, {24, 30}};
    const auto run = [&](const Affine3d& map) {
        const WorkingMesh there = shapes::working(shapes::moved(source, map));
        const double scale = std::cbrt(map.linear().determinant());
        return merged(there, target, {tube_loops(48, 60)}, {keys}, {.transition = Transition{0.5 * scale, 0.5}});
    };
    const MergeResult plain = run(Affine3d::Identity());
    const TriangleMesh mesh = mesh_of(plain.model, source, target_mesh);
    CHECK(euler_characteristic(mesh) == 2);
    CHECK(boundary_loops(mesh).empty());
    CHECK(plain.seam.least_angle > 1);
    CHECK(plain.seam.high_dihedral < 20);
    double worst = 0;
    for (const Affine3d& map : twenty_similarities()) {
        const MergeResult other = run(map);
        REQUIRE(other.model.positions.rows() == plain.model.positions.rows());
        worst = std::max(worst, (other.model.positions - plain.model.positions).rowwise().norm().maxCoeff());
    }
    CHECK(worst < 1e-6 * diagonal(target_mesh.points));
}

TEST_CASE("inside a transition the detail lies between that of the two inputs, and fades from one to the other") {
    const Blended& made = smooth_on_ribbed();
    const TriangleMesh &target_mesh = made.target, &mesh = made.mesh;
    const MergeResult& blended = made.result;
    const int m = k_around;
    std::vector<double> strength;
    for (int row = 1; row < 20; ++row) {
        std::vector<int> ring;
        for (int j = 0; j < m; ++j) ring.push_back(blended.model.source.result_of_vertex[row * m + j]);
        strength.push_back(ribs(mesh, ring));
    }
    std::vector<int> rim;
    for (int j = 0; j < m; ++j) rim.push_back(20 * m + j);
    const double full = ribs(target_mesh, rim);
    for (const double s : strength) CHECK(s < 1.1 * full);
    CHECK(strength[0] > 0.5 * full); // beside the seam the target's ribs go on
    CHECK(strength[3] > 0.2 * full);
    CHECK(strength.back() < 0.15 * full); // beyond the transition the source is as smooth as it was
}

TEST_CASE("keys come to lie at the same place of both squares, and nothing folds") {
    const std::vector<BoundaryLoop> loops{{first(40), {}}};
    const Part part = cut_part(tube(24, 40, bowl, false), loops, "target");
    Part rest;
    const Strip strip = cut_strip(part, 0, 0.4, "target", rest);
    const int key = strip.near[10];
    CHECK(fraction_from(strip, strip.near[0], false, key) == doctest::Approx(0.25));
    const SquareMap map = square_map(strip, strip.near[0], false, {{key, 0.4}});
    CHECK(map.points(key, 0) == doctest::Approx(0.4));
    CHECK(map.points(across_from(strip, key), 0) == doctest::Approx(0.4));
    CHECK(map.points(strip.near[5], 0) == doctest::Approx(0.2));
    for (int t = 0; t < map.triangles.rows(); ++t) {
        const Eigen::RowVector2d a = map.points.row(map.triangles(t, 0)), b = map.points.row(map.triangles(t, 1)), c = map.points.row(map.triangles(t, 2));
        CHECK((b - a).x() * (c - a).y() - (b - a).y() * (c - a).x() > 0);
    }
}

TEST_CASE("mean curvature varies inside a transition more than on the smooth input and less than on the ribbed one") {
    const Blended& made = smooth_on_ribbed();
    const TriangleMesh &source = made.source, &target_mesh = made.target, &mesh = made.mesh;
    const MergeResult& blended = made.result;
    const int m = k_around;
    // Relative to the radius, so that the two tubes' sizes do not matter: rows 2 to 10 are well inside.
    const auto variation = [&](const TriangleMesh& on, auto vertex) {
        const Points normal = (cotangent_laplacian(on) * on.points).array().colwise() / vertex_areas(on).array();
        double sum = 0;
        for (int row = 2; row <= 10; ++row) {
            double radius = 0, mean = 0, square = 0;
            for (int j = 0; j < m; ++j) {
                const int v = vertex(row * m + j);
                radius += std::hypot(on.points(v, 0), on.points(v, 2)) / m;
                const double H = normal.row(v).norm() / 2;
                mean += H / m;
                square += H * H / m;
            }
            sum += radius * std::sqrt(std::max(0.0, square - mean * mean));
        }
        return sum / 9;
    };
    const double smooth = variation(source, [](int v) { return v; });
    const double full = variation(target_mesh, [](int v) { return v; });
    const double inside = variation(mesh, [&](int v) { return blended.model.source.result_of_vertex[v]; });
    CAPTURE(smooth);
    CAPTURE(inside);
    CAPTURE(full);
    CHECK(inside > smooth);
    CHECK(inside < full);
}

TEST_CASE("in dependent merging handles stay where they are and the boundary comes to them") {
    const TriangleMesh source_mesh = tube(30, 32, dome), target_mesh = tube(24, 40, bowl, false);
    const WorkingMesh source = shapes::working(source_mesh), target = shapes::working(target_mesh);
    std::vector<int> tip;
    for (int v = 25 * 32; v < source_mesh.vertex_count(); ++v) tip.push_back(v);
    const Affine3d place(Eigen::Translation3d(0.1, 0.3, 0));
    const std::vector<MergeBoundary> boundaries{tube_loops(32, 40)};
    const std::vector<MergeHandle> handles{{tip, Affine3d::Identity()}};
    MergeSession session(source, target, boundaries, {.mode = MergeMode::dependent, .placement = place}, {}, handles);
    while (session.step()) {}
    const MergeResult result = session.merge(std::vector<MergeKeys>{{{0, 0}, {16, 20}}});
    CHECK(result.model.euler_characteristic == 2);
    for (const int v : tip) {
        const Eigen::Vector3d placed = place * Eigen::Vector3d(source_mesh.points.row(v));
        CHECK((result.model.positions.row(result.model.source.result_of_vertex[v]).transpose() - placed).norm() < 1e-9);
    }
    // Outside a limited region nothing of the placed source moves.
    std::vector<int> near;
    for (int v = 0; v < 15 * 32; ++v) near.push_back(v);
    MergeSession limited(source, target, boundaries, {.mode = MergeMode::dependent, .placement = place}, near);
    while (limited.step()) {}
    const MergeResult part = limited.merge(std::vector<MergeKeys>{{{0, 0}, {16, 20}}});
    CHECK(limited.free_vertices() < session.free_vertices());
    for (int v = 15 * 32; v < source_mesh.vertex_count(); ++v)
        CHECK((part.model.positions.row(part.model.source.result_of_vertex[v]).transpose() - place * Eigen::Vector3d(source_mesh.points.row(v))).norm() < 1e-9);
}

TEST_CASE("several pairs of boundaries of different sizes are joined at once") {
    // A tube open at both ends between two bowls, in one target of two pieces.
    const TriangleMesh pipe = shapes::cylinder(24, 16, 3);
    const TriangleMesh lower = tube(16, 30, [](double s, double t) { return Eigen::Vector3d(1.5 * (1 - s * s * s) * std::cos(t), 1.5 * (1 - s * s * s) * std::sin(t), -2 * s); }, true);
    const TriangleMesh upper = tube(16, 18, [](double s, double t) { return Eigen::Vector3d(3 + 0.6 * (1 - s * s * s) * std::cos(t), 0.6 * (1 - s * s * s) * std::sin(t), 4 + 2 * s); }, true);
    const TriangleMesh target_mesh = shapes::joined({lower, upper});
    const auto pipe_loops = boundary_loops(pipe), target_loops = boundary_loops(target_mesh);
    REQUIRE(pipe_loops.size() == 2);
    REQUIRE(target_loops.size() == 2);
    const std::vector<MergeBoundary> boundaries{{{pipe_loops[0], {}}, {target_loops[0], {}}}, {{pipe_loops[1], {}}, {target_loops[1], {}}}};
    const WorkingMesh target = shapes::working(target_mesh);
    const std::vector<MergeKeys> keys{{{pipe_loops[0][0], target_loops[0][0]}}, {{pipe_loops[1][0], target_loops[1][0]}}};
    const WorkingMesh still = shapes::working(pipe);
    const MergeResult plain = merged(still, target, boundaries, keys);
    CHECK(plain.model.euler_characteristic == 2);
    CHECK(plain.model.seams.size() == 2);
    CHECK(boundary_loops(mesh_of(plain.model, pipe, target_mesh)).empty());
    double worst = 0;
    for (const Affine3d& map : twenty_similarities()) {
        const WorkingMesh source = shapes::working(shapes::moved(pipe, map));
        worst = std::max(worst, (merged(source, target, boundaries, keys).model.positions - plain.model.positions).rowwise().norm().maxCoeff());
    }
    CHECK(worst < 1e-6 * diagonal(target_mesh.points));
}

TEST_CASE("a loop of three vertices is refined to meet one of three hundred") {
    const TriangleMesh few = tube(5, 3, dome), many = tube(40, 300, bowl, false);
    for (const bool swap : {false, true}) {
        const TriangleMesh &s = swap ? many : few, &t = swap ? few : many;
        const WorkingMesh source = shapes::working(s), target = shapes::working(t);
        const MergeResult result = merged(source, target, {tube_loops(swap ? 300 : 3, swap ? 3 : 300)}, {{{0, 0}}});
        CHECK(result.model.euler_characteristic == 2);
        CHECK(result.seam.least_angle > 1);
        CHECK(boundary_loops(mesh_of(result.model, s, t)).empty());
    }
}

TEST_CASE("what cannot be merged is refused with what is wrong") {
    const TriangleMesh s = tube(24, 20, dome), t = tube(24, 31, bowl, false), ring = shapes::torus(40, 20), fin = shapes::with_fin(tube(24, 20, dome));
    const MergeKeys key{{0, 0}};
    CHECK(code(s, t, tube_loops(20, 31), key) == "none");
    CHECK(code(s, t, {{{0, 1}, {}}, {first(31), {}}}, key) == "loop-too-short");
    CHECK(code(s, t, {{{0, 1, 2, 22, 21, 1, 20}, {}}, {first(31), {}}}, key) == "loop-touches-itself");
    CHECK(code(s, t, {{{0, 5, 10}, {}}, {first(31), {}}}, key) == "loop-not-connected");
    CHECK(code(s, t, {{{0, 1, 9999}, {}}, {first(31), {}}}, key) == "vertex-out-of-range");
    CHECK(code(s, t, tube_loops(20, 31), {{0, 0}, {5, 8}, {10, 22}, {15, 15}}) == "keys-out-of-order");
    CHECK(code(s, t, tube_loops(20, 31), {{0, 0}, {5, 0}}) == "key-repeated");
    CHECK(code(s, t, tube_loops(20, 31), {{40, 0}}) == "key-not-on-boundary");
    std::vector<int> around; // a meridian of the torus: cutting there parts nothing
    for (int j = 0; j < 20; ++j) around.push_back(j);
    CHECK(code(ring, t, {{around, {}}, {first(31), {}}}, key) == "loop-not-separating");
    CHECK(code(fin, t, tube_loops(20, 31), key) == "loop-touches-boundary");
    CHECK(code(s, t, tube_loops(20, 31), key, {.transition = Transition{50, 0.5}}) == "transition-not-a-ring");
    CHECK(code(s, t, tube_loops(20, 31), key, {.transition = Transition{-1, 0.5}}) == "bad-option");
    // Loops given in either direction come to the same.
    std::vector<int> backwards = first(20);
    std::reverse(backwards.begin(), backwards.end());
    CHECK(code(s, t, {{backwards, {}}, {first(31), {}}}, key) == "none");
}
