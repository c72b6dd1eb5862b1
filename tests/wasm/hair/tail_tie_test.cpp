#include "lissom/hair/tail_tie.h"

#include <doctest/doctest.h>

#include <algorithm>

using namespace lissom;
using Eigen::Vector3d;

namespace {

const TailSection k_section{{0, 0, 0}, {0, 0, 1}, 1};

/// A straight strand of 40 points a quarter apart along the axis, from −5 on, `off` beside it.
std::vector<Vector3d> beside(double off, double unit = 1) {
    std::vector<Vector3d> out;
    for (int k = 0; k < 40; ++k) out.push_back(unit * Vector3d(off, 0, -5 + 0.25 * k + 0.1));
    return out;
}

TailPassage passage(double off) { return passage_of(beside(off), k_section); }

} // namespace

TEST_CASE("a strand passes a tie within 1.3 radii and is of its region within three") {
    for (const double off : {0.0, 0.9, 1.29}) {
        CHECK(passage(off).passes);
        CHECK(passage(off).reaches);
        CHECK(passage(off).at == 20); // the first point beyond the plane
    }
    for (const double off : {1.31, 2.9}) {
        CHECK(!passage(off).passes);
        CHECK(passage(off).reaches);
        CHECK(passage(off).at == -1);
    }
    CHECK(!passage(3.1).reaches);
}

TEST_CASE("rooted beyond the plane, running the other way, or without a tie, nothing is passed") {
    std::vector<Vector3d> back = beside(0);
    std::reverse(back.begin(), back.end());
    for (const TailPassage& none : {passage_of(back, k_section), passage_of({}, k_section), passage_of(beside(0), {{0, 0, 0}, {0, 0, 1}, 0})}) {
        CHECK(!none.reaches);
        CHECK(!none.passes);
        CHECK(none.at == -1);
    }
}

TEST_CASE("detail is held up to the tie and comes back beyond it") {
    const TailTie tie({k_section});
    const std::vector<double> held = tie.looseness(beside(0.5), 0.25), free = tie.looseness(beside(2), 0.25);
    for (int k = 0; k <= 20; ++k) CHECK(held[static_cast<std::size_t>(k)] == doctest::Approx(held[0]));
    CHECK(held[0] < 0.5);
    CHECK(held[0] > 0);
    CHECK(std::is_sorted(held.begin(), held.end()));
    CHECK(tie.looseness(beside(0.5), 0.5).back() == 1); // ten radii beyond
    for (const double loose : free) CHECK(loose == 1);
    for (const double loose : TailTie({}).looseness(beside(0.5), 0.25)) CHECK(loose == 1);
}

TEST_CASE("what crosses near a tie is drawn into it, its root and the rest are not") {
    const TailTie tie({k_section});
    double before = -1;
    for (const double off : {0.0, 0.3, 0.8, 1.5, 2.0}) {
        std::vector<Vector3d> points = beside(off);
        tie.draw(points);
        const double out = points[20].head<2>().norm();
        CHECK(out <= 1);
        CHECK(out > before); // what lay farther out still does
        before = out;
        CHECK(points[0] == beside(off)[0]);
        CHECK(points.back() == beside(off).back());
        for (std::size_t k = 0; k < points.size(); ++k) CHECK(points[k].z() == beside(off)[k].z());
    }
    std::vector<Vector3d> far = beside(4.1);
    tie.draw(far);
    CHECK(far == beside(4.1));
}

TEST_CASE("the unit of length does not matter") {
    const TailTie small({{{0, 0, 0}, {0, 0, 1}, 1e-3}}), one({k_section});
    std::vector<Vector3d> a = beside(0.8), b = beside(0.8, 1e-3);
    one.draw(a);
    small.draw(b);
    const std::vector<double> p = one.looseness(beside(0.8), 0.25), q = small.looseness(beside(0.8, 1e-3), 0.25e-3);
    for (std::size_t k = 0; k < a.size(); ++k) {
        CHECK((a[k] - 1e3 * b[k]).norm() < 1e-12);
        CHECK(p[k] == doctest::Approx(q[k]));
    }
}
