#include "lissom/hair/scalp_shell.h"

#include "hair/egg.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <functional>

using namespace lissom;
using Eigen::Vector3d;

namespace {

const eggs::Grounds& grounds() {
    static const eggs::Grounds made;
    return made;
}
std::vector<int> shell(double near, std::size_t limit = 100'000) {
    return scalp_shell(grounds().volume.field, grounds().head, grounds().roots.points(), near, limit);
}

} // namespace

TEST_CASE("the shell is what lies about the skin near the scalp, each node once and ascending") {
    const Grid& grid = grounds().volume.field;
    const Points& scalp = grounds().roots.points();
    const std::vector<int> nodes = shell(0.03);
    CHECK(std::is_sorted(nodes.begin(), nodes.end(), std::less_equal<>()));
    CHECK(nodes.size() > 50);
    for (const int node : nodes) {
        const Vector3d p = grid.position(node);
        CHECK(std::abs(grounds().head.at(p)) < 1.5 * grid.step);
        CHECK((scalp.rowwise() - p.transpose()).rowwise().norm().minCoeff() < 0.03 + 1.5 * grid.step);
    }
    // And nothing is left out: nodes just over the scalp are all there.
    for (int node = 0; node < grid.count(); ++node) {
        const Vector3d p = grid.position(node);
        const double distance = grounds().head.at(p) / grid.step;
        if (distance > 0 && distance < 1 && (scalp.rowwise() - p.transpose()).rowwise().norm().minCoeff() < 0.03)
            CHECK(std::binary_search(nodes.begin(), nodes.end(), node));
    }
}

TEST_CASE("the farther the shell may go, the more of the face it covers") {
    const std::vector<int> near = shell(0), far = shell(0.1);
    CHECK(near.size() < far.size());
    CHECK(std::includes(far.begin(), far.end(), near.begin(), near.end()));
}

TEST_CASE("more nodes than the limit are thinned, evenly") {
    const std::vector<int> all = shell(0.1);
    for (const std::size_t limit : {all.size() / 2 + 20, all.size() / 5, all.size() / 40}) {
        const std::vector<int> some = shell(0.1, limit);
        CHECK(some.size() <= limit);
        CHECK(some.size() > limit / 8);
        CHECK(std::includes(all.begin(), all.end(), some.begin(), some.end()));
    }
    CHECK(shell(0.1, all.size()) == all);
}

TEST_CASE("what points into the head is asked to go along the skin, what does not keeps its way, both faintly") {
    const Grid& grid = grounds().volume.field;
    const std::vector<int> nodes = shell(0.03);
    Points field(static_cast<Eigen::Index>(nodes.size()), 3);
    for (std::size_t i = 0; i < nodes.size(); ++i) field.row(static_cast<Eigen::Index>(i)) << 0.2, i % 2 ? 1 : -1, 0.5;
    field.row(0).setZero();
    const std::vector<FieldConstraint> asked = shell_constraints(nodes, field, grid, grounds().head);
    REQUIRE(asked.size() == nodes.size());
    CHECK(asked[0].vector.isZero());
    int turned = 0;
    for (std::size_t i = 1; i < nodes.size(); ++i) {
        CHECK(asked[i].node == nodes[i]);
        CHECK(asked[i].vector.norm() == doctest::Approx(0.3));
        const Vector3d normal = grounds().head.gradient(grid.position(nodes[i])).normalized(), given = field.row(static_cast<Eigen::Index>(i));
        if (given.dot(normal) < 0) {
            ++turned;
            CHECK(std::abs(asked[i].vector.dot(normal)) < 1e-12);
            CHECK(asked[i].vector.dot(given) > 0);
        } else {
            CHECK((asked[i].vector - 0.3 * given.normalized()).norm() < 1e-12);
        }
    }
    CHECK(turned > 10);
}
