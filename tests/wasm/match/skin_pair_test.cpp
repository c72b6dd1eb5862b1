#include "lissom/match/skin_pair.h"

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

/// A mesh and itself, or itself bent.
SkinPair pair_of(const TriangleMesh& mesh, bool bent = true) {
    SkinPair skins{mesh.triangles, mesh.points, mesh.points, std::vector<int>(static_cast<std::size_t>(mesh.vertex_count()), -1)};
    if (bent)
        for (int v = 0; v < mesh.vertex_count(); ++v) skins.target.row(v) += 0.15 * RowVector3d(std::sin(3 * mesh.points(v, 1)), std::cos(2 * mesh.points(v, 2)), 0);
    return skins;
}
double longest(const SkinPair& skins) {
    double most = 0;
    for (const Edge& e : edges(skins.source_mesh()))
        for (const Points* p : {&skins.source, &skins.target}) most = std::max(most, (p->row(e.a) - p->row(e.b)).norm());
    return most;
}
int too_short(const SkinPair& skins, double L) {
    int count = 0;
    for (const Edge& e : edges(skins.source_mesh()))
        count += std::max((skins.source.row(e.a) - skins.source.row(e.b)).norm(), (skins.target.row(e.a) - skins.target.row(e.b)).norm()) < 0.5 * L;
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
            SkinPair skins = pair_of(mesh);
            const double L = factor * mean_edge_length(mesh);
            ConnectivityChange last;
            for (int pass = 0; pass < 25; ++pass) {
                last = improve_connectivity(skins, {L});
                relax_tangentially(skins);
            }
            CHECK(skins.source.rows() == skins.target.rows());
            CHECK(std::ssize(skins.marker) == skins.vertex_count());
            CHECK(skins.source.allFinite());
            CHECK(longest(skins) < 1.8 * L);
            CHECK(too_short(skins, L) < 0.02 * skins.vertex_count());
            check_same_surface(mesh, skins.source_mesh());
            CHECK(largest_angle(skins.source_mesh(), 99) < 140);
            CHECK(largest_angle(skins.target_mesh(), 99) < 140);
        }
}

TEST_CASE("no triangle is turned over on either skin by a pass") {
    SkinPair skins = pair_of(shapes::bumpy_sphere(4));
    const FitSurface source(skins.source_mesh()), target(skins.target_mesh());
    (void)improve_connectivity(skins, {1.4 * mean_edge_length(skins.source_mesh()), 1});
    const auto check = [](const TriangleMesh& mesh, const FitSurface& before) {
        const Points normals = triangle_normals(mesh);
        for (int t = 0; t < mesh.triangle_count(); ++t) {
            Eigen::Vector3d middle = Eigen::Vector3d::Zero();
            for (const int v : mesh.triangles.row(t)) middle += mesh.points.row(v).transpose() / 3;
            CHECK(before.nearest(middle, normals.row(t), -1, INFINITY).cosine > 0.3);
        }
    };
    check(skins.source_mesh(), source);
    check(skins.target_mesh(), target);
}

TEST_CASE("markers are neither moved nor taken away, and keep their numbers") {
    SkinPair skins = pair_of(shapes::bumpy_sphere(4));
    std::vector<std::pair<RowVector3d, RowVector3d>> places;
    for (int m = 0; m < 40; ++m) {
        skins.marker[61 * m] = m;
        places.emplace_back(skins.source.row(61 * m), skins.target.row(61 * m));
    }
    const double L = 3 * mean_edge_length(skins.source_mesh());
    for (int pass = 0; pass < 12; ++pass) {
        (void)improve_connectivity(skins, {L});
        relax_tangentially(skins);
    }
    int found = 0;
    for (int v = 0; v < skins.vertex_count(); ++v)
        if (const int m = skins.marker[v]; m >= 0) {
            ++found;
            CHECK(skins.source.row(v) == places[static_cast<std::size_t>(m)].first);
            CHECK(skins.target.row(v) == places[static_cast<std::size_t>(m)].second);
        }
    CHECK(found == 40);
    check_same_surface(shapes::bumpy_sphere(4), skins.source_mesh());
}

TEST_CASE("borders stay where they are: a flat sheet keeps its area") {
    SkinPair skins = pair_of(shapes::sheet(20, 20), false);
    const double area = triangle_areas(skins.source_mesh()).sum();
    for (int pass = 0; pass < 10; ++pass) {
        (void)improve_connectivity(skins, {1.7 * mean_edge_length(shapes::sheet(20, 20))});
        relax_tangentially(skins);
    }
    CHECK(triangle_areas(skins.source_mesh()).sum() > 0.97 * area); // corners are rounded
    CHECK(skins.source == skins.target);
    CHECK(skins.source.col(2).isZero());
}

TEST_CASE("splits end at the vertices allowed, and nothing happens where nothing is to be done") {
    SkinPair skins = pair_of(shapes::icosphere(2), false);
    for (int pass = 0; pass < 20; ++pass) (void)improve_connectivity(skins, {0.01, 1, 1000});
    CHECK(skins.vertex_count() == 1000);
    SkinPair even = pair_of(shapes::icosphere(3), false);
    CHECK_FALSE(improve_connectivity(even, {mean_edge_length(shapes::icosphere(3))}).any());
    CHECK(even.triangles == shapes::icosphere(3).triangles);
    SkinPair empty;
    CHECK_FALSE(improve_connectivity(empty, {}).any());
}

TEST_CASE("edges of three triangles, bow ties, needles and repeated triangles are survived") {
    for (const TriangleMesh& mesh : {shapes::three_sheets(), shapes::bow_tie(), shapes::with_needles(shapes::bumpy_sphere(2)), shapes::with_duplicate_faces(shapes::icosphere(2)),
                                     shapes::moebius(), shapes::with_zero_area_faces(shapes::torus()), shapes::soup(shapes::icosphere(1))}) {
        SkinPair skins = pair_of(mesh);
        for (int pass = 0; pass < 5; ++pass) {
            (void)improve_connectivity(skins, {1.5 * mean_edge_length(mesh)});
            relax_tangentially(skins);
        }
        CHECK(skins.source.allFinite());
        CHECK(skins.target.allFinite());
        CHECK((skins.triangles.size() == 0 || skins.triangles.maxCoeff() < skins.vertex_count()));
    }
}

TEST_CASE("the same is done in any unit, turned any way, and every time") {
    const TriangleMesh mesh = shapes::bumpy_sphere(3);
    const Eigen::Affine3d map = Eigen::Translation3d(1e3, 2e3, 0) * Eigen::AngleAxisd(1, Eigen::Vector3d(1, 2, 3).normalized()) * Eigen::Scaling(1e3);
    SkinPair here = pair_of(mesh), there = here, again = here;
    there.source = shapes::moved(here.source_mesh(), map).points;
    there.target = shapes::moved(here.target_mesh(), map).points;
    const double L = 1.9 * mean_edge_length(mesh);
    for (int pass = 0; pass < 4; ++pass) {
        for (SkinPair* skins : {&here, &again}) {
            (void)improve_connectivity(*skins, {L});
            relax_tangentially(*skins);
        }
        (void)improve_connectivity(there, {1e3 * L});
        relax_tangentially(there);
    }
    CHECK(here.triangles == again.triangles);
    CHECK(here.source == again.source);
    REQUIRE(here.triangles == there.triangles);
    CHECK((shapes::moved(here.target_mesh(), map).points - there.target).rowwise().norm().maxCoeff() < 1e-8 * 1e3);
}
