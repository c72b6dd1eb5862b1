#include "lissom/mesh/working_mesh.h"

#include "lissom/mesh/operators.h"
#include "lissom/mesh/topology.h"
#include "refusal.h"
#include "shapes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

using namespace lissom;

namespace {

const Finding* finding(const WorkingMesh& working, const std::string& code) {
    const auto at = std::find_if(working.findings.begin(), working.findings.end(),
                                 [&](const Finding& f) { return f.code == code; });
    return at == working.findings.end() ? nullptr : &*at;
}

int found(const WorkingMesh& working, const std::string& code) {
    const Finding* f = finding(working, code);
    return f ? f->count : 0;
}

std::string code_of(const PolygonMesh& source) {
    return refusal([&] { (void)make_working_mesh(source); });
}

/// What every solver relies on.
void check_usable(const WorkingMesh& working, const PolygonMesh& source) {
    const int n = working.mesh.vertex_count();
    REQUIRE(working.mesh.triangle_count() > 0);
    CHECK(working.mesh.points.allFinite());
    CHECK(diagonal(working.mesh.points) <= 1 + 1e-5);
    CHECK(working.mesh.triangles.minCoeff() >= 0);
    CHECK(working.mesh.triangles.maxCoeff() < n);
    CHECK(std::isfinite(cotangent_laplacian(working.mesh).norm()));
    std::vector<bool> used(n, false);
    for (int t = 0; t < working.mesh.triangle_count(); ++t) {
        const auto c = working.mesh.triangles.row(t);
        CHECK((c[0] != c[1] && c[1] != c[2] && c[2] != c[0]));
        for (const int v : c)
            used[v] = true;
    }
    CHECK(std::count(used.begin(), used.end(), false) == 0);
    REQUIRE(static_cast<int>(working.working_of_source.size()) == source.vertex_count());
    REQUIRE(static_cast<int>(working.source_of_working.size()) == n);
    for (int w = 0; w < n; ++w)
        CHECK(working.working_of_source[working.source_of_working[w]] == w);
    for (int v = 0; v < source.vertex_count(); ++v)
        if (const int w = working.working_of_source[v]; w >= 0) {
            const Eigen::Vector3d back = working.to_source(Eigen::Vector3d(working.mesh.points.row(w)));
            CHECK((back - Eigen::Vector3d(source.points.row(v))).norm() <= 2e-6 * working.scale);
            CHECK(working.source_of_working[w] <= v);
        }
    CHECK(working.polygon_of_triangle.size() == static_cast<std::size_t>(working.mesh.triangle_count()));
    CHECK(std::is_sorted(working.polygon_of_display.begin(), working.polygon_of_display.end()));
    for (const Finding& f : working.findings) {
        CHECK(f.count > 0);
        CHECK(f.examples.size() == static_cast<std::size_t>(std::min(f.count, 8)));
    }
}

} // namespace

TEST_CASE("a sound mesh is taken as it is, and nothing is found") {
    for (const TriangleMesh& mesh : {shapes::bumpy_sphere(), shapes::torus(), shapes::double_torus(), shapes::bar()}) {
        const WorkingMesh working = shapes::working(mesh);
        check_usable(working, shapes::polygons(mesh));
        CHECK(working.findings.empty());
        CHECK(working.mesh.triangles == mesh.triangles);
        CHECK(working.display == mesh.triangles);
        CHECK(working.closed);
        CHECK(working.oriented);
        CHECK(working.component_count == 1);
        CHECK(diagonal(working.mesh.points) == doctest::Approx(1));
    }
    CHECK(shapes::working(shapes::torus()).euler_characteristic == 0);
}

TEST_CASE("each of the eight broken inputs gives a usable copy") {
    for (const TriangleMesh& base : {shapes::bumpy_sphere(2), shapes::bumpy_sheet(), shapes::box(4, 6, 4)})
        for (const shapes::Broken& broken : shapes::eight_broken(base)) {
            CAPTURE(std::string(broken.name));
            const PolygonMesh source = shapes::polygons(broken.mesh);
            check_usable(make_working_mesh(source), source);
        }
}

TEST_CASE("each broken input is named, counted, and mended where it can be") {
    const TriangleMesh base = shapes::bumpy_sphere(2);
    const int n = base.vertex_count(), m = base.triangle_count();
    const auto same_as_base = [&](const WorkingMesh& working) {
        CHECK(working.mesh.vertex_count() == n);
        CHECK(working.mesh.triangle_count() == m);
        CHECK(working.closed);
        CHECK(working.oriented);
        CHECK(working.euler_characteristic == 2);
    };
    SUBCASE("unused vertices") {
        const WorkingMesh working = shapes::working(shapes::with_unused_vertices(base, 3));
        same_as_base(working);
        CHECK(found(working, "unused-vertex") == 3);
        for (const int v : finding(working, "unused-vertex")->examples)
            CHECK(working.working_of_source[v] == -1);
    }
    SUBCASE("zero-area faces") {
        const WorkingMesh working = shapes::working(shapes::with_zero_area_faces(base));
        same_as_base(working);
        CHECK(found(working, "zero-area-face") == 2);
        CHECK(finding(working, "zero-area-face")->repaired);
        CHECK(found(working, "duplicate-vertices") == 1);
    }
    SUBCASE("a face without area whose corners differ is kept") {
        const WorkingMesh working = shapes::working(shapes::with_needles(base, 2, 0));
        CHECK(found(working, "zero-area-face") == 2);
        CHECK_FALSE(finding(working, "zero-area-face")->repaired);
        CHECK(working.closed);
    }
    SUBCASE("duplicated positions") {
        const WorkingMesh working = shapes::working(shapes::soup(base));
        same_as_base(working);
        CHECK(found(working, "duplicate-vertices") == 3 * m - n);
        CHECK(found(working, "near-duplicate-vertices") == 0);
    }
    SUBCASE("a jittered soup") {
        for (const double jitter : {1e-12, 1e-8, 2.5e-7}) {
            const WorkingMesh working = shapes::working(shapes::soup(base, jitter * diagonal(base.points)));
            same_as_base(working);
            CHECK(found(working, "near-duplicate-vertices") == 3 * m - n);
        }
    }
    SUBCASE("a fin") {
        const WorkingMesh working = shapes::working(shapes::with_fin(base));
        CHECK(found(working, "non-manifold-edge") == 1);
        CHECK(working.mesh.triangle_count() == m + 1);
        CHECK_FALSE(working.closed);
        CHECK(working.oriented);
    }
    SUBCASE("flipped faces") {
        for (const TriangleMesh& mesh : {shapes::with_flipped_face(base, 7), shapes::with_mixed_orientation(base, 3)}) {
            const WorkingMesh working = shapes::working(mesh);
            same_as_base(working);
            CHECK(found(working, "inconsistent-orientation") > 0);
            CHECK(working.mesh.triangles.rowwise().sum() == base.triangles.rowwise().sum());
            CHECK(signed_volume(working.mesh) > 0);
        }
        CHECK(finding(shapes::working(shapes::with_flipped_face(base, 7)), "inconsistent-orientation")->examples
              == std::vector<int>{7});
    }
    SUBCASE("an extra shell") {
        const WorkingMesh working = shapes::working(shapes::with_extra_shell(base));
        CHECK(working.component_count == 2);
        CHECK(finding(working, "several-components")->examples == std::vector<int>{0, n});
    }
    SUBCASE("needles") {
        const WorkingMesh working = shapes::working(shapes::with_needles(base, 4));
        CHECK(found(working, "needle-face") == 4);
        CHECK(working.closed);
    }
    SUBCASE("faces given twice") {
        const WorkingMesh working = shapes::working(shapes::with_duplicate_faces(base, 3));
        same_as_base(working);
        CHECK(finding(working, "duplicate-face")->examples == std::vector<int>{m, m + 1, m + 2});
        CHECK(working.display.rows() == m + 3);
    }
    SUBCASE("a vertex that is not a number") {
        const WorkingMesh working = shapes::working(shapes::with_nan_vertex(base, 5));
        check_usable(working, shapes::polygons(shapes::with_nan_vertex(base, 5)));
        CHECK(finding(working, "non-finite-vertex")->examples == std::vector<int>{5});
        CHECK(working.working_of_source[5] == -1);
        CHECK(working.mesh.vertex_count() == n - 1);
        CHECK(working.boundary_loop_count == 1);
    }
    SUBCASE("a vertex at infinity that no face uses") {
        TriangleMesh mesh = shapes::with_unused_vertices(base, 1);
        mesh.points.row(0).setConstant(std::numeric_limits<double>::infinity());
        same_as_base(shapes::working(mesh));
        mesh.points.row(0).setConstant(1e30); // finite, but it must not shrink the rest
        const WorkingMesh working = shapes::working(mesh);
        CHECK(diagonal(working.mesh.points) == doctest::Approx(1));
    }
}

TEST_CASE("faces that cannot be used are left out and listed") {
    PolygonMesh source = shapes::polygons(shapes::box(2, 2, 2));
    source.corners[0] = 1000000;
    source.corners[5] = -7;
    source.corners[6] = source.corners[7];
    const WorkingMesh working = make_working_mesh(source);
    check_usable(working, source);
    CHECK(finding(working, "index-out-of-range")->examples == std::vector<int>{0, 1});
    CHECK(finding(working, "face-too-small")->examples == std::vector<int>{2});
    CHECK(working.display.rows() == 45);
}

TEST_CASE("points alone get a surface to work on, and stay points") {
    PolygonMesh source{shapes::icosphere().points, {0}, {}};
    source.points.row(5).setConstant(std::numeric_limits<double>::quiet_NaN());
    const WorkingMesh working = make_working_mesh(source);
    CHECK(finding(working, "points-only")->count == source.vertex_count());
    CHECK(finding(working, "non-finite-vertex")->examples == std::vector<int>{5});
    CHECK(working.working_of_source[5] == -1);
    CHECK(working.display.rows() > source.vertex_count());
    CHECK(working.display.rows() == std::ssize(working.polygon_of_display));
    CHECK(working.display.maxCoeff() < source.vertex_count());
    CHECK(working.oriented);
    CHECK(working.findings.size() == 2); // nothing is said of a surface that the file does not hold
}

TEST_CASE("inputs without a surface are refused by name") {
    const Points corner = Points::Zero(3, 3);
    Points triangle(3, 3);
    triangle << 0, 0, 0, 1, 0, 0, 0, 1, 0;
    CHECK(code_of({}) == "no-vertices");
    CHECK(code_of(shapes::polygons(corner, {})) == "no-faces");
    CHECK(code_of(shapes::polygons(triangle, {{0, 1}})) == "no-usable-faces");
    CHECK(code_of(shapes::polygons(triangle, {{0, 1, 9}})) == "no-usable-faces");
    CHECK(code_of(shapes::polygons(corner, {{0, 1, 2}})) == "zero-size");
    CHECK(code_of({triangle, {0, 4}, {0, 1, 2}}) == "bad-offsets");
    Points line(3, 3);
    line << 0, 0, 0, 1, 0, 0, 1, 0, 0;
    CHECK(code_of(shapes::polygons(line, {{0, 1, 2}})) == "no-usable-faces");
    CHECK(code_of(shapes::polygons(line, {})) == "no-faces");
    CHECK(code_of(shapes::polygons(triangle, {{0, 1, 2}})) == "none"); // one triangle is a surface
}

TEST_CASE("one-sided surfaces are tolerated and named") {
    for (const TriangleMesh& mesh : {shapes::moebius(), shapes::klein_bottle()}) {
        const WorkingMesh working = shapes::working(mesh);
        CHECK_FALSE(working.oriented);
        CHECK(found(working, "non-orientable") == 1);
        CHECK(working.mesh.triangles == mesh.triangles); // one seam either way: left as it came
    }
    CHECK(shapes::working(shapes::moebius()).boundary_loop_count == 1);
    CHECK(shapes::working(shapes::klein_bottle()).closed);
}

TEST_CASE("a closed shell faces outward, but a cavity keeps facing in") {
    const TriangleMesh sphere = shapes::icosphere(2);
    const WorkingMesh turned = shapes::working(shapes::turned_inside_out(sphere));
    CHECK(signed_volume(turned.mesh) > 0);
    CHECK(found(turned, "inside-out") == sphere.triangle_count());

    const TriangleMesh hollow = shapes::joined(
        {shapes::turned_inside_out(shapes::moved(sphere, Eigen::Affine3d(Eigen::Scaling(0.5)))), sphere});
    CHECK(shapes::working(hollow).mesh.triangles == hollow.triangles);
    CHECK(found(shapes::working(hollow), "inside-out") == 0);

    const TriangleMesh pair = shapes::two_spheres(2);
    TriangleMesh half_turned = pair;
    half_turned.triangles.bottomRows(sphere.triangle_count()) =
        shapes::turned_inside_out(pair).triangles.bottomRows(sphere.triangle_count());
    CHECK(signed_volume(shapes::working(half_turned).mesh) == doctest::Approx(signed_volume(shapes::working(pair).mesh)));
}

TEST_CASE("an open sheet faces the way most of it did") {
    const TriangleMesh sheet = shapes::bumpy_sheet();
    const WorkingMesh few = shapes::working(shapes::with_mixed_orientation(sheet, 3));
    CHECK(vertex_normals(few.mesh).col(2).minCoeff() > 0);
    const WorkingMesh most = shapes::working(shapes::with_mixed_orientation(shapes::turned_inside_out(sheet), 3));
    CHECK(vertex_normals(most.mesh).col(2).maxCoeff() < 0);
    CHECK(shapes::working(shapes::turned_inside_out(sheet)).mesh.triangles == shapes::turned_inside_out(sheet).triangles);
}

TEST_CASE("far offset and tiny size give the same copy") {
    const TriangleMesh base = shapes::bumpy_sphere(3);
    const Points expected = shapes::working(base).mesh.points;
    const WorkingMesh far = shapes::working(shapes::moved(base, Eigen::Affine3d(Eigen::Translation3d(1e8, -1e8, 1e8))));
    CHECK((far.mesh.points - expected).cwiseAbs().maxCoeff() < 1e-7);
    CHECK(finding(far, "far-from-origin")->repaired);
    for (const double scale : {1e-6, 1e6, 1e-30, 1e30}) {
        const WorkingMesh tiny = shapes::working(shapes::moved(base, Eigen::Affine3d(Eigen::Scaling(scale))));
        CHECK((tiny.mesh.points - expected).cwiseAbs().maxCoeff() < 1e-12);
        CHECK(tiny.findings.empty());
    }
}

TEST_CASE("a map seen from working space does what it does in source space") {
    const TriangleMesh base = shapes::moved(shapes::bumpy_sphere(1), Eigen::Translation3d(5, 6, -7) * Eigen::Scaling(20.0));
    const WorkingMesh working = shapes::working(base);
    Eigen::Affine3d map = Eigen::Translation3d(1, 2, 3) * Eigen::AngleAxisd(1, Eigen::Vector3d::UnitY())
                          * Eigen::Scaling(2.0, 1.0, 0.5);
    const Eigen::Affine3d seen = working.to_working(map);
    for (int v = 0; v < base.vertex_count(); ++v) {
        const Eigen::Vector3d p = base.points.row(v);
        CHECK((working.to_source(Eigen::Vector3d(seen * working.to_working(p))) - map * p).norm() < 1e-11);
    }
    CHECK(working.to_working(Eigen::Affine3d::Identity()).matrix() == Eigen::Matrix4d::Identity());
}

TEST_CASE("renumbering the source renumbers the copy and nothing else (seeds 1 to 4)") {
    for (const std::uint64_t seed : {1, 2, 3, 4})
        for (const shapes::Broken& broken : shapes::eight_broken(shapes::bumpy_sphere(1))) {
            CAPTURE(seed);
            CAPTURE(std::string(broken.name));
            const std::vector<int> place = shapes::permutation(broken.mesh.vertex_count(), seed);
            const WorkingMesh a = shapes::working(broken.mesh), b = shapes::working(shapes::permuted(broken.mesh, place));
            REQUIRE(a.mesh.vertex_count() == b.mesh.vertex_count());
            REQUIRE(a.mesh.triangle_count() == b.mesh.triangle_count());
            for (int v = 0; v < broken.mesh.vertex_count(); ++v) {
                const int p = a.working_of_source[v], q = b.working_of_source[place[v]];
                REQUIRE((p < 0) == (q < 0));
                if (p >= 0)
                    CHECK((a.mesh.points.row(p) - b.mesh.points.row(q)).norm() < 1e-7);
            }
            for (int t = 0; t < a.mesh.triangle_count(); ++t)
                for (int k = 0; k < 3; ++k)
                    CHECK(b.working_of_source[place[a.source_of_working[a.mesh.triangles(t, k)]]] == b.mesh.triangles(t, k));
        }
}

TEST_CASE("near twins inside a closed surface stay apart") {
    const TriangleMesh sphere = shapes::icosphere(2);
    const TriangleMesh shifted = shapes::moved(sphere, Eigen::Affine3d(Eigen::Translation3d(1e-8, 0, 0)));
    CHECK(shapes::working(shapes::joined({sphere, shifted})).component_count == 2);
}

TEST_CASE("details finer than the welding distance are not welded away") {
    const TriangleMesh crumb = shapes::moved(shapes::bumpy_sheet(8, 8), Eigen::Affine3d(Eigen::Scaling(1e-7)));
    const TriangleMesh both = shapes::joined({crumb, shapes::moved(shapes::sheet(), Eigen::Affine3d(Eigen::Translation3d(2, 0, 0)))});
    CHECK(shapes::working(both).mesh.vertex_count() == both.vertex_count());
}
