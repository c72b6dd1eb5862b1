#include "lissom/curve/ownership.h"

#include "shapes.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace lissom;

namespace {

std::vector<int> halves(const TriangleMesh& mesh, double border = 5) {
    std::vector<int> owner;
    for (int v = 0; v < mesh.vertex_count(); ++v) owner.push_back(mesh.points(v, 1) < border ? 3 : 7);
    return owner;
}

std::vector<double> wide(const TriangleMesh& mesh, double rho) { return std::vector<double>(static_cast<std::size_t>(mesh.vertex_count()), rho); }

double share_of(const OwnerShares& shares, int v, int owner) {
    for (int k = shares.offsets[v]; k < shares.offsets[v + 1]; ++k)
        if (shares.owners[k] == owner) return shares.shares[k];
    return 0;
}

void check_partition(const OwnerShares& shares, int n) {
    REQUIRE(static_cast<int>(shares.offsets.size()) == n + 1);
    for (int v = 0; v < n; ++v) {
        double sum = 0;
        for (int k = shares.offsets[v]; k < shares.offsets[v + 1]; ++k) {
            CHECK(shares.shares[k] > 0);
            sum += shares.shares[k];
        }
        CHECK(sum == doctest::Approx(1));
        CHECK(shares.offsets[v + 1] - shares.offsets[v] <= OwnerShares::k_most);
    }
}

} // namespace

TEST_CASE("shares of either kind are a partition that fades across the border over its width") {
    const TriangleMesh mesh = shapes::box(4, 80, 4, {1, 10, 1});
    const std::vector<int> owner = halves(mesh);
    for (const bool diffused : {true, false}) {
        const OwnerShares shares = diffused ? diffused_shares(mesh, owner, wide(mesh, 0.5)) : geodesic_shares(mesh, owner, wide(mesh, 1));
        check_partition(shares, mesh.vertex_count());
        for (int v = 0; v < mesh.vertex_count(); ++v) {
            const double y = mesh.points(v, 1), share = share_of(shares, v, 3);
            if (std::abs(y - 5) < 0.2) CHECK(std::abs(share - 0.5) < 0.3);
            if (y < 1) CHECK(share == 1);
            if (y > 9) CHECK(share == 0);
        }
    }
}

TEST_CASE("diffused shares do not know the unit") {
    const TriangleMesh mesh = shapes::box(4, 40, 4, {1, 10, 1});
    const TriangleMesh large = shapes::moved(mesh, Eigen::Affine3d(Eigen::Scaling(1e4)));
    const OwnerShares a = diffused_shares(mesh, halves(mesh), wide(mesh, 0.5)), b = diffused_shares(large, halves(mesh), wide(mesh, 0.5e4));
    for (int v = 0; v < mesh.vertex_count(); ++v) CHECK(share_of(a, v, 3) == doctest::Approx(share_of(b, v, 3)).epsilon(1e-6));
}

TEST_CASE("one owner has all, and five around a place leave the four largest") {
    const TriangleMesh sheet = shapes::sheet(20, 20);
    const OwnerShares whole = diffused_shares(sheet, std::vector<int>(sheet.vertex_count(), 2), wide(sheet, 0.1));
    for (const double share : whole.shares) CHECK(share == 1);
    std::vector<int> sectors;
    for (int v = 0; v < sheet.vertex_count(); ++v)
        sectors.push_back(static_cast<int>((std::atan2(sheet.points(v, 1) - sheet.points.col(1).mean(), sheet.points(v, 0) - sheet.points.col(0).mean()) + 3.2) / 6.4 * 5));
    check_partition(diffused_shares(sheet, sectors, wide(sheet, 0.3)), sheet.vertex_count());
}

TEST_CASE("islands of an owner go to those around them, pieces of their own stay") {
    const TriangleMesh bar = shapes::box(4, 40, 4, {1, 10, 1});
    const TriangleMesh mesh = shapes::joined({bar, shapes::moved(shapes::icosphere(1), Eigen::Affine3d(Eigen::Translation3d(5, 30, 0)))});
    std::vector<int> owner = halves(mesh), wanted = owner;
    for (int v = 0; v < bar.vertex_count(); ++v)
        if (mesh.points(v, 1) < 2.1 && mesh.points(v, 1) > 1.4) owner[v] = 7; // an island in the lower half
    for (int v = bar.vertex_count(); v < mesh.vertex_count(); ++v) owner[v] = wanted[v] = 3;
    CHECK(joined_owners(vertex_rings(mesh), owner) == wanted);
}
