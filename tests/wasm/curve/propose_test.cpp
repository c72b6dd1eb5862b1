#include "lissom/curve/propose.h"

#include "lissom/curve/spline.h"
#include "limbs.h"
#include "refusal.h"
#include "shapes.h"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdio>
#include <set>

using namespace lissom;
using Eigen::Vector3d;

namespace {

void check_trees(const ProposedSkeleton& skeleton) {
    std::set<int> children;
    for (const ProposedLink& link : skeleton.links) {
        CHECK(link.parent < link.child); // parents come first, so there is no ring
        CHECK(children.insert(link.child).second);
        CHECK((link.at == 0 || link.at == 1));
    }
    for (const ProposedCurve& curve : skeleton.curves) {
        CHECK(curve.controls.allFinite());
        CHECK(curve.radius.size() == static_cast<std::size_t>(curve.controls.rows()));
    }
}

} // namespace

TEST_CASE("a bar has one curve, its axis") {
    for (const double scale : {1e-4, 1.0}) {
        TriangleMesh mesh = shapes::bar();
        mesh.points *= scale;
        const ProposedSkeleton skeleton = propose_curves(CurveSurface(std::make_shared<WorkingMesh>(shapes::working(mesh))));
        check_trees(skeleton);
        REQUIRE(skeleton.curves.size() == 1);
        const SplineCurve curve(skeleton.curves[0].controls);
        CHECK(curve.length() > 6 * scale);
        for (int k = 2; k <= 18; ++k) CHECK(std::hypot(curve.point(k / 20.0).x(), curve.point(k / 20.0).z()) < 0.3 * scale);
    }
}

TEST_CASE("a ball has no limbs; broken models have what they have") {
    CHECK(refusal([] { (void)propose_curves(CurveSurface(std::make_shared<WorkingMesh>(shapes::working(shapes::icosphere(3))))); }) == "no-limbs");
    check_trees(propose_curves(CurveSurface(std::make_shared<WorkingMesh>(shapes::working(shapes::soup(shapes::bar()))))));
    check_trees(propose_curves(CurveSurface(std::make_shared<WorkingMesh>(shapes::working(shapes::torus(64, 16))))));
}

TEST_CASE("limbs of creatures are found") {
    // Of each creature's slender limbs the share that lies near some proposed curve.
    for (const limbs::Limb& limb : limbs::all()) {
        const limbs::Creature& creature = limbs::creature(limb.creature);
        if (creature.mesh.vertex_count() == 0 || !limb.slender) continue;
        const ProposedSkeleton skeleton = propose_curves(*creature.surface);
        check_trees(skeleton);
        const std::vector<limbs::Bone> bones = creature.bones(limb);
        double near = 0, all = 0;
        for (std::size_t b = bones.size() > 2 ? 1 : 0; b < bones.size(); ++b)
            for (int k = 0; k <= 6; ++k) {
                const double u = k / 6.0;
                const Vector3d p = bones[b].a + u * (bones[b].b - bones[b].a);
                double least = INFINITY;
                for (const ProposedCurve& curve : skeleton.curves) least = std::min(least, SplineCurve(curve.controls).nearest(p).distance);
                near += least < (1 - u) * bones[b].ra + u * bones[b].rb ? 1 : 0;
                all += 1;
            }
        std::printf("%-8s %-10s %zu curves, %zu links; %3.0f %% of the limb has one inside\n", limb.creature.c_str(), limb.name.c_str(), skeleton.curves.size(), skeleton.links.size(), 100 * near / all);
        CHECK(near / all > 0.6);
    }
}
