#include "lissom/isoline/pose_transfer.h"

#include "figures.h"
#include "refusal.h"

#include "lissom/isoline/triangle_frames.h"
#include "lissom/mesh/operators.h"
#include "lissom/solve/sparse_cholesky.h"

#include <doctest/doctest.h>

#include <limits>

using namespace lissom;
using namespace sessions;
using Eigen::Affine3d;
using Eigen::Vector3d;
using Lists = std::vector<std::vector<int>>;

namespace {

Lists lists(const std::vector<DeformHandle>& held) {
    Lists all;
    for (const DeformHandle& handle : held) all.push_back(handle.vertices);
    return all;
}

/// One pose of one model on another.
Points given(const TriangleMesh& source, const Lists& of_source, const Points& pose, const TriangleMesh& target, const Lists& of_target,
             const TransferOptions& options = {}) {
    const WorkingMesh a = shapes::working(source), b = shapes::working(target);
    PoseTransfer transfer(a, of_source, b, of_target);
    while (transfer.step()) {
    }
    CHECK(transfer.fraction() == 1);
    return transfer.transfer({&pose, 1}, options).front();
}

Points posed(const TriangleMesh& mesh, const std::vector<DeformHandle>& held) {
    std::vector<Affine3d> targets{Affine3d::Identity()};
    for (std::size_t h = 1; h < held.size(); ++h)
        targets.push_back(handles::turn(30.0 + 10.0 * static_cast<double>(h), {1, static_cast<double>(h), -1}) * Eigen::Translation3d(0.05 * static_cast<double>(h), 0.1, 0));
    return drag(mesh, held, targets).positions;
}

} // namespace

TEST_CASE("a model that is given its own pose has it, one at rest stays at rest") {
    const TriangleMesh mesh = shapes::bumpy_sphere(4);
    const auto held = axis_caps(mesh.points, 4);
    const Points pose = posed(mesh, held);
    CHECK(handles::gap(given(mesh, lists(held), pose, mesh, lists(held)), pose) < 1e-6 * diagonal(mesh.points));
    CHECK(handles::gap(given(mesh, lists(held), mesh.points, mesh, lists(held)), mesh.points) < 1e-12);
    const TriangleMesh other = shapes::bumpy_sphere(3);
    CHECK(handles::gap(given(mesh, lists(held), mesh.points, other, lists(axis_caps(other.points, 4))), other.points) < 1e-9);
}

TEST_CASE("a rigid motion is given as it is, its way in shares of the diagonal") {
    const TriangleMesh source = shapes::bumpy_sphere(3);
    TriangleMesh target = shapes::icosphere(4);
    target.points *= 5;
    const Affine3d motion = handles::turn(80, {1, 2, 0});
    const Points result = given(source, lists(axis_caps(source.points, 4)), handles::images(motion, source.points), target, lists(axis_caps(target.points, 4)));
    Points there = handles::images(motion, target.points);
    there.rowwise() += (result - there).colwise().mean(); // turned about another middle
    CHECK(handles::gap(result, there) < 1e-9 * diagonal(target.points));
    const Points away = source.points.rowwise() + Eigen::RowVector3d(1, 2, 3);
    const Points shifted = given(source, lists(axis_caps(source.points, 4)), away, target, lists(axis_caps(target.points, 4)));
    const double scale = diagonal(target.points) / diagonal(source.points);
    CHECK(handles::gap(shifted, target.points.rowwise() + scale * Eigen::RowVector3d(1, 2, 3)) < 1e-9 * diagonal(target.points));
}

TEST_CASE("strength runs from rest to the whole pose and beyond; several poses are each what they are alone") {
    const TriangleMesh source = shapes::bumpy_sphere(4), target = shapes::icosphere(4);
    const auto held = axis_caps(source.points, 3), onto = axis_caps(target.points, 3);
    const Points pose = posed(source, held), half_way = 0.5 * (pose + source.points);
    CHECK(handles::gap(given(source, lists(held), pose, target, lists(onto), {.strength = 0}), target.points) < 1e-12);
    const auto moved = [&](double strength) { return (given(source, lists(held), pose, target, lists(onto), {.strength = strength}) - target.points).norm(); };
    CHECK(moved(0.5) < moved(1));
    CHECK(moved(1) < moved(1.3));
    const WorkingMesh a = shapes::working(source), b = shapes::working(target);
    PoseTransfer transfer(a, lists(held), b, lists(onto));
    while (transfer.step()) {
    }
    const auto both = transfer.transfer(std::vector{pose, half_way});
    CHECK(handles::gap(both[0], given(source, lists(held), pose, target, lists(onto))) < 1e-10);
    CHECK(handles::gap(both[1], given(source, lists(held), half_way, target, lists(onto))) < 1e-10);
}

TEST_CASE("stretch is kept where it is asked for, and only there") {
    const TriangleMesh source = shapes::box(8, 40, 8, {1, 6, 1}), target = shapes::box(10, 60, 10, {1, 6, 1.2});
    const auto held = handles::two_ends(source.points, 0.05), onto = handles::two_ends(target.points, 0.05);
    Points pose = source.points;
    pose.col(1) *= 1.5;
    const auto length = [](const Points& p) { return p.col(1).maxCoeff() - p.col(1).minCoeff(); };
    const double kept = length(given(source, lists(held), pose, target, lists(onto), {.keep_stretch = true}));
    CHECK(kept == doctest::Approx(9).epsilon(0.02));
    CHECK(length(given(source, lists(held), pose, target, lists(onto))) < 8.8);
}

TEST_CASE("poses of people fit other people") {
    for (const auto& [rest, pose_of, onto] : figures::poses_of_people()) {
        const TriangleMesh source = figures::shared(rest), pose = figures::shared(pose_of), target = figures::shared(onto);
        if (source.vertex_count() == 0 || pose.vertex_count() == 0 || target.vertex_count() == 0) return;
        auto held = figures::of_person(source, rest, true), over = figures::of_person(target, onto, true);
        for (std::size_t h = 6; h < held.size(); ++h) { // elbows and knees as balls
            held[h].vertices = figures::ball(source.points, source.points.row(held[h].vertices[0]), 0.045 * (source.points.col(1).maxCoeff() - source.points.col(1).minCoeff()));
            over[h].vertices = figures::ball(target.points, target.points.row(over[h].vertices[0]), 0.045 * (target.points.col(1).maxCoeff() - target.points.col(1).minCoeff()));
        }
        const Points result = given(source, lists(held), pose.points, target, lists(over));

        // Both bodies have one connectivity: the truth is each triangle's own change, which the transfer was not told.
        const SparseMatrix L = cotangent_laplacian(target);
        const auto gradients = triangle_gradients(source, pose.points);
        Points right = Points::Zero(target.vertex_count(), 3);
        for (int t = 0; t < target.triangle_count(); ++t)
            for (int k = 0; k < 3; ++k) {
                const int i = target.triangles(t, (k + 1) % 3), j = target.triangles(t, (k + 2) % 3), at = target.triangles(t, k);
                const Vector3d u = target.points.row(i) - target.points.row(at), w = target.points.row(j) - target.points.row(at);
                const Eigen::RowVector3d along = 0.5 * u.dot(w) / u.cross(w).norm() * (target.points.row(i) - target.points.row(j)) * gradients[t].transpose();
                right.row(i) += along;
                right.row(j) -= along;
            }
        SparseMatrix A = -L;
        A.coeffRef(0, 0) += 1;
        SparseCholesky solver(A, &target.points);
        solver.factorize(A);
        Columns truth = right;
        solver.solve(truth);
        // Up to where it stands: the truth knows directions only.
        truth.rowwise() += (result - Points(truth)).colwise().mean();
        const double mean = 100 * (result - Points(truth)).rowwise().norm().mean(), before = 100 * (target.points - Points(truth)).rowwise().norm().mean();
        double feet = 0;
        for (const std::size_t h : {2U, 3U}) {
            Eigen::RowVector3d off = Eigen::RowVector3d::Zero();
            for (const int v : over[h].vertices) off += (result.row(v) - Points(truth).row(v)) / static_cast<double>(over[h].vertices.size());
            feet = std::max(feet, 100 * off.norm());
        }
        MESSAGE(pose_of << " on " << onto << ": mean " << mean << " cm (at rest " << before << "), feet " << feet << " cm, volume " << handles::volume_ratio(target, result)
                        << ", stretch " << figures::stretch_rms(target, result));
        CHECK(mean < 3.5);
        CHECK(feet < 1.5);
    }
}

TEST_CASE("an octopus gives its pose to a squid, which keeps its volume") {
    const TriangleMesh source = figures::shared("creatures/octopus"), target = figures::shared("creatures/squid");
    if (source.vertex_count() == 0 || target.vertex_count() == 0) return;
    const auto held = [](const TriangleMesh& mesh, const std::string& name) {
        const auto at = figures::joints(name);
        std::vector<DeformHandle> all{{.is_point = false, .vertices = figures::ball(mesh.points, at.at("mantle1").at, at.at("mantle1").radius * 1.5)}};
        for (int arm = 0; arm < 8; ++arm) all.push_back({.is_point = false, .vertices = figures::ball(mesh.points, at.at("arm" + std::to_string(arm) + "_5").at, 0.12)});
        return all;
    };
    const auto from = held(source, "creatures/octopus"), onto = held(target, "creatures/squid");
    const auto at = figures::joints("creatures/octopus");
    std::vector<Affine3d> targets{Affine3d::Identity()};
    for (int arm = 0; arm < 8; ++arm) {
        const std::string name = "arm" + std::to_string(arm) + "_";
        const Vector3d root = at.at(name + "1").at, out = (at.at(name + "5").at - root).normalized();
        targets.push_back(handles::turn(arm % 2 ? 50 : -30, Vector3d(-out[2], 0, out[0]), root));
    }
    const Points pose = drag(source, from, targets).positions;
    for (const bool keep : {false, true}) {
        const Points result = given(source, lists(from), pose, target, lists(onto), {.keep_stretch = keep});
        MESSAGE("octopus to squid" << std::string(keep ? ", stretch kept" : "") << ": volume " << handles::volume_ratio(target, result) << ", stretch " << figures::stretch_rms(target, result));
        if (!keep) CHECK(handles::volume_ratio(target, result) > 0.95);
    }
}

TEST_CASE("requests that make no sense are refused, and say on which model") {
    const WorkingMesh a = shapes::working(shapes::bumpy_sphere(2)), b = shapes::working(shapes::torus());
    const auto code = [&](const Lists& left, const Lists& right) { return refusal([&] { const PoseTransfer transfer(a, left, b, right); }); };
    CHECK(code({{1}, {2}}, {{1}}) == "handle-count");
    CHECK(code({}, {}) == "no-handle");
    CHECK(code({{1}, {}}, {{1}, {2}}) == "empty-handle");
    CHECK(code({{1}, {2}}, {{1}, {100000}}) == "vertex-out-of-range");
    CHECK(code({{1}, {1}}, {{1}, {2}}) == "handle-overlap");
    try {
        const PoseTransfer transfer(a, Lists{{1}, {2}}, b, Lists{{1}, {}});
    } catch (const InvalidInput& error) {
        CHECK(std::string(error.what()).starts_with("On the target: "));
    }
    PoseTransfer transfer(a, Lists{{1}, {2}}, b, Lists{{1}, {2}});
    while (transfer.step()) {
    }
    const auto refused = [&](Points pose, TransferOptions options = {}) { return refusal([&] { (void)transfer.transfer({&pose, 1}, options); }); };
    CHECK(refused(Points::Zero(3, 3)) == "wrong-size");
    Points broken = a.source;
    broken(5, 1) = std::numeric_limits<double>::quiet_NaN();
    CHECK(refused(broken) == "non-finite-position");
    CHECK(refused(a.source, {.strength = std::numeric_limits<double>::infinity()}) == "bad-option");
}

TEST_CASE("a piece of the target without a handle stays, and is named") {
    const TriangleMesh source = shapes::bumpy_sphere(3), target = shapes::with_extra_shell(shapes::bumpy_sphere(3));
    const auto held = axis_caps(source.points, 3);
    const WorkingMesh a = shapes::working(source), b = shapes::working(target);
    PoseTransfer transfer(a, lists(held), b, lists(held));
    while (transfer.step()) {
    }
    REQUIRE(transfer.warnings().size() == 1);
    CHECK(transfer.warnings()[0].code == "component-without-handle");
    const Points pose = posed(source, held), result = transfer.transfer({&pose, 1}).front();
    for (int v = source.vertex_count(); v < target.vertex_count(); ++v) CHECK(result.row(v) == target.points.row(v));
}
