#include "lissom/hair/hair_session.h"

#include "hair/egg.h"
#include "lissom/hair/dual_field.h"
#include "lissom/mesh/errors.h"
#include "refusal.h"

#include <doctest/doctest.h>

#include <limits>

using namespace lissom;
using eggs::Convex;
using eggs::Egg;
using Eigen::Vector3d;

namespace {

std::unique_ptr<HairSession> prepared(const Egg& egg, int resolution = 24) {
    auto session = std::make_unique<HairSession>(egg.mesh, egg.scalp, resolution);
    double before = 0;
    while (session->step()) {
        CHECK(session->fraction() >= before);
        before = session->fraction();
    }
    return session;
}

struct Grown {
    Strands strands;
    HairFigures figures;
};
Grown grown(const HairSession& session, int from, int count, const GrowthOptions& growth = {}, const DetailOptions& detail = {}) {
    auto under_way = session.grow(from, count, growth, detail);
    while (under_way.step()) {}
    return {under_way.take(), under_way.figures()};
}

Vector3d point(const Strands& s, std::uint32_t at) { return {s.points[3 * at], s.points[3 * at + 1], s.points[3 * at + 2]}; }

/// Depth of the deepest point of all strands in a body.
double deepest(const HairSession& session, const Strands& hair, const Convex& body) {
    double out = 0;
    for (std::uint32_t k = 0; k < hair.offsets.back(); ++k) out = std::max(out, body.depth(point(hair, k) + session.origin()));
    return out;
}
constexpr double k_deep = 0.005 * Egg::height;

} // namespace

TEST_CASE("combed hair covers the scalp, stays out of the head and is not short") {
    const Egg egg;
    const auto session = prepared(egg);
    session->set_style(egg.combed_down());
    const Convex skull(egg.mesh);
    for (const double curl : {0.0, 1.0}) {
        DetailOptions detail;
        detail.curl = curl;
        detail.frizz = detail.flyaways = curl;
        const Grown hair = grown(*session, 0, 3000, {}, detail);
        CHECK(hair.strands.count() == 3000);
        CHECK(hair.figures.inside_head == 0);
        CHECK(hair.figures.short_strands < 15);
        CHECK(hair.strands.offsets.back() * 3 == hair.strands.points.size());
        CHECK(deepest(*session, hair.strands, skull) <= k_deep);
    }
}

TEST_CASE("without the scalp's constraints the same style would run into the head") {
    const Egg egg;
    const auto session = prepared(egg);
    HairStyle style;
    style.streams.push_back({{egg.skin({0, 1, 0.2}, 0.01), egg.skin({0, 1, -0.2}, 0.01)}, false});
    session->set_style(style); // one stroke backwards: the field alone is that direction everywhere
    const VectorField& field = session->field();
    DualField alone(std::make_shared<GridBilaplacian>(field.grid.size));
    std::vector<FieldConstraint> constraints;
    constraints.push_back({field.grid.node(1, 1, 1), {0, 0, -1}});
    alone.set_constraints(constraints);
    const Vector3d brow = egg.skin({0, 0.5, 0.9}) - session->origin();
    const Vector3d normal = Vector3d(0, 0.5 / 0.12, 0.9 / 0.1).normalized();
    CHECK(alone.field().row(0).dot(normal.transpose()) < -0.5);
    CHECK(field.at(brow + 0.004 * normal).normalized().dot(normal) > -0.25);
}

TEST_CASE("a preview is a prefix: strands are the same whatever range they are grown in") {
    const Egg egg;
    const auto session = prepared(egg);
    session->set_style(egg.parted());
    DetailOptions detail;
    detail.curl = 0.5;
    const Strands all = grown(*session, 0, 400, {}, detail).strands;
    const Strands some = grown(*session, 0, 150, {}, detail).strands;
    const Strands rest = grown(*session, 150, 250, {}, detail).strands;
    for (std::size_t k = 0; k < some.points.size(); ++k) REQUIRE(some.points[k] == all.points[k]);
    for (std::size_t k = 0; k < rest.points.size(); ++k) REQUIRE(rest.points[k] == all.points[some.points.size() + k]);
    CHECK(some.points.size() + rest.points.size() == all.points.size());
}

TEST_CASE("a style depends on nothing that was there before it") {
    const Egg egg;
    const auto fresh = prepared(egg), used = prepared(egg);
    used->set_style(egg.combed_down());
    used->set_style(egg.tied());
    used->set_style({});
    used->set_style(egg.parted());
    fresh->set_style(egg.parted());
    CHECK(used->constraints().size() == fresh->constraints().size());
    CHECK(used->field().vectors == fresh->field().vectors);
    CHECK(grown(*used, 0, 300).strands.points == grown(*fresh, 0, 300).strands.points);
}

TEST_CASE("no strand crosses its parting within the first centimetre") {
    const Egg egg;
    const auto session = prepared(egg, 32);
    session->set_style(egg.parted());
    DetailOptions rough;
    rough.frizz = rough.flyaways = rough.curl = 1;
    for (const DetailOptions& detail : {DetailOptions{}, rough}) {
        const Strands hair = grown(*session, 0, 12000, {}, detail).strands;
        int near = 0;
        for (int i = 0; i < hair.count(); ++i) {
            const std::uint32_t first = hair.offsets[static_cast<std::size_t>(i)], end = hair.offsets[static_cast<std::size_t>(i) + 1];
            const Vector3d root = point(hair, first);
            const double angle = std::atan2(root.z() / 0.1, root.y() / 0.12);
            if (std::abs(root.x()) > 0.02 || angle < -0.15 || angle > 0.7) continue;
            ++near;
            double walked = 0;
            for (std::uint32_t k = first + 1; k < end; ++k) {
                walked += (point(hair, k) - point(hair, k - 1)).norm();
                if (walked > 0.01) break;
                CHECK(point(hair, k).x() * root.x() > 0);
            }
        }
        CHECK(near > 200);
    }
}

TEST_CASE("a ponytail gathers the hair of its region") {
    const Egg egg;
    const auto session = prepared(egg, 32);
    session->set_style(egg.tied());
    for (const double curl : {0.0, 0.8}) {
        DetailOptions detail;
        detail.curl = curl;
        const HairFigures figures = grown(*session, 0, 3000, {}, detail).figures;
        REQUIRE(figures.reached.size() == 1);
        CHECK(figures.reached[0] > 1500);
        CHECK(figures.gathered[0] >= 0.95 * figures.reached[0]);
    }
}

TEST_CASE("length is a length: as a whole, varied and painted") {
    const Egg egg;
    const auto session = prepared(egg);
    session->set_style(egg.combed_down());
    GrowthOptions growth;
    growth.length = 0.08;
    growth.length_variation = 0;
    DetailOptions plain{0, 0, {}, 0, 0};
    const auto lengths = [&] {
        const Strands hair = grown(*session, 0, 500, growth, plain).strands;
        Eigen::VectorXd out = Eigen::VectorXd::Zero(hair.count());
        for (int i = 0; i < hair.count(); ++i)
            for (std::uint32_t k = hair.offsets[static_cast<std::size_t>(i)] + 1; k < hair.offsets[static_cast<std::size_t>(i) + 1]; ++k)
                out[i] += (point(hair, k) - point(hair, k - 1)).norm();
        return out;
    };
    CHECK(lengths().mean() == doctest::Approx(0.08).epsilon(0.02));
    growth.length_variation = 0.5;
    CHECK(lengths().minCoeff() < 0.06);
    CHECK(lengths().maxCoeff() < 0.085);
    growth.length_variation = 0;
    growth.length_map.assign(static_cast<std::size_t>(egg.mesh.vertex_count()), 0.5f);
    CHECK(lengths().mean() == doctest::Approx(0.04).epsilon(0.02));
    growth.length_map.pop_back();
    CHECK_THROWS_AS((void)lengths(), InvalidInput);
}

TEST_CASE("hair follows its head: wherever that stands it is the same hair") {
    const Egg here({0, 0, 0}), there({1000, -500, 250});
    const auto a = prepared(here), b = prepared(there);
    a->set_style(here.combed_down());
    b->set_style(there.combed_down());
    CHECK((b->origin() - a->origin() - there.place).norm() < 1e-9);
    const Strands p = grown(*a, 0, 100).strands, q = grown(*b, 0, 100).strands;
    REQUIRE(p.points.size() == q.points.size());
    double gap = 0;
    for (std::size_t k = 0; k < p.points.size(); ++k) gap = std::max(gap, std::abs(double(p.points[k]) - q.points[k]));
    CHECK(gap < 1e-5);
}

TEST_CASE("in another unit it is the same hair, as much larger") {
    const Egg metres({0, 0, 0});
    Egg centimetres = metres;
    centimetres.mesh.points *= 100;
    HairStyle style = metres.combed_down();
    const auto a = prepared(metres), b = prepared(centimetres);
    a->set_style(style);
    for (StreamCurve& curve : style.streams)
        for (Vector3d& p : curve.points) p *= 100;
    b->set_style(style);
    const Strands p = grown(*a, 0, 100).strands, q = grown(*b, 0, 100).strands;
    REQUIRE(p.points.size() == q.points.size());
    double gap = 0;
    for (std::size_t k = 0; k < p.points.size(); ++k) gap = std::max(gap, std::abs(double(p.points[k]) - double(q.points[k]) / 100));
    CHECK(gap < 1e-5);
}

TEST_CASE("what cannot grow hair says so, and odd strokes are told and passed over") {
    const Egg egg;
    CHECK(refusal([&] { HairSession(egg.mesh, {}, 24); }) == "scalp-empty");
    CHECK(refusal([&] { HairSession(egg.mesh, std::vector<int>{-1}, 24); }) == "scalp-vertex");
    CHECK(refusal([&] { HairSession(egg.mesh, egg.scalp, 15); }) == "bad-resolution");
    CHECK(refusal([&] { HairSession(egg.mesh, egg.scalp, 97); }) == "bad-resolution");

    const auto session = prepared(egg, 16);
    CHECK(session->warnings().front().code == "style-empty");
    CHECK(grown(*session, 0, 100).strands.count() == 0);
    CHECK(refusal([&] { (void)session->grow(0, 10'000'000, {}, {}); }) == "too-many-strands");
    CHECK(refusal([&] { (void)session->grow(0, 10, {}, DetailOptions{2, 0, {}, 0, 0}); }) == "bad-option");

    HairStyle style = egg.combed_down();
    const Vector3d p = egg.skin({0, 1, 0}, 0.01);
    style.streams.push_back({{p}, false});                                            // 8: one point
    style.streams.push_back({{p + Vector3d(9, 0, 0), p + Vector3d(9, 1, 0)}, false}); // 9: far off the head
    style.streams.push_back({{p, p + Vector3d(0.02, 0, 0.02), p + Vector3d(0.02, 0, 0), p + Vector3d(0, 0, 0.02)}, false}); // crosses itself
    style.streams.push_back({{p, p + Vector3d(0.03, 0, 0)}, false}); // two that contradict each other
    style.streams.push_back({{p + Vector3d(0.03, 0, 0), p}, false});
    Ponytail inside; // 13
    for (int k = 0; k < 8; ++k) inside.spine.push_back(egg.place + Vector3d(0, 0, 0.004 * k));
    for (double a = 0; a < 6; a += 0.3) inside.section.push_back(egg.place + 0.01 * Vector3d(std::cos(a), std::sin(a), 0));
    style.ponytails = {inside, Ponytail{}};
    session->set_style(style);
    std::vector<std::string> codes;
    for (const Finding& f : session->warnings()) codes.push_back(f.code);
    CHECK(codes == std::vector<std::string>{"stroke-too-short", "stroke-outside", "ponytail-inside-head", "ponytail-incomplete"});
    CHECK(session->warnings()[0].examples == std::vector<int>{8});
    CHECK(session->warnings()[2].examples == std::vector<int>{13});
    const Grown hair = grown(*session, 0, 500);
    CHECK(hair.figures.short_strands == 0);
    CHECK(hair.figures.inside_head == 0);
    CHECK(deepest(*session, hair.strands, Convex(egg.mesh)) <= k_deep);
    CHECK(grown(*session, 0, 0).strands.count() == 0);

    style.streams[0].points[0].x() = std::numeric_limits<double>::quiet_NaN();
    CHECK(refusal([&] { session->set_style(style); }) == "non-finite-stroke");
}

TEST_CASE("an open head grows hair as a closed one does") {
    Egg egg;
    const Convex closed(egg.mesh);
    Eigen::Index kept = 0;
    for (Eigen::Index t = 0; t < egg.mesh.triangles.rows(); ++t) {
        double y = 0;
        for (int k = 0; k < 3; ++k) y += egg.mesh.points(egg.mesh.triangles(t, k), 1) / 3;
        if (y > egg.place.y() - 0.09) egg.mesh.triangles.row(kept++) = egg.mesh.triangles.row(t);
    }
    egg.mesh.triangles.conservativeResize(kept, 3);
    const auto session = prepared(egg);
    session->set_style(egg.combed_down());
    const Grown hair = grown(*session, 0, 1000);
    CHECK(hair.figures.inside_head == 0);
    CHECK(deepest(*session, hair.strands, closed) <= k_deep);
    CHECK(hair.figures.short_strands < 5);
}

TEST_CASE("a body with a head grows hair on the head alone, in a volume of its size") {
    Egg egg({0, 1.6, 0});
    const TriangleMesh body = shapes::moved(shapes::uv_sphere(24, 48), Eigen::Affine3d(Eigen::Translation3d(0, 0.8, 0) * Eigen::Scaling(Vector3d(0.3, 0.75, 0.2))));
    const Convex skull(egg.mesh);
    egg.mesh = shapes::joined({egg.mesh, body});
    const auto session = prepared(egg, 32);
    CHECK(session->volume().head_height < 0.35);
    CHECK(session->volume().field.step < 0.03);
    session->set_style(egg.combed_down());
    const Grown hair = grown(*session, 0, 500);
    CHECK(hair.figures.inside_head == 0);
    CHECK(deepest(*session, hair.strands, skull) <= k_deep);
    CHECK(hair.figures.short_strands < 5);
}

TEST_CASE("curls are round: a strand has at least ten points for each of their turns, and at most 255") {
    const Egg egg;
    const auto session = prepared(egg);
    session->set_style(egg.combed_down());
    GrowthOptions growth;
    growth.length = 0.1;
    growth.length_variation = 0;
    for (const double turn : {0.02, 0.0005}) {
        const Strands hair = grown(*session, 0, 200, growth, {0, 0.8, turn, 0, 0}).strands;
        for (int i = 0; i < hair.count(); ++i) {
            const auto points = hair.offsets[static_cast<std::size_t>(i) + 1] - hair.offsets[static_cast<std::size_t>(i)];
            CHECK(points <= 255);
            CHECK(points >= std::min(200.0, 10 * 0.1 / turn));
        }
    }
}
