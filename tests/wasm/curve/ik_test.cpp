#include "lissom/curve/ik.h"

#include "posing.h"
#include "refusal.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace lissom;
using Eigen::Vector3d;

namespace {

Points chain() { return posing::row_list({{0, 0, 0}, {0, 1, 0}, {0.3, 2, 0}, {0.2, 3, 0.4}, {0, 4, 0}}); }

double length_change(const Points& a, const Points& b, int from, int to) {
    double most = 0;
    for (int i = from; i < to; ++i) most = std::max(most, std::abs((a.row(i + 1) - a.row(i)).norm() - (b.row(i + 1) - b.row(i)).norm()));
    return most;
}

} // namespace

TEST_CASE("the end reaches what it can reach, its segments as long as before") {
    for (const double unit : {1e-6, 1.0, 1e6})
        for (const Vector3d& to : {Vector3d(2, 2, 0), Vector3d(0, 0.5, 1), Vector3d(-3, 1, 1)}) {
            const Points rest = unit * chain();
            const Reached found = reached(rest, 4, unit * to);
            CHECK(found.reached);
            CHECK((found.points.row(4).transpose() - unit * to).norm() < 1e-6 * unit * 4);
            CHECK(found.points.row(0) == rest.row(0));
            CHECK(length_change(found.points, rest, 0, 4) < 1e-9 * unit);
        }
}

TEST_CASE("a target too far away stretches the chain straight towards it") {
    const Reached found = reached(chain(), 4, {10, 0, 0});
    CHECK_FALSE(found.reached);
    CHECK(found.points.col(1).cwiseAbs().maxCoeff() < 1e-12);
    CHECK(length_change(found.points, chain(), 0, 4) < 1e-12);
}

TEST_CASE("held points end the chain, what lies beyond the dragged one comes along") {
    const int held[] = {1};
    const Reached found = reached(chain(), 3, {1, 2.2, 0}, held);
    CHECK(found.points.row(0) == chain().row(0));
    CHECK(found.points.row(1) == chain().row(1));
    CHECK(length_change(found.points, chain(), 1, 4) < 1e-9);
    CHECK((found.points.row(4) - found.points.row(3) - chain().row(4) + chain().row(3)).norm() < 1e-12);
    CHECK(reached(chain(), 0, {1, 0, 0}).points.row(4) == chain().row(4)); // the first point drags the other way
}

TEST_CASE("a straight chain bends when its end is pushed along it") {
    const Points straight = posing::line({0, 0, 0}, {0, 4, 0}, 5);
    const Reached found = reached(straight, 4, {0, 2, 0});
    CHECK(found.reached);
    CHECK(length_change(found.points, straight, 0, 4) < 1e-9);
    CHECK(found.points.isApprox(reached(straight, 4, {0, 2, 0}).points));
    CHECK(reached(straight, 4, {0, 0, 0}).points.allFinite()); // onto its own root
}

TEST_CASE("points that are not there are refused") {
    CHECK(refusal([] { (void)reached(chain(), 5, {0, 0, 0}); }) == "no-such-control");
    const int held[] = {-1};
    CHECK(refusal([&] { (void)reached(chain(), 4, {0, 0, 0}, held); }) == "no-such-control");
    CHECK(refusal([] { (void)reached(chain(), 4, {0, std::nan(""), 0}); }) == "non-finite-curve");
}
