#include "lissom/match/skin_set.h"

#include "lissom/match/fit_surface.h"
#include "lissom/mesh/operators.h"
#include "lissom/mesh/topology.h"
#include "shapes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace lissom;
using Eigen::RowVector3d;

namespace {

/// A mesh and itself, bent by ever more.
SkinSet set_of(const TriangleMesh& mesh, int count = 2, bool bent = true) {
    SkinSet skins{mesh.triangles, std::vector<Points>(static_cast<std::size_t>(count), mesh.points), std::vector<int>(static_cast<std::size_t>(mesh.vertex_count()), -1)};
    if (bent)
        for (int k = 1; k < count; ++k)
            for (int v = 0; v < mesh.vertex_count(); ++v)
                skins.points[static_cast<std::size_t>(k)].row(v) += 0.15 * k * RowVector3d(std::sin((2 + k) * mesh.points(v, 1)), std::cos(2 * mesh.points(v, 2)), 0.5 * (k - 1));
    return skins;
}
void relax(SkinSet& skins) {
    for (int k = 0; k < skins.count(); ++k) skins.points[static_cast<std::size_t>(k)] = relaxed_tangentially(skins, k);
}
double longest(const SkinSet& skins) {
    double most = 0;
    for (const Edge& e : edges(skins.mesh(0)))
        for (const Points& p : skins.points) most = std::max(most, (p.row(e.a) - p.row(e.b)).norm());
    return most;
}
int too_short(const SkinSet& skins, double L) {
    int count = 0;
    for (const Edge& e : edges(skins.mesh(0)))
        count += std::all_of(skins.points.begin(), skins.points.end(), [&](const Points& p) { return (p.row(e.a) - p.row(e.b)).norm() < 0.5 * L; });
    return count;
}
double largest_angle(const TriangleMesh& mesh, int percent) { // of all triangles the largest angle that so many stay below
    std::vector<double> angles;
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        double least = 1;
        for (int k = 0; k < 3; ++k) {
            const RowVector3d p = mesh.points.row(mesh.triangles(t, k)), a = mesh.points.row(mesh.triangles(t, (k + 1) % 3)) - p, b = mesh.points.row(mesh.triangles(t, (k + 2) % 3)) - p;
            least = std::min(least, a.dot(b) / (a.norm() * b.norm()));
        }
        angles.push_back(std::acos(std::clamp(least, -1.0, 1.0)) * 180 / M_PI);
    }
    std::sort(angles.begin(), angles.end());
    return angles[angles.size() * static_cast<std::size_t>(percent) / 100];
}
/// The same kind of surface as before: closed or open alike, of one piece, of the same genus, every edge of two triangles that agree.
void check_same_surface(const TriangleMesh& before, const TriangleMesh& after) {
    CHECK(euler_characteristic(after) == euler_characteristic(before));
    CHECK(boundary_loops(after).size() == boundary_loops(before).size());
    CHECK(non_manifold_vertices(after).empty());
    CHECK(components(vertex_rings(after)).count == components(vertex_rings(before)).count);
    for (const Edge& e : edges(after)) CHECK((e.forward <= 1 && e.backward <= 1));
    for (int t = 0; t < after.triangle_count(); ++t) CHECK((after.triangles(t, 0) != after.triangles(t, 1) && after.triangles(t, 1) != after.triangles(t, 2) && after.triangles(t, 2) != after.triangles(t, 0)));
}

} // namespace

TEST_CASE("passes lead to edges between half and one and a half of the length asked for, on both skins, whatever the surface") {
    for (const TriangleMesh& mesh : {shapes::bumpy_sphere(4), shapes::torus(), shapes::uv_sphere(30, 60), shapes::bumpy_sheet(30, 30), shapes::double_torus(4)})
        for (const double factor : {0.6, 1.0, 2.2}) {
            CAPTURE(factor);
            SkinSet skins = set_of(mesh);
            const double L = factor * mean_edge_length(mesh);
            ConnectivityChange last;
            for (int pass = 0; pass < 25; ++pass) {
                last = improve_connectivity(skins, {L});
                relax(skins);
            }
            for (const Points& p : skins.points) CHECK(p.rows() == skins.vertex_count());
            CHECK(std::ssize(skins.marker) == skins.vertex_count());
            CHECK(skins.points[0].allFinite());
            CHECK(longest(skins) < 1.8 * L);
            CHECK(too_short(skins, L) < 0.02 * skins.vertex_count());
            check_same_surface(mesh, skins.mesh(0));
            CHECK(largest_angle(skins.mesh(0), 99) < 140);
            CHECK(largest_angle(skins.mesh(1), 99) < 140);
        }
}

TEST_CASE("five skins are edited as two are: splits for the longest of all, collapses only where all are short") {
    const TriangleMesh mesh = shapes::bumpy_sphere(3);
    SkinSet skins = set_of(mesh, 5);
    const double L = 1.3 * mean_edge_length(mesh);
    for (int pass = 0; pass < 25; ++pass) {
        (void)improve_connectivity(skins, {L});
        relax(skins);
    }
    REQUIRE(skins.count() == 5);
    for (const Points& p : skins.points) CHECK(p.rows() == skins.vertex_count());
    CHECK(longest(skins) < 1.8 * L);
    CHECK(too_short(skins, L) < 0.02 * skins.vertex_count());
    check_same_surface(mesh, skins.mesh(4));
    // What is asked of one edge: long on the last skin alone it is split on all, short on the first alone it stays.
    SkinSet two = set_of(shapes::icosphere(0), 3, false);
    const double edge = (two.points[0].row(two.triangles(0, 0)) - two.points[0].row(two.triangles(0, 1))).norm();
    two.points[2] *= 4;
    CHECK(improve_connectivity(two, {edge, 1}).splits > 0);
    SkinSet small = set_of(shapes::icosphere(0), 3, false);
    small.points[0] *= 0.1;
    CHECK(improve_connectivity(small, {edge, 1}).collapses == 0);
    for (Points& p : small.points) p *= 0.1;
    CHECK(improve_connectivity(small, {edge, 1}).collapses > 0);
}

TEST_CASE("no triangle is turned over on either skin by a pass") {
    SkinSet skins = set_of(shapes::bumpy_sphere(4));
    const FitSurface source(skins.mesh(0)), target(skins.mesh(1));
    (void)improve_connectivity(skins, {1.4 * mean_edge_length(skins.mesh(0)), 1});
    const auto check = [](const TriangleMesh& mesh, const FitSurface& before) {
        const Points normals = triangle_normals(mesh);
        for (int t = 0; t < mesh.triangle_count(); ++t) {
            Eigen::Vector3d middle = Eigen::Vector3d::Zero();
            for (const int v : mesh.triangles.row(t)) middle += mesh.points.row(v).transpose() / 3;
            CHECK(before.nearest(middle, normals.row(t), -1, INFINITY).cosine > 0.3);
        }
    };
    check(skins.mesh(0), source);
    check(skins.mesh(1), target);
}

TEST_CASE("markers are neither moved nor taken away, and keep their numbers") {
    SkinSet skins = set_of(shapes::bumpy_sphere(4));
    std::vector<std::pair<RowVector3d, RowVector3d>> places;
    for (int m = 0; m < 40; ++m) {
        skins.marker[61 * m] = m;
        places.emplace_back(skins.points[0].row(61 * m), skins.points[1].row(61 * m));
    }
    const double L = 3 * mean_edge_length(skins.mesh(0));
    for (int pass = 0; pass < 12; ++pass) {
        (void)improve_connectivity(skins, {L});
        relax(skins);
    }
    int found = 0;
    for (int v = 0; v < skins.vertex_count(); ++v)
        if (const int m = skins.marker[v]; m >= 0) {
            ++found;
            CHECK(skins.points[0].row(v) == places[static_cast<std::size_t>(m)].first);
            CHECK(skins.points[1].row(v) == places[static_cast<std::size_t>(m)].second);
        }
    CHECK(found == 40);
    check_same_surface(shapes::bumpy_sphere(4), skins.mesh(0));
}

TEST_CASE("borders stay where they are: a flat sheet keeps its area") {
    SkinSet skins = set_of(shapes::sheet(20, 20), 2, false);
    const double area = triangle_areas(skins.mesh(0)).sum();
    for (int pass = 0; pass < 10; ++pass) {
        (void)improve_connectivity(skins, {1.7 * mean_edge_length(shapes::sheet(20, 20))});
        relax(skins);
    }
    CHECK(triangle_areas(skins.mesh(0)).sum() > 0.97 * area); // corners are rounded
    CHECK(skins.points[0] == skins.points[1]);
    CHECK(skins.points[0].col(2).isZero());
}

TEST_CASE("splits end at the vertices allowed, and nothing happens where nothing is to be done") {
    SkinSet skins = set_of(shapes::icosphere(2), 2, false);
    for (int pass = 0; pass < 20; ++pass) (void)improve_connectivity(skins, {0.01, 1, 1000});
    CHECK(skins.vertex_count() == 1000);
    SkinSet even = set_of(shapes::icosphere(3), 2, false);
    CHECK_FALSE(improve_connectivity(even, {mean_edge_length(shapes::icosphere(3))}).any());
    CHECK(even.triangles == shapes::icosphere(3).triangles);
    SkinSet empty;
    CHECK_FALSE(improve_connectivity(empty, {}).any());
}

TEST_CASE("edges of three triangles, bow ties, needles and repeated triangles are survived") {
    for (const TriangleMesh& mesh : {shapes::three_sheets(), shapes::bow_tie(), shapes::with_needles(shapes::bumpy_sphere(2)), shapes::with_duplicate_faces(shapes::icosphere(2)),
                                     shapes::moebius(), shapes::with_zero_area_faces(shapes::torus()), shapes::soup(shapes::icosphere(1))}) {
        SkinSet skins = set_of(mesh);
        for (int pass = 0; pass < 5; ++pass) {
            (void)improve_connectivity(skins, {1.5 * mean_edge_length(mesh)});
            relax(skins);
        }
        CHECK(skins.points[0].allFinite());
        CHECK(skins.points[1].allFinite());
        CHECK((skins.triangles.size() == 0 || skins.triangles.maxCoeff() < skins.vertex_count()));
    }
}

TEST_CASE("the same is done in any unit, turned any way, and every time") {
    const TriangleMesh mesh = shapes::bumpy_sphere(3);
    const Eigen::Affine3d map = Eigen::Translation3d(1e3, 2e3, 0) * Eigen::AngleAxisd(1, Eigen::Vector3d(1, 2, 3).normalized()) * Eigen::Scaling(1e3);
    SkinSet here = set_of(mesh), there = here, again = here;
    there.points[0] = shapes::moved(here.mesh(0), map).points;
    there.points[1] = shapes::moved(here.mesh(1), map).points;
    const double L = 1.9 * mean_edge_length(mesh);
    for (int pass = 0; pass < 4; ++pass) {
        for (SkinSet* skins : {&here, &again}) {
            (void)improve_connectivity(*skins, {L});
            relax(*skins);
        }
        (void)improve_connectivity(there, {1e3 * L});
        relax(there);
    }
    CHECK(here.triangles == again.triangles);
    CHECK(here.points[0] == again.points[0]);
    REQUIRE(here.triangles == there.triangles);
    CHECK((shapes::moved(here.mesh(1), map).points - there.points[1]).rowwise().norm().maxCoeff() < 1e-8 * 1e3);
}
