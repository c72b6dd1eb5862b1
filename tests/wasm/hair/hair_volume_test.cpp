#include "lissom/hair/hair_volume.h"

#include "refusal.h"
#include "shapes.h"

#include <doctest/doctest.h>

using namespace lissom;
using Eigen::Vector3d;

namespace {

/// A ball of a head of height 2 with its upper part scalp, and one that is its pole by `up`.
struct Head {
    TriangleMesh mesh = shapes::icosphere(3);
    std::vector<int> scalp;
    explicit Head(int up = 1) {
        for (int v = 0; v < mesh.vertex_count(); ++v)
            if (mesh.points(v, up) > 0) scalp.push_back(v);
    }
};

Vector3d low(const Grid& grid) { return grid.origin; }
Vector3d high(const Grid& grid) { return grid.position(grid.count() - 1); }

} // namespace

TEST_CASE("the field's grid leaves room for hair: beside the head, a little above and far below it") {
    for (const int up : {0, 1, 2}) {
        CAPTURE(up);
        const Head head(up);
        const HairVolume volume = hair_volume(head.mesh, head.scalp, 48, static_cast<UpAxis>(up));
        CHECK(volume.head_height == doctest::Approx(2).epsilon(1e-3));
        const double h = volume.head_height, step = volume.field.step;
        CHECK(volume.field.size.maxCoeff() == 48);
        for (int d = 0; d < 3; ++d) {
            CHECK(low(volume.field)[d] == doctest::Approx(-1 - (d == up ? 0.8 : 0.45) * h).scale(1).epsilon(step));
            CHECK(high(volume.field)[d] == doctest::Approx(1 + (d == up ? 0.25 : 0.45) * h).scale(1).epsilon(step));
        }
        CHECK(volume.head.triangles == head.mesh.triangles);
    }
}

TEST_CASE("the grid of distances is finer and lies close round the head, by more than two cells") {
    const Head head;
    const HairVolume volume = hair_volume(head.mesh, head.scalp, 48);
    CHECK(volume.distance.step < volume.field.step);
    for (int d = 0; d < 3; ++d) {
        CHECK(low(volume.distance)[d] < -1 - 2 * volume.distance.step);
        CHECK(high(volume.distance)[d] > 1 + 2 * volume.distance.step);
        CHECK(low(volume.distance)[d] >= low(volume.field)[d]);
        CHECK(high(volume.distance)[d] <= high(volume.field)[d]);
    }
}

TEST_CASE("it moves and grows with the head") {
    const Head head;
    const HairVolume here = hair_volume(head.mesh, head.scalp, 32);
    for (const double unit : {1e-3, 1e3}) {
        const Vector3d by = unit * Vector3d(3, -2, 5);
        const HairVolume there = hair_volume(shapes::moved(head.mesh, Eigen::Affine3d(Eigen::Translation3d(by) * Eigen::Scaling(unit))), head.scalp, 32);
        CHECK(there.head_height == doctest::Approx(unit * here.head_height));
        CHECK(there.field.size == here.field.size);
        CHECK(there.field.step == doctest::Approx(unit * here.field.step));
        CHECK((low(there.field) - by - unit * low(here.field)).norm() < 1e-9 * unit);
        CHECK(there.distance.size == here.distance.size);
    }
}

TEST_CASE("of a body only what lies near the scalp counts, by the scalp's size") {
    const Head head;
    const TriangleMesh body = shapes::moved(shapes::uv_sphere(24, 48), Eigen::Affine3d(Eigen::Translation3d(0, -6.5, 0) * Eigen::Scaling(Vector3d(2, 6, 1.5))));
    const HairVolume volume = hair_volume(shapes::joined({head.mesh, body}), head.scalp, 32);
    Vector3d least = Vector3d::Constant(1e9), most = -least;
    for (const int v : head.scalp) {
        least = least.cwiseMin(head.mesh.points.row(v).transpose());
        most = most.cwiseMax(head.mesh.points.row(v).transpose());
    }
    CHECK(volume.head_height == doctest::Approx(1.35 * (most - least).maxCoeff()));
    CHECK(low(volume.field).y() > -5);
    CHECK(volume.head.triangle_count() > head.mesh.triangle_count() / 2);
    CHECK(volume.head.triangle_count() < head.mesh.triangle_count() + body.triangle_count() / 2);
    CHECK(volume.head.vertex_count() == head.mesh.vertex_count() + body.vertex_count()); // vertices keep their numbers
}

TEST_CASE("what has no scalp or an odd resolution is refused") {
    const Head head;
    const auto code = [&](const std::vector<int>& scalp, int resolution) {
        return refusal([&] { (void)hair_volume(head.mesh, scalp, resolution); });
    };
    CHECK(code(head.scalp, 16) == "none");
    CHECK(code(head.scalp, 96) == "none");
    CHECK(code(head.scalp, 15) == "bad-resolution");
    CHECK(code(head.scalp, 97) == "bad-resolution");
    CHECK(code({}, 32) == "scalp-empty");
    CHECK(code({7}, 32) == "scalp-empty"); // a point has no size
    CHECK(code({0, 1, head.mesh.vertex_count()}, 32) == "scalp-vertex");
    CHECK(code({0, 1, -1}, 32) == "scalp-vertex");
}

TEST_CASE("a vertex so far away that the scalp has no digits left is refused, one at the end of what numbers tell apart is not") {
    const auto code = [](double away) {
        Head head;
        for (int v = 0; v < head.mesh.vertex_count(); ++v)
            if (head.mesh.points(v, 1) < -0.9) head.mesh.points(v, 2) = -away; // below the scalp
        return refusal([&] { (void)hair_volume(head.mesh, head.scalp, 32, UpAxis::y); });
    };
    CHECK(code(1e30) == "scalp-too-small");
    CHECK(code(1e11) == "scalp-too-small");
    CHECK(code(1e9) == "none");
}
