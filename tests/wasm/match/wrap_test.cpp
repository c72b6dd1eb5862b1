#include "lissom/match/wrap.h"

#include "../isoline/figures.h"
#include "lissom/match/denoise.h"
#include "lissom/match/distances.h"
#include "lissom/match/folds.h"
#include "lissom/match/skin_settling.h"
#include "lissom/mesh/chance.h"
#include "lissom/mesh/operators.h"
#include "lissom/mesh/self_intersections.h"
#include "lissom/mesh/topology.h"
#include "lissom/mesh/triangle_tree.h"
#include "refusal.h"
#include "shapes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <string>
#include <vector>

using namespace lissom;

namespace {

bool is_closed(const TriangleMesh& mesh) { return boundary_loops(mesh).empty() && non_manifold_vertices(mesh).empty() && components(vertex_rings(mesh)).count == 1; }

/// Triangles of their own, one of `every` gone, each coordinate off by up to a share of the diagonal.
TriangleMesh holed_soup(const TriangleMesh& mesh, int every, double jitter) {
    TriangleMesh left = mesh;
    int row = 0;
    for (int t = 0; t < mesh.triangle_count(); ++t)
        if (chance(3, static_cast<std::uint64_t>(t), 5) >= 1.0 / every) left.triangles.row(row++) = mesh.triangles.row(t);
    left.triangles.conservativeResize(row, 3);
    return shapes::soup(left, jitter * diagonal(mesh.points));
}

struct Slices {
    double sum = 0, longest = 0;
    template <class Step>
    void run(Step step) {
        for (bool more = true; more;) {
            const std::clock_t before = std::clock();
            more = step();
            const double lap = static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC;
            sum += lap;
            longest = std::max(longest, lap);
        }
    }
};

} // namespace

TEST_CASE("around meshes, soups and points the wrap is closed, of the genus asked for, and at its radius") {
    for (const bool ring : {false, true}) {
        const TriangleMesh mesh = ring ? shapes::torus(64, 32) : shapes::bumpy_sphere(4);
        for (const TriangleMesh& model : {mesh, holed_soup(mesh, 20, 1e-5), as_triangles(mesh.points)}) {
            const Wrapped out = wrap(model, {.genus = ring, .edge_length = 0.1, .cells = 40});
            CHECK(out.genus == ring);
            CHECK_FALSE(out.genus_missed);
            CHECK(is_closed(out.mesh));
            CHECK(signed_volume(out.mesh) > signed_volume(mesh));
            CHECK(out.left_out == 0);
            const TriangleTree tree(mesh);
            double farthest = 0;
            for (int v = 0; v < out.mesh.vertex_count(); ++v) farthest = std::max(farthest, tree.nearest(out.mesh.points.row(v).transpose()).distance);
            CHECK(farthest < 1.3 * out.radius);
        }
    }
}

TEST_CASE("a wrap goes with its model in another unit") {
    const TriangleMesh mesh = shapes::bumpy_sphere(3);
    TriangleMesh large = mesh;
    large.points *= 1024;
    const Wrapped a = wrap(mesh, {.edge_length = 0.1, .cells = 40}), b = wrap(large, {.edge_length = 102.4, .cells = 40});
    CHECK(b.radius == doctest::Approx(1024 * a.radius));
    CHECK(std::abs(a.mesh.vertex_count() - b.mesh.vertex_count()) < 0.02 * a.mesh.vertex_count());
    CHECK(signed_volume(b.mesh) == doctest::Approx(std::pow(1024.0, 3) * signed_volume(a.mesh)).epsilon(1e-3));
}

TEST_CASE("a genus that there is not is told, and webs where parts come near") {
    const Wrapped missed = wrap(shapes::icosphere(3), {.genus = 2, .edge_length = 0.1, .cells = 30});
    CHECK(missed.genus_missed);
    CHECK(missed.genus == 0);
    CHECK(is_closed(missed.mesh));
    CHECK(missed.webs == 0);
    // Two bars side by side, the gap a little narrower than twice the radius.
    const TriangleMesh bars = shapes::joined({shapes::box(4, 20, 4, {0.2, 1, 0.2}), shapes::moved(shapes::box(4, 20, 4, {0.2, 1, 0.2}), Eigen::Affine3d(Eigen::Translation3d(0.244, 0, 0)))});
    const Wrapped webbed = wrap(bars, {.cells = 60});
    MESSAGE("bars: radius " << webbed.radius << ", genus " << webbed.genus << ", vertices " << webbed.mesh.vertex_count() << ", webs " << webbed.webs);
    CHECK(webbed.webs > 0);
    CHECK_FALSE(webbed.web_examples.empty());
    // Two balls far apart: the other is told.
    CHECK(wrap(shapes::two_spheres(3), {.edge_length = 0.2, .cells = 60}).left_out == 1);
    CHECK(refusal([] { (void)wrap({Points::Zero(1, 3), Triangles::Zero(1, 3)}); }) == "flat-model");
    CHECK(refusal([] { (void)wrap(shapes::icosphere(2), {.genus = -1}); }) == "bad-option");
    CHECK(refusal([] { (void)wrap(shapes::icosphere(2), {.cells = 5}); }) == "bad-option");
}

TEST_CASE("a body as a mesh, a soup, points and noisy points: wrapped and settled it lies on the clean one") {
    const TriangleMesh body = figures::shared("human/body_male"), points = figures::shared("generated/out/points_oriented"), noisy = figures::shared("generated/out/points_noisy");
    if (body.vertex_count() == 0 || points.vertex_count() == 0 || noisy.vertex_count() == 0) return;
    struct Case {
        const char* name;
        TriangleMesh model;
        SettlingOptions options;
        double mean, most;
    };
    const SettlingOptions by_points{.first_stiffness = 10, .last_stiffness = 3, .projections = 0, .facing = false}, by_noise{.first_stiffness = 30, .last_stiffness = 10, .projections = 0, .facing = false};
    const std::vector<Case> cases{{"mesh", body, {}, 0.001, 0.003},
                                  {"soup", holed_soup(body, 20, 1e-5), {}, 0.001, 0.003},
                                  {"points", as_triangles(points.points), by_points, 0.001, 0.003},
                                  {"noisy", as_triangles(denoised(noisy.points)), by_noise, 0.003, 0.006}};
    const double D = diagonal(body.points);
    for (const Case& c : cases) {
        CAPTURE(std::string(c.name));
        Wrapper wrapper(c.model, {});
        Slices wrapping, settling_slices;
        wrapping.run([&] { return wrapper.step(); });
        TriangleMesh skin = wrapper.result().mesh;
        const FitSurface surface(c.model, {false, c.options.facing});
        SkinSettling settling(skin, surface, c.options);
        settling_slices.run([&] { return settling.step(skin); });
        const SurfaceDistances apart = surface_distances(skin, body);
        MESSAGE(std::string(c.name) << ": radius " << wrapper.result().radius / D << ", genus " << wrapper.result().genus << ", webs " << wrapper.result().webs << ", " << skin.vertex_count() << " vertices; skin to clean body "
                                    << apart.mean_there / D << ", back " << apart.mean_back / D << ", 99 % " << apart.most / D << ", folds " << count_folds(skin, neighbouring_triangles(skin)) << ", crossings "
                                    << self_intersections(skin).triangles.size() << "; wrapped in " << wrapping.sum << " s (longest slice " << wrapping.longest << "), settled in " << settling_slices.sum << " s ("
                                    << settling_slices.longest << ")");
        CHECK(wrapper.result().genus == 0);
        CHECK_FALSE(wrapper.result().genus_missed);
        CHECK(is_closed(skin));
        CHECK(apart.mean_there < c.mean * D);
        CHECK(apart.mean_back < c.mean * D);
        CHECK(apart.most < c.most * D);
        CHECK(self_intersections(skin).pairs == 0);
    }
}
