#include "lissom/hair/strand_company.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace lissom;
using Eigen::Vector3d;

namespace {

/// A strand of ten segments from a place on a plane, straight towards `way`.
Strand straight(double x, double z, const Vector3d& way, PartingGuard::Sides sides = {}) {
    Strand strand{{0, 0, 0, {x, 0, z}, {0, 1, 0}}, std::move(sides), 0.1, {}};
    for (int k = 0; k <= 10; ++k) strand.points.push_back(Vector3d(x, 0, z) + 0.1 * k * way);
    return strand;
}

/// 10 × 10 of them, 0.1 apart.
std::vector<Strand> lawn(const Vector3d& way) {
    std::vector<Strand> out;
    for (int i = 0; i < 100; ++i) out.push_back(straight(0.1 * (i % 10), 0.1 * std::floor(i / 10), way));
    return out;
}

const Vector3d k_down(1, 0, 0), k_across(0, 0, 1);

} // namespace

TEST_CASE("a guide that goes a way of its own joins its neighbours, the others stay as they grew") {
    std::vector<Strand> grown = lawn(k_down);
    grown[44] = straight(grown[44].points[0].x(), grown[44].points[0].z(), k_across);
    const StrandCompany company(grown, 1);
    for (std::size_t g = 0; g < 100; ++g) {
        if (g != 44) CHECK(company.guides()[g].points == grown[g].points);
        CHECK(company.guides()[g].points[0] == grown[g].points[0]);
        const Vector3d way = (company.guides()[g].points.back() - grown[g].points[0]).normalized();
        CHECK(way.dot(k_down) > 0.99);
    }
}

TEST_CASE("where hair parts, guides and strands of both ways stay") {
    std::vector<Strand> grown = lawn(k_down);
    for (std::size_t g = 50; g < 100; ++g) grown[g] = straight(grown[g].points[0].x(), grown[g].points[0].z(), -k_down);
    const StrandCompany company(grown, 1);
    for (std::size_t g = 0; g < 100; ++g) CHECK(company.guides()[g].points == grown[g].points);
    for (const double way : {-1.0, 1.0}) {
        Strand between = straight(0.45, 0.45, way * k_down);
        const Strand before = between;
        const int g = company.join(between);
        CHECK(between.points == before.points);
        CHECK((g < 50) == (way > 0));
    }
}

TEST_CASE("a strand that goes along with no guide near it is laid beside the nearest, from its own root") {
    const StrandCompany company(lawn(k_down), 1);
    Strand stray = straight(0.42, 0.31, k_across);
    CHECK(company.join(stray) == 34);
    CHECK(stray.points[0] == Vector3d(0.42, 0, 0.31));
    CHECK((stray.points.back() - company.guides()[34].points.back()).norm() < 0.03);
}

TEST_CASE("no strand takes a guide from beyond a parting") {
    std::vector<Strand> grown = lawn(k_down);
    for (std::size_t g = 0; g < 100; ++g) grown[g].sides = {static_cast<std::int8_t>(g < 50 ? -1 : 1)};
    const StrandCompany company(grown, 1);
    Strand strand = straight(0.4, 0.44, k_down, {1});
    CHECK(company.join(strand) >= 50);
    CHECK(company.nearest(strand.root, {-1}, 100, 6).front() < 50);
    const StrandCompany nobody({}, 1);
    CHECK(nobody.join(strand) == -1);
}
