#include "lissom/isoline/carriers.h"

#include "sessions.h"

#include <doctest/doctest.h>

using namespace lissom;
using namespace sessions;

namespace {

void check_shares(const Carriers& carriers, const Columns& fields) {
    REQUIRE(carriers.details.offsets.size() == static_cast<std::size_t>(fields.rows()) + 1);
    for (Eigen::Index v = 0; v < fields.rows(); ++v) {
        double sum = 0;
        for (int s = carriers.details.offsets[v]; s < carriers.details.offsets[v + 1]; ++s) {
            sum += carriers.details.shares[s].weight;
            CHECK(carriers.details.shares[s].carrier < carriers.details.count);
        }
        CHECK(sum == doctest::Approx(1).epsilon(1e-12));
    }
}

} // namespace

TEST_CASE("every vertex hands out its detail once, to patches or to isolines") {
    const TriangleMesh mesh = shapes::bumpy_sphere(4);
    for (const int handles : {2, 4}) {
        const Fielded f(mesh, axis_caps(mesh.points, handles));
        const std::vector<HandleEnd> ends(static_cast<std::size_t>(handles));
        check_shares(patch_carriers(f.mesh, f.fields, f.handle, ends, {.count = 50}), f.fields);
        const ControlSets sets{FieldBasis(BasisKind::hats, 20), handles};
        check_shares(isoline_carriers(f.mesh, f.fields, sets, ends, 600), f.fields);
    }
}

TEST_CASE("region handles tell their own rotation, points and free ones do not") {
    const TriangleMesh mesh = shapes::bumpy_sphere(4);
    const Fielded f(mesh, axis_caps(mesh.points, 3));
    const std::vector<HandleEnd> ends{{HandleEnd::Kind::region}, {HandleEnd::Kind::point}, {HandleEnd::Kind::open}};
    const Carriers patches = patch_carriers(f.mesh, f.fields, f.handle, ends, {.count = 50});
    CHECK(patches.handle[0] == 0);
    CHECK(patches.handle[1] == -1);
    CHECK(patches.handle[2] == -1);
    CHECK(patches.samples[0].empty());
    const ControlSets sets{FieldBasis(BasisKind::hats, 10), 3};
    const Carriers lines = isoline_carriers(f.mesh, f.fields, sets, ends, 600);
    CHECK(lines.normals_only);
    CHECK(lines.handle[sets.end_control(0)] == 0);
    CHECK(lines.handle[sets.end_control(1)] == -1);
    int sampled = 0;
    for (int c = 0; c < lines.details.count; ++c) {
        CHECK(lines.samples[c].empty() == (lines.handle[c] >= 0));
        sampled += static_cast<int>(lines.samples[c].size());
    }
    CHECK(sampled <= 600);
    CHECK(sampled > 300);
}

TEST_CASE("the mean field of a carrier is between its vertices', and sums to one") {
    const TriangleMesh mesh = shapes::bumpy_sphere(3);
    const Fielded f(mesh, axis_caps(mesh.points, 3));
    const Carriers patches = patch_carriers(f.mesh, f.fields, f.handle, std::vector<HandleEnd>(3), {.count = 30});
    for (int c = 0; c < patches.details.count; ++c) CHECK(patches.fields.row(c).sum() == doctest::Approx(1).epsilon(1e-12));
}
