#include "lissom/isoline/isoline_model.h"
#include "lissom/isoline/taubin.h"

#include "sessions.h"

#include "lissom/mesh/operators.h"

#include <doctest/doctest.h>

#include <random>

#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__)
#define LISSOM_COUNTS_MEMORY
#include <malloc.h>
#endif

using namespace lissom;
using namespace sessions;

TEST_CASE("a small clean mesh is its own surface") {
    const TriangleMesh mesh = shapes::bumpy_sphere(4);
    const Prepared prepared(mesh);
    CHECK_FALSE(prepared.model.is_proxy());
    CHECK_FALSE(prepared.model.smoothed());
    CHECK(prepared.model.fraction() == 1);
    CHECK(prepared.model.surface().mesh.points == prepared.working.mesh.points);
    const Columns values = prepared.model.surface().mesh.points;
    CHECK((prepared.model.to_working(values).cast<double>() - prepared.working.mesh.points).cwiseAbs().maxCoeff() < 1e-6);
}

TEST_CASE("a large mesh is worked on through a proxy, and what is linear on it comes back") {
    const Prepared prepared(shapes::bumpy_sphere(5), {.proxy_vertices = 1500});
    CHECK(prepared.model.is_proxy());
    CHECK(prepared.model.surface().mesh.vertex_count() < 1700);
    CHECK(prepared.model.surface().mesh.vertex_count() > 1300);
    const Columns values = prepared.model.surface().mesh.points;
    const auto back = prepared.model.to_working(values);
    CHECK((back.cast<double>() - prepared.working.mesh.points).rowwise().norm().maxCoeff() < 0.01);
}

TEST_CASE("a proxy bends as stiffly as what it stands for: no needle outweighs the rest") {
    const TriangleMesh mesh = shapes::bumpy_sphere(6);
    const double bending = bending_energy(mesh);
    for (const int vertices : {3000, 10000, 30000}) {
        const Prepared prepared(mesh, {.proxy_vertices = vertices});
        CHECK(bending_energy(prepared.model.surface().mesh) == doctest::Approx(bending).epsilon(0.2));
    }
}

TEST_CASE("the fraction never falls and the last step says so") {
    const WorkingMesh working = shapes::working(shapes::bumpy_sphere(5));
    IsolineModel model(working, {.proxy_vertices = 1500, .smoothing = Smoothing::always});
    double last = 0;
    int steps = 0;
    for (bool more = true; more; ++steps) {
        more = model.step();
        CHECK(model.fraction() >= last);
        last = model.fraction();
    }
    CHECK(last == 1);
    CHECK(steps > 20); // no slice is long
    CHECK_FALSE(model.step());
}

TEST_CASE("noise is smoothed away from the surface that is worked on, from nothing else") {
    TriangleMesh noisy = shapes::bumpy_sphere(4);
    std::mt19937_64 random(11);
    std::uniform_real_distribution<double> amount(-1, 1);
    for (Eigen::Index k = 0; k < noisy.points.size(); ++k) noisy.points.data()[k] += 0.03 * amount(random); // nearly half an edge
    const Prepared prepared(noisy);
    CHECK(prepared.model.smoothed());
    CHECK(prepared.working.source == noisy.points);
    const Prepared never(noisy, {.smoothing = Smoothing::never});
    CHECK_FALSE(never.model.smoothed());
}

#ifdef LISSOM_COUNTS_MEMORY
TEST_CASE("memory is said before it is taken, and not far off") {
    for (const int levels : {5, 6}) {
        const TriangleMesh mesh = shapes::bumpy_sphere(levels);
        const WorkingMesh working = shapes::working(mesh);
        const double before = static_cast<double>(mallinfo2().uordblks + mallinfo2().hblkhd);
        double peak = 0;
        IsolineModel model(working, {.proxy_vertices = 20000});
        for (bool more = true; more;) {
            more = model.step();
            peak = std::max(peak, static_cast<double>(mallinfo2().uordblks + mallinfo2().hblkhd) - before);
        }
        IsolineSession session(model, handles::everything(working.source), axis_caps(mesh.points, 3));
        for (bool more = true; more;) {
            more = session.step();
            peak = std::max(peak, static_cast<double>(mallinfo2().uordblks + mallinfo2().hblkhd) - before);
        }
        const IsolineMemory said = estimate_isoline_memory(mesh.vertex_count(), mesh.triangle_count(), 3, 10, 20000);
        MESSAGE(mesh.vertex_count() << " vertices: " << peak / 1e6 << " MB held between slices, " << std::max(said.model, said.session) / 1e6 << " MB announced");
        CHECK(peak < std::max(said.model, said.session)); // an upper bound …
        CHECK(std::max(said.model, said.session) < 8 * peak); // … that is of use
    }
}
#endif
