#include "lissom/merge/stitch.h"

#include "lissom/mesh/operators.h"
#include "tubes.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

using namespace lissom;
using tubes::stitched;
using tubes::Stitched;
using Eigen::Vector3d;

namespace {

const std::vector<std::pair<int, int>> k_sizes{{20, 31}, {31, 20}, {24, 24}, {5, 60}, {60, 5}};

double least_angle(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
    const auto at = [](const Vector3d& p, const Vector3d& q, const Vector3d& r) { return std::atan2((q - p).cross(r - p).norm(), (q - p).dot(r - p)); };
    return std::min({at(a, b, c), at(b, c, a), at(c, a, b)});
}

} // namespace

TEST_CASE("two parts with loops of any size become one closed manifold surface") {
    for (const auto& [n, m] : k_sizes) {
        CAPTURE(n);
        CAPTURE(m);
        tubes::check_closed(stitched(n, m).joined.mesh, 2); // a disk and a disk
    }
}

TEST_CASE("the target keeps its vertices to the last bit and its area, the source gives way") {
    for (const auto& [n, m] : k_sizes) {
        const Stitched s = stitched(n, m);
        const JoinedMesh& joined = s.joined;
        CHECK(joined.mesh.points.topRows(joined.target_vertices) == s.target.mesh.points);
        const Eigen::VectorXd areas = triangle_areas(joined.mesh);
        double area = 0;
        for (int t = 0; t < joined.mesh.triangle_count(); ++t)
            if (!joined.from_source[t]) area += areas[t];
        CHECK(area == doctest::Approx(triangle_areas(s.target.mesh).sum()));
    }
}

TEST_CASE("what the seam does not touch stays a triangle of its part, what it cuts knows where its corners lie") {
    const Stitched s = stitched(20, 31);
    const JoinedMesh& joined = s.joined;
    int made = 0;
    for (int t = 0; t < joined.mesh.triangle_count(); ++t) {
        const Part& part = joined.from_source[t] ? s.source : s.target;
        const auto vertex = [&](int v) { return joined.from_source[t] ? joined.vertex_of_source[v] : v; };
        CHECK((joined.made[t] >= 0) == (joined.is_new[t] != 0)); // both parts are whole here
        if (joined.made[t] < 0) {
            for (int c = 0; c < 3; ++c) CHECK(joined.mesh.triangles(t, c) == vertex(part.mesh.triangles(joined.part_triangle[t], c)));
            continue;
        }
        ++made;
        if (joined.from_source[t]) continue;
        for (int c = 0; c < 3; ++c) {
            const Origin& origin = joined.made_corners[joined.made[t]][static_cast<std::size_t>(c)];
            Eigen::RowVector3d place = Eigen::RowVector3d::Zero();
            for (std::size_t k = 0; k < 3; ++k) place += origin.weight[k] * s.target.mesh.points.row(origin.vertex[k]);
            CHECK((place - joined.mesh.points.row(joined.mesh.triangles(t, c))).norm() < 1e-12);
        }
    }
    CHECK(made > 0);
    CHECK(made < joined.mesh.triangle_count() / 3);
}

TEST_CASE("the seam is the match's points in their order, a walk along edges between the parts") {
    const Stitched s = stitched(20, 31);
    REQUIRE(s.joined.seams.size() == 1);
    const std::vector<int>& seam = s.joined.seams[0];
    CHECK(seam.size() == s.match.points.size());
    for (std::size_t k = 0; k < seam.size(); ++k) {
        const int a = seam[k], b = seam[(k + 1) % seam.size()];
        int left = 0, right = 0;
        for (int t = 0; t < s.joined.mesh.triangle_count(); ++t)
            for (int c = 0; c < 3; ++c) {
                const int from = s.joined.mesh.triangles(t, c), to = s.joined.mesh.triangles(t, (c + 1) % 3);
                left += from == a && to == b && s.joined.from_source[t];
                right += from == b && to == a && !s.joined.from_source[t];
            }
        CHECK(left == 1); // the source to the left
        CHECK(right == 1);
    }
}

TEST_CASE("the widest triangulation of a polygon has the largest least angle of all there are") {
    for (int seed = 0; seed < 10; ++seed) {
        std::vector<Vector3d> polygon;
        for (int k = 0; k < 6; ++k) {
            const double a = 2 * std::numbers::pi * k / 6 + 0.3 * std::sin(3.0 * seed + 5 * k), r = 1 + 0.2 * std::cos(7.0 * seed + 2 * k);
            polygon.emplace_back(r * std::cos(a), r * std::sin(a), 0.1 * std::sin(seed + k));
        }
        // Every triangulation: the triangle on the edge i–j has its third corner at any k between.
        const std::function<double(int, int)> best = [&](int i, int j) -> double {
            if (j - i < 2) return 10;
            double most = -10;
            for (int k = i + 1; k < j; ++k)
                most = std::max(most, std::min({best(i, k), best(k, j), least_angle(polygon[static_cast<std::size_t>(i)], polygon[static_cast<std::size_t>(k)], polygon[static_cast<std::size_t>(j)])}));
            return most;
        };
        double least = 10;
        const auto triangles = widest_triangulation(polygon, {0, 0, 1});
        CHECK(triangles.size() == 4);
        for (const auto& [a, b, c] : triangles) {
            const Vector3d &p = polygon[static_cast<std::size_t>(a)], &q = polygon[static_cast<std::size_t>(b)], &r = polygon[static_cast<std::size_t>(c)];
            CHECK((q - p).cross(r - p).z() > 0);
            least = std::min(least, least_angle(p, q, r));
        }
        CHECK(least >= best(0, 5) - 1e-3); // differences of rounding's size decide nothing
    }
}

TEST_CASE("a triangulation avoids triangles that face away, at the cost of thin ones") {
    const std::vector<Vector3d> arrow{{0, 0, 0}, {4, -1, 0}, {1, 0, 0}, {4, 1, 0}}; // its corner 2 points in
    const auto triangles = widest_triangulation(arrow, {0, 0, 1});
    REQUIRE(triangles.size() == 2);
    for (const auto& [a, b, c] : triangles) {
        const Vector3d &p = arrow[static_cast<std::size_t>(a)], &q = arrow[static_cast<std::size_t>(b)], &r = arrow[static_cast<std::size_t>(c)];
        CHECK((q - p).cross(r - p).z() > 0);
    }
}

TEST_CASE("a triangle with thousands of vertices on its sides is zipped into as many triangles, none turned or without area") {
    for (const std::array<int, 3>& inserted : {std::array<int, 3>{4000, 0, 0}, {3000, 2, 0}, {1500, 1500, 40}, {70, 70, 70}, {0, 1000, 3}}) {
        const std::array<Vector3d, 3> corner{Vector3d(0, 0, 0), Vector3d(3, 0, 0), Vector3d(1, 2, 0)};
        std::vector<Vector3d> polygon;
        std::array<int, 3> first{};
        for (int c = 0; c < 3; ++c) {
            first[c] = static_cast<int>(polygon.size());
            for (int k = 0; k <= inserted[c]; ++k) polygon.push_back(corner[c] + (corner[(c + 1) % 3] - corner[c]) * k / (inserted[c] + 1));
        }
        const int n = static_cast<int>(polygon.size());
        const auto longest = std::max_element(inserted.begin(), inserted.end()) - inserted.begin();
        const auto triangles = zipped(polygon, {first[longest], longest == 2 ? 0 : first[longest + 1]}, {0, 0, 1});
        CHECK(static_cast<int>(triangles.size()) == n - 2);
        double area = 0;
        int thin = 0;
        for (const auto& [a, b, c] : triangles) {
            const double twice = (polygon[b] - polygon[a]).cross(polygon[c] - polygon[a]).z();
            area += twice / 2;
            thin += !(twice > 1e-12);
        }
        CHECK(area == doctest::Approx(3));
        CHECK(thin == 0);
        CHECK(triangles == zipped(polygon, {first[longest], longest == 2 ? 0 : first[longest + 1]}, {0, 0, 1}));
    }
}
