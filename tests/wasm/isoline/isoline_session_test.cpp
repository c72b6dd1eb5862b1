#include "lissom/isoline/isoline_session.h"

#include "refusal.h"
#include "sessions.h"

#include "lissom/mesh/operators.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <map>

using namespace lissom;
using namespace sessions;
using Eigen::Affine3d;
using Eigen::Vector3d;
using handles::gap;
using handles::images;
using handles::turn;

namespace {

DeformHandle point(int v) { return {.is_point = true, .vertices = {v}}; }

bool says(const std::vector<Finding>& findings, const std::string& code) {
    return std::any_of(findings.begin(), findings.end(), [&](const Finding& f) { return f.code == code; });
}

std::string code(const TriangleMesh& mesh, const std::vector<DeformHandle>& held, const IsolineOptions& options = {}) {
    return refusal([&] {
        const Prepared prepared(mesh);
        (void)prepared.session(held, options);
    });
}

int farthest(const Points& points, const Vector3d& direction) {
    int v = 0;
    (points * direction).maxCoeff(&v);
    return v;
}

} // namespace

TEST_CASE("a common rigid motion of the handles is that of the surface, whatever the surface") {
    const Affine3d map = Eigen::Translation3d(2, -3, 1) * turn(100, {1, 1, -1});
    for (const handles::Named& model : handles::models()) {
        if (std::string(model.name) == "two spheres") continue; // one handle each: another case
        CAPTURE(model.name);
        for (const int count : {2, 4}) {
            const auto held = axis_caps(model.mesh.points, count);
            const Points moved = drag(model.mesh, held, std::vector<Affine3d>(static_cast<std::size_t>(count), map), {}, 1).positions;
            CHECK(gap(moved, images(map, model.mesh.points)) < 1e-9 * diagonal(model.mesh.points));
        }
    }
}

TEST_CASE("handles are where they were sent to, flat ones too, points too") {
    const TriangleMesh bar = shapes::bar();
    auto held = handles::two_ends(bar.points, 1e-3); // end faces: flat
    int edge = 0;
    (bar.points.rowwise() - Eigen::RowVector3d(0.5, 4, 0.5)).rowwise().norm().minCoeff(&edge);
    held.push_back(point(edge));
    const std::vector<Affine3d> targets{turn(40, {0, 1, 0}), handles::some_affine(), Affine3d(Eigen::Translation3d(0.7, 0.2, -0.1))};
    const Prepared prepared(bar);
    IsolineSession session = prepared.session(held);
    (void)session.drag(targets, 20);
    const Points moved = session.positions();
    for (std::size_t h = 0; h < held.size(); ++h)
        for (const int v : held[h].vertices)
            CHECK((moved.row(v).transpose() - targets[h] * Vector3d(bar.points.row(v))).norm() < 1e-12 * diagonal(bar.points));
    // What is not substituted afterwards agrees with it: the controls themselves put the handles there.
    const std::vector<double> controls = session.control_offsets();
    const Eigen::VectorXf field = session.field(1);
    for (const int v : held[1].vertices) {
        CHECK(field[v] == 1);
        const Vector3d x = bar.points.row(v);
        Vector3d there = bar.points.row(v);
        for (int r = 0; r < 3; ++r) {
            const double* row = controls.data() + 12 * session.sets().end_control(1) + 4 * r;
            there[r] += row[0] * x[0] + row[1] * x[1] + row[2] * x[2] + row[3];
        }
        CHECK((there - targets[1] * Vector3d(bar.points.row(v))).norm() < 1e-9);
    }
}

TEST_CASE("resting handles leave every vertex where it is, bit for bit, and outside the region nothing ever moves") {
    const TriangleMesh mesh = shapes::bumpy_sphere(4);
    const Prepared prepared(mesh);
    IsolineSession session = prepared.session(axis_caps(mesh.points, 3));
    (void)session.drag(std::vector<Affine3d>(3, Affine3d::Identity()));
    CHECK(session.positions() == mesh.points);

    std::vector<int> roi;
    for (int v = 0; v < mesh.vertex_count(); ++v)
        if (mesh.points(v, 1) > 0) roi.push_back(v);
    IsolineSession part(prepared.model, roi, std::vector{point(farthest(mesh.points, {0, 1, 0}))});
    while (part.step()) {
    }
    CHECK(part.holds_rest());
    CHECK(part.field_count() - part.free_handle_count() == 2);
    (void)part.drag(std::vector{Affine3d(Eigen::Translation3d(0.1, 0.5, 0))}, 20);
    const Points moved = part.positions();
    int still = 0, gone = 0;
    for (int v = 0; v < mesh.vertex_count(); ++v) {
        if (mesh.points(v, 1) <= 0) {
            CHECK(moved.row(v) == mesh.points.row(v));
            ++still;
        } else if (moved.row(v) != mesh.points.row(v)) ++gone;
    }
    CHECK(still > 500);
    CHECK(gone > 500);
}

TEST_CASE("unit, place and numbering do not matter") {
    const TriangleMesh mesh = shapes::bumpy_sphere(4);
    const auto held = axis_caps(mesh.points, 3);
    const std::vector<Affine3d> targets{Affine3d::Identity(), turn(60, {1, 0, 0}) * Eigen::Translation3d(0, 0.3, 0), Affine3d(Eigen::Translation3d(0.2, 0.4, -0.3))};
    const Points here = drag(mesh, held, targets).positions;
    for (const double unit : {1e-3, 1e3}) {
        const Affine3d there(Eigen::Translation3d(4 * unit, -7 * unit, unit) * Eigen::Scaling(unit));
        std::vector<Affine3d> moved;
        for (const Affine3d& target : targets) moved.emplace_back(there * target * there.inverse());
        const Points result = drag(shapes::moved(mesh, there), held, moved).positions;
        CHECK(gap(images(there.inverse(), result), here) < 1e-6);
    }
    const std::vector<int> place = shapes::permutation(mesh.vertex_count(), 3);
    auto shuffled = held;
    for (DeformHandle& handle : shuffled)
        for (int& v : handle.vertices) v = place[v];
    const Points result = drag(shapes::permuted(mesh, place), shuffled, targets).positions;
    double worst = 0;
    for (int v = 0; v < mesh.vertex_count(); ++v) worst = std::max(worst, (result.row(place[v]) - here.row(v)).norm());
    CHECK(worst < 0.002 * diagonal(mesh.points)); // patches start elsewhere where two places are equally good
}

namespace {

struct Divided {
    TriangleMesh mesh;
    std::vector<DeformHandle> held;
};

/// Each triangle in four: the same shape exactly, old vertices first. A new vertex is in a handle where both ends of its edge are.
Divided divided(const Divided& from) {
    const std::vector<Edge> sides = edges(from.mesh);
    std::map<std::pair<int, int>, int> middle;
    Divided to;
    const int n = from.mesh.vertex_count();
    to.mesh.points.resize(n + std::ssize(sides), 3);
    to.mesh.points.topRows(n) = from.mesh.points;
    std::vector<int> owner(static_cast<std::size_t>(n), -1);
    for (std::size_t h = 0; h < from.held.size(); ++h)
        for (const int v : from.held[h].vertices) owner[v] = static_cast<int>(h);
    to.held = from.held;
    for (std::size_t e = 0; e < sides.size(); ++e) {
        const int v = n + static_cast<int>(e), a = sides[e].a, b = sides[e].b;
        middle[{a, b}] = v;
        to.mesh.points.row(v) = 0.5 * (from.mesh.points.row(a) + from.mesh.points.row(b));
        if (owner[a] >= 0 && owner[a] == owner[b]) to.held[owner[a]].vertices.push_back(v);
    }
    to.mesh.triangles.resize(4 * from.mesh.triangle_count(), 3);
    for (int t = 0; t < from.mesh.triangle_count(); ++t) {
        int c[3], m[3];
        for (int k = 0; k < 3; ++k) c[k] = from.mesh.triangles(t, k);
        for (int k = 0; k < 3; ++k) m[k] = middle.at(std::minmax(c[k], c[(k + 1) % 3]));
        for (int k = 0; k < 3; ++k) to.mesh.triangles.row(4 * t + k) << c[k], m[k], m[(k + 2) % 3];
        to.mesh.triangles.row(4 * t + 3) << m[0], m[1], m[2];
    }
    return to;
}

} // namespace

TEST_CASE("the same shape in four and sixteen times as many triangles bends the same") {
    const TriangleMesh bar = shapes::box(8, 40, 8, {1, 5, 1});
    const struct {
        const char* name;
        Divided once;
        std::vector<Affine3d> targets;
    } cases[] = {{"bar", {bar, handles::two_ends(bar.points, 0.1)}, {Affine3d::Identity(), turn(-70, {0, 0, 1}, {1.5, 3, 0})}},
                 {"bumpy sphere",
                  {shapes::bumpy_sphere(4), axis_caps(shapes::bumpy_sphere(4).points, 3)},
                  {Affine3d::Identity(), turn(60, {0, 1, 0}) * Eigen::Translation3d(-0.3, 0.2, 0), Affine3d(Eigen::Translation3d(0, 0.4, 0))}}};
    for (const auto& [name, once, targets] : cases) {
        const Points coarse = drag(once.mesh, once.held, targets).positions;
        Divided finer = once;
        for (const int times : {4, 16}) {
            finer = divided(finer);
            const Points fine = drag(finer.mesh, finer.held, targets).positions;
            const double change = (coarse - fine.topRows(coarse.rows())).rowwise().norm().mean() / diagonal(coarse);
            MESSAGE(std::string(name) << ", " << times << " times as many triangles: mean change " << change << " of the diagonal");
            CHECK(change < 0.002);
        }
    }
}

TEST_CASE("one handle carries everything, a point by its move alone") {
    const TriangleMesh mesh = shapes::bumpy_sphere(3);
    const Affine3d map = handles::some_similarity();
    const Points all = drag(mesh, {axis_caps(mesh.points, 1)}, {map}).positions;
    CHECK(gap(all, images(map, mesh.points)) < 1e-9);
    const int v = farthest(mesh.points, {0, 1, 0});
    const Points moved = drag(mesh, {point(v)}, {Affine3d(Eigen::Translation3d(1, 2, 3) * turn(50, {1, 0, 0}, mesh.points.row(v)))}).positions;
    CHECK(gap(moved, mesh.points.rowwise() + Eigen::RowVector3d(1, 2, 3)) < 1e-9);
}

TEST_CASE("points alone turn the surface with them") {
    const TriangleMesh mesh = shapes::bumpy_sphere(4);
    const Affine3d map = turn(50, {1, 2, 1});
    std::vector<DeformHandle> held;
    for (const Vector3d& d : {Vector3d(1, 0, 0), Vector3d(-1, 0, 0), Vector3d(0, 1, 0), Vector3d(0, 0, 1)}) held.push_back(point(farthest(mesh.points, d)));
    const Points moved = drag(mesh, held, std::vector<Affine3d>(4, map), {}, 200).positions;
    CHECK(gap(moved, images(map, mesh.points)) < 0.02);
}

TEST_CASE("forty handles, and a handle over a whole component") {
    const TriangleMesh mesh = shapes::bumpy_sphere(5);
    std::vector<DeformHandle> held;
    std::vector<Affine3d> targets;
    for (int h = 0; h < 40; ++h) { // Fibonacci's spiral
        const double y = 1 - (2 * h + 1) / 40.0, r = std::sqrt(1 - y * y), a = h * 2.399963;
        held.push_back(point(farthest(mesh.points.rowwise().normalized(), {r * std::cos(a), y, r * std::sin(a)})));
        targets.emplace_back(Eigen::Translation3d(0.05 * std::sin(h), 0.05 * std::cos(h), 0));
    }
    const Prepared prepared(mesh);
    IsolineSession many = prepared.session(held);
    CHECK(many.field_count() >= 40);
    (void)many.drag(targets, 20);
    const Points moved = many.positions();
    for (int h = 0; h < 40; ++h) CHECK((moved.row(held[h].vertices[0]).transpose() - targets[h] * Vector3d(mesh.points.row(held[h].vertices[0]))).norm() < 1e-12);
    CHECK(handles::edge_rms(mesh, moved) < 0.3);

    const TriangleMesh two = shapes::two_spheres(3);
    const int half = two.vertex_count() / 2;
    DeformHandle whole;
    for (int v = half; v < two.vertex_count(); ++v) whole.vertices.push_back(v);
    auto ends = axis_caps(two.points.topRows(half), 2);
    ends.push_back(whole);
    const Affine3d map = handles::some_affine();
    const Points parts = drag(two, ends, {Affine3d::Identity(), turn(30, {1, 0, 0}), map}).positions;
    CHECK(gap(parts.bottomRows(half), images(map, two.points.bottomRows(half))) < 1e-9);
}

TEST_CASE("a component without a handle stays at rest, and is named") {
    const TriangleMesh mesh = shapes::with_extra_shell(shapes::bumpy_sphere(3));
    const Prepared prepared(mesh);
    IsolineSession session = prepared.session(axis_caps(shapes::bumpy_sphere(3).points, 2));
    CHECK(says(session.warnings(), "component-without-handle"));
    (void)session.drag(std::vector{Affine3d::Identity(), handles::some_similarity()});
    const Points moved = session.positions();
    const auto still = session.still_vertices();
    for (int v = 0; v < mesh.vertex_count(); ++v) {
        CHECK(still[v] == (v >= shapes::bumpy_sphere(3).vertex_count()));
        if (still[v]) CHECK(moved.row(v) == mesh.points.row(v));
    }
}

TEST_CASE("handles that touch are named, and again when they are pulled apart") {
    const TriangleMesh mesh = shapes::bumpy_sphere(3);
    std::vector<DeformHandle> held(2);
    for (int v = 0; v < mesh.vertex_count(); ++v)
        if (mesh.points(v, 1) > 0.7) held[mesh.points(v, 0) > 0 ? 0 : 1].vertices.push_back(v);
    auto three = held;
    three.push_back(point(farthest(mesh.points, {0, -1, 0})));
    const Prepared prepared(mesh);
    IsolineSession session = prepared.session(three);
    CHECK(says(session.warnings(), "handles-touch"));
    CHECK_FALSE(says(session.drag(std::vector<Affine3d>(3, turn(40, {0, 1, 0}))).warnings, "handles-pulled-apart"));
    const IsolineFrame frame = session.drag(std::vector{Affine3d::Identity(), Affine3d(Eigen::Translation3d(-1, 0, 0)), Affine3d::Identity()});
    REQUIRE(says(frame.warnings, "handles-pulled-apart"));
    CHECK(frame.warnings.front().examples == std::vector<int>{0, 1});
    CHECK(session.positions().allFinite());
}

TEST_CASE("each request that makes no sense is refused by name") {
    const TriangleMesh mesh = shapes::torus();
    const DeformHandle some{.is_point = false, .vertices = {1, 2, 3}};
    CHECK(code(mesh, {}) == "no-handle");
    CHECK(code(mesh, {DeformHandle{}}) == "empty-handle");
    CHECK(code(mesh, {DeformHandle{.is_point = false, .vertices = {mesh.vertex_count()}}}) == "vertex-out-of-range");
    CHECK(code(mesh, {some, point(2)}) == "handle-overlap");
    CHECK(code(mesh, {DeformHandle{.is_point = true, .vertices = {1, 2}}}) == "point-handle-size");
    const std::vector<DeformHandle> fine{some, point(9)};
    CHECK(code(mesh, fine, {.controls = 2}) == "bad-option");
    CHECK(code(mesh, fine, {.smoothness = 0}) == "bad-option");
    CHECK(code(mesh, fine, {.patches = 0}) == "bad-option");
    CHECK(code(mesh, fine, {.solves = 0}) == "bad-option");
    CHECK(code(mesh, fine, {.acceleration = -1}) == "bad-option");
    CHECK(code(mesh, fine, {.free_handles = -1}) == "bad-option");
    CHECK(code(mesh, fine, {.settle_passes = 4}) == "bad-option");

    const Prepared prepared(mesh);
    IsolineSession session = prepared.session(fine);
    CHECK(refusal([&] { (void)session.drag(std::vector<Affine3d>{}); }) == "handle-count");
    Affine3d broken = Affine3d::Identity();
    broken.translation().x() = std::numeric_limits<double>::quiet_NaN();
    CHECK(refusal([&] { (void)session.drag(std::vector{broken, broken}); }) == "non-finite-target");
}

TEST_CASE("the eight broken meshes bend or are refused, and never give a number that is none") {
    for (const shapes::Broken& broken : shapes::eight_broken(shapes::bumpy_sphere(3))) {
        CAPTURE(broken.name);
        std::vector<DeformHandle> held(2);
        for (int v = 0; v < broken.mesh.vertex_count(); ++v) {
            if (!broken.mesh.points.row(v).allFinite()) continue;
            if (broken.mesh.points(v, 1) > 0.8) held[0].vertices.push_back(v);
            if (broken.mesh.points(v, 1) < -0.8) held[1].vertices.push_back(v);
        }
        const Points moved = drag(broken.mesh, held, {turn(60, {0, 0, 1}), Affine3d(Eigen::Translation3d(0.3, 0, 0))}).positions;
        for (int v = 0; v < broken.mesh.vertex_count(); ++v)
            if (broken.mesh.points.row(v).allFinite()) CHECK(moved.row(v).allFinite());
    }
}

TEST_CASE("through a proxy the surface moves as without one") {
    const TriangleMesh mesh = shapes::bumpy_sphere(6);
    auto held = axis_caps(mesh.points, 3);
    held.push_back(point(farthest(mesh.points, {0.5, -0.7, 0.4})));
    const std::vector<Affine3d> targets{Affine3d::Identity(), turn(50, {0, 1, 0}) * Eigen::Translation3d(-0.3, 0, 0), Affine3d(Eigen::Translation3d(0, 0.4, 0.1)),
                                        Affine3d(Eigen::Translation3d(0.2, 0, 0.2))};
    const Prepared direct(mesh), proxied(mesh, {.proxy_vertices = 20000});
    REQUIRE_FALSE(direct.model.is_proxy());
    REQUIRE(proxied.model.is_proxy());
    IsolineSession one = direct.session(held), two = proxied.session(held);
    (void)one.drag(targets, 40);
    (void)two.drag(targets, 40);
    const Points a = one.positions(), b = two.positions();
    const double mean = (a - b).rowwise().norm().mean() / diagonal(mesh.points);
    CHECK(one.free_handle_count() == two.free_handle_count());
    MESSAGE(one.free_handle_count() << " free handles; a proxy of half the vertices changes the result by " << mean << " of the diagonal in the mean");
    CHECK(mean < 0.004);
    for (std::size_t h = 0; h < held.size(); ++h)
        for (const int v : held[h].vertices) CHECK((b.row(v).transpose() - targets[h] * Vector3d(mesh.points.row(v))).norm() < 1e-12);
}

TEST_CASE("the numbers for a shader give the positions and the normals of the core") {
    const TriangleMesh mesh = shapes::bumpy_sphere(5);
    const auto held = axis_caps(mesh.points, 4);
    const Prepared prepared(mesh);
    IsolineSession session = prepared.session(held);
    (void)session.drag(std::vector{Affine3d::Identity(), turn(50, {0, 1, 0}) * Eigen::Translation3d(-0.3, 0, 0), Affine3d(Eigen::Translation3d(0, 0.4, 0.1)),
                                   Affine3d::Identity()}, 20);
    const Points moved = session.positions();
    const auto values = session.set_fields();
    const auto controls = session.control_offsets();
    const int k = session.sets().sets();
    double worst = 0;
    std::vector<ControlSets::Entry> entries;
    for (int v = 0; v < mesh.vertex_count(); ++v) {
        std::vector<double> fields;
        double sum = 0;
        for (int f = 0; f < k; ++f) {
            fields.push_back(std::lround(65535 * values[static_cast<std::size_t>(v * k + f)]) / 65535.0); // as a shader may keep them
            sum += fields.back();
        }
        CHECK(std::abs(sum - 1) <= k * 0.51 / 65535);
        session.sets().entries_at(fields, entries);
        const Vector3d x = mesh.points.row(v);
        Vector3d there = x;
        for (const auto& e : entries)
            for (int r = 0; r < 3; ++r) {
                const double* row = controls.data() + 12 * e.control + 4 * r;
                there[r] += e.weight * (row[0] * x[0] + row[1] * x[1] + row[2] * x[2] + row[3]);
            }
        worst = std::max(worst, (there - moved.row(v).transpose()).norm());
    }
    CHECK(worst < 1e-4 * diagonal(mesh.points));

    const Points normals = session.blended_normals(vertex_normals(prepared.working.mesh)), truth = vertex_normals({moved, mesh.triangles});
    double degrees = 0;
    for (int v = 0; v < mesh.vertex_count(); ++v) degrees += std::acos(std::clamp(normals.row(v).dot(truth.row(v)), -1.0, 1.0)) * 57.29578;
    degrees /= mesh.vertex_count();
    MESSAGE("normals of the blend are off by " << degrees << " degrees in the mean");
    CHECK(degrees < 0.5);
    // The gradient handed out is the field's difference along an edge.
    const auto gradients = session.set_gradients();
    const Eigen::VectorXf field = session.field(1);
    double error = 0, size = 0;
    for (const Edge& e : edges(mesh)) {
        const Eigen::RowVector3d along = mesh.points.row(e.b) - mesh.points.row(e.a);
        double slope = 0;
        for (int r = 0; r < 3; ++r) slope += 0.5 * (gradients[3 * (e.a * k + 1) + r] + gradients[3 * (e.b * k + 1) + r]) * along[r];
        error += std::abs(slope - (field[e.b] - field[e.a]));
        size += std::abs(field[e.b] - field[e.a]);
    }
    CHECK(error < 0.1 * size);
    CHECK(session.rigidity(-1).minCoeff() >= 0);
    CHECK((session.rigidity(-1) - session.rigidity(0)).minCoeff() >= -1e-5);
    CHECK(session.isolines(0, 12).size() == 10);
}

TEST_CASE("settling keeps the handles, and where it does not fit turns the details instead") {
    const TriangleMesh mesh = shapes::bumpy_sphere(4);
    const auto held = axis_caps(mesh.points, 3);
    const std::vector<Affine3d> targets{Affine3d::Identity(), turn(50, {0, 1, 0}) * Eigen::Translation3d(-0.3, 0, 0), Affine3d(Eigen::Translation3d(0, 0.4, 0.1))};
    const Prepared prepared(mesh);
    for (const int limit : {200000, 10}) {
        IsolineOptions options;
        options.settle_limit = limit;
        IsolineSession session = prepared.session(held, options);
        CHECK(session.settles_fully() == (limit > 10));
        while (session.settle_step()) {
        }
        (void)session.drag(targets, 20);
        const Points reduced = session.positions(), settled = session.settled();
        CHECK(gap(reduced, settled) < 0.05 * diagonal(mesh.points));
        CHECK(gap(reduced, settled) > 1e-6);
        for (std::size_t h = 0; h < held.size(); ++h)
            for (const int v : held[h].vertices) CHECK((settled.row(v).transpose() - targets[h] * Vector3d(mesh.points.row(v))).norm() < 1e-12);
    }
}

TEST_CASE("cancelled at any slice, what is left can be thrown away") {
    const Prepared prepared(shapes::bumpy_sphere(4));
    const auto held = axis_caps(prepared.working.source, 4);
    for (int slices = 0; slices < 12; ++slices) {
        IsolineSession session(prepared.model, handles::everything(prepared.working.source), held);
        double last = 0;
        for (int k = 0; k < slices; ++k) {
            (void)session.step();
            CHECK(session.fraction() >= last);
            last = session.fraction();
        }
    }
}
