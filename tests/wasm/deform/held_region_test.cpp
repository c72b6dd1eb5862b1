#include "lissom/deform/held_region.h"

#include "handles.h"
#include "refusal.h"

#include <doctest/doctest.h>

#include <algorithm>

using namespace handles;
using namespace lissom;

namespace {

DeformHandle point(int v) { return {.is_point = true, .vertices = {v}}; }
DeformHandle region_of(std::vector<int> vertices) { return {.is_point = false, .vertices = std::move(vertices)}; }

struct Cut {
    WorkingMesh working;
    Roles roles;
    std::vector<Finding> warnings;
    HeldRegion region;

    Cut(const TriangleMesh& mesh, const std::vector<int>& roi, const std::vector<DeformHandle>& held)
        : working(shapes::working(mesh)), roles(assign_roles(working, roi, held)),
          region(hold_region(working, roles, static_cast<int>(held.size()), warnings)) {}
};

} // namespace

TEST_CASE("what is neither in the region nor in a handle is fixed, and a handle wins over the region") {
    const TriangleMesh mesh = shapes::torus(20, 10);
    const WorkingMesh working = shapes::working(mesh);
    const Roles roles = assign_roles(working, std::vector<int>{4, 5, 6, 7}, std::vector{region_of({6, 30}), point(7)});
    CHECK(roles.role[4] == Role::free);
    CHECK(roles.role[6] == Role::region);
    CHECK(roles.role[30] == Role::region);
    CHECK(roles.role[7] == Role::point);
    CHECK(roles.handle[6] == 0);
    CHECK(roles.handle[7] == 1);
    CHECK(std::count(roles.role.begin(), roles.role.end(), Role::fixed) == mesh.vertex_count() - 5);
    CHECK(std::count(roles.handle.begin(), roles.handle.end(), -1) == mesh.vertex_count() - 3);
}

TEST_CASE("vertices that welding joins have one role, and vertices in no triangle have none") {
    const TriangleMesh sphere = shapes::bumpy_sphere(1), soup = shapes::soup(sphere);
    const Roles roles = assign_roles(shapes::working(soup), std::vector<int>{0}, std::vector{point(1)});
    CHECK(std::count(roles.role.begin(), roles.role.end(), Role::free) == 1);
    CHECK(static_cast<int>(roles.role.size()) == sphere.vertex_count());
    const TriangleMesh loose = shapes::with_unused_vertices(sphere, 3);
    const WorkingMesh working = shapes::working(loose);
    std::vector<int> unused;
    for (int v = 0; v < loose.vertex_count(); ++v)
        if (working.working_of_source[v] < 0) unused.push_back(v);
    REQUIRE(unused.size() == 3);
    const Roles of_loose = assign_roles(working, unused, std::vector{region_of(unused)});
    CHECK(std::count(of_loose.role.begin(), of_loose.role.end(), Role::fixed) == sphere.vertex_count());
}

TEST_CASE("slots number the free vertices first, then those of handles, and nothing that is fixed") {
    const TriangleMesh mesh = shapes::bumpy_sheet(12, 9);
    std::vector<int> roi;
    for (int v = 40; v < 90; ++v) roi.push_back(v);
    const HeldRegion region = Cut(mesh, roi, {region_of({44, 45, 46}), point(60)}).region;
    CHECK(region.unknowns == 50 - 4);
    CHECK(region.slots() == 50);
    CHECK(region.columns() == region.unknowns + 4 * 2);
    for (int s = 0; s < region.slots(); ++s) {
        const int v = region.vertex_of_slot[s];
        CHECK(region.slot[v] == s);
        CHECK((region.role[v] == Role::free) == (s < region.unknowns));
        CHECK((region.handle[v] >= 0) == (s >= region.unknowns));
    }
    CHECK(std::count(region.slot.begin(), region.slot.end(), -1) == region.mesh.vertex_count() - 50);
}

TEST_CASE("what lies more than two rings from a free vertex is not looked at, what lies nearer is whole") {
    const TriangleMesh mesh = shapes::torus(60, 30);
    const Cut cut(mesh, {100, 101, 102}, {point(103)});
    const HeldRegion& region = cut.region;
    CHECK(region.unknowns == 3);
    CHECK(region.slots() == 4);
    CHECK(region.mesh.vertex_count() < 50);
    const VertexRings all = vertex_rings(cut.working.mesh);
    const auto is_whole = [&](int v) { return region.rings[v].size() == all[region.working[v]].size(); };
    for (int s = 0; s < region.unknowns; ++s) {
        const int v = region.vertex_of_slot[s];
        CHECK(is_whole(v));
        for (const int w : region.rings[v]) CHECK(is_whole(w));
    }
}

TEST_CASE("pieces are what hangs together, each with what holds it") {
    const TriangleMesh mesh = shapes::two_spheres(2);
    const auto ends = two_ends(mesh.points);
    const HeldRegion region = Cut(mesh, everything(mesh.points), ends).region;
    REQUIRE(region.pieces.size() == 2);
    int free = 0;
    for (const HeldPiece& piece : region.pieces) {
        CHECK(piece.has_frame());
        CHECK(!piece.touches_fixed);
        REQUIRE(piece.region_handles.size() == 1);
        REQUIRE(piece.rim_sizes.size() == 1);
        const int h = piece.region_handles[0];
        int rim = 0;
        for (int v = 0; v < region.mesh.vertex_count(); ++v)
            if (region.handle[v] == h)
                rim += std::any_of(region.rings[v].begin(), region.rings[v].end(), [&](int w) { return region.role[w] == Role::free; });
        CHECK(piece.rim_sizes[0] == rim);
        free += piece.free_count;
    }
    CHECK(region.pieces[0].region_handles != region.pieces[1].region_handles);
    CHECK(free == region.unknowns);
}

TEST_CASE("only what points hold, and so few that its turn is open, needs a pose") {
    const TriangleMesh mesh = shapes::icosphere(2);
    const std::vector<int> all = everything(mesh.points);
    const auto at = [&](const Vector3d& way) {
        int best = 0;
        (mesh.points * way).maxCoeff(&best);
        return best;
    };
    const int a = at({1, 0.1, 0}), b = at({-1, 0, 0.1}), c = at({0, 1, 0.2}), d = at({0.1, 0, 1}), e = at({0, -1, 0.2});
    CHECK(Cut(mesh, all, {point(a)}).region.poses == std::vector<int>{0});
    CHECK(Cut(mesh, all, {point(a), point(b), point(c)}).region.poses == std::vector<int>{0});
    CHECK(Cut(mesh, all, {point(a), point(b), point(c), point(d), point(e)}).region.poses.empty());
    CHECK(Cut(mesh, all, {region_of({a}), point(b)}).region.poses.empty());
    const std::vector<int> some(all.begin(), all.begin() + 40);
    CHECK(Cut(mesh, some, {point(some[5])}).region.poses.empty()); // the rest of the sphere holds it
}

TEST_CASE("a component without a handle is put to rest and named, and with nothing else nothing is free") {
    const TriangleMesh ball = shapes::icosphere(1), mesh = shapes::two_spheres(1);
    const Cut one(mesh, everything(mesh.points), {region_of({0, 1})});
    REQUIRE(!one.warnings.empty());
    CHECK(one.warnings[0].code == "component-without-handle");
    CHECK(one.warnings[0].count == 1);
    REQUIRE(one.warnings[0].examples.size() == 1);
    CHECK(one.warnings[0].examples[0] >= ball.vertex_count());
    CHECK(one.region.unknowns == ball.vertex_count() - 2);
    const Cut none(mesh, {}, {region_of({0, 1})});
    REQUIRE(none.warnings.size() == 1);
    CHECK(none.warnings[0].code == "nothing-free");
    CHECK(none.region.unknowns == 0);
}

TEST_CASE("requests that make no sense are refused by name") {
    const WorkingMesh working = shapes::working(shapes::torus(20, 10));
    const auto code = [&](const std::vector<int>& roi, const std::vector<DeformHandle>& held) {
        return refusal([&] { (void)assign_roles(working, roi, held); });
    };
    CHECK(code({1, 2}, {point(3)}) == "none");
    CHECK(code({1, 2}, {}) == "no-handle");
    CHECK(code({1, 2}, {region_of({})}) == "empty-handle");
    CHECK(code({200}, {point(3)}) == "vertex-out-of-range");
    CHECK(code({1, 2}, {point(-1)}) == "vertex-out-of-range");
    CHECK(code({1, 2}, {point(3), region_of({4, 3})}) == "handle-overlap");
    CHECK(code({1, 2}, {{.is_point = true, .vertices = {1, 2}}}) == "point-handle-size");
}
