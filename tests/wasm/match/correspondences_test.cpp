#include "lissom/match/correspondences.h"

#include "lissom/mesh/topology.h"
#include "shapes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace lissom;
using Eigen::Vector3d;

namespace {

Vector3d place_of(const Pull& pull, const Points& points) {
    Vector3d place = Vector3d::Zero();
    for (int k = 0; k < 3; ++k) place += pull.weights[k] * points.row(pull.vertices[k]).transpose();
    return place;
}

} // namespace

TEST_CASE("of two balls about one middle every place goes straight out, by its share of the area") {
    const FitSurface target(shapes::icosphere(4));
    const SurfacePlaces samples = sample_surface(target.mesh(), 500);
    Correspondences find(target, samples);
    TriangleMesh skin = shapes::icosphere(3);
    skin.points *= 0.9;
    for (int again = 0; again < 2; ++again) { // the second time with hints
        const auto pulls = find.find(skin, {0.3, 0.3, 0.5});
        REQUIRE(std::ssize(pulls) == skin.vertex_count() + 500);
        double forward = 0, reverse = 0;
        for (const Pull& pull : pulls) {
            const Vector3d place = place_of(pull, skin.points);
            CHECK(place.normalized().dot(pull.target.normalized()) > 0.999);
            CHECK((pull.target - place).norm() == doctest::Approx(0.1).epsilon(0.1));
            CHECK(pull.weights.sum() == doctest::Approx(1));
            (pull.is_vertex() ? forward : reverse) += pull.weight;
        }
        CHECK(forward / skin.vertex_count() == doctest::Approx(1).epsilon(0.02)); // but for the cosine
        CHECK(reverse / skin.vertex_count() == doctest::Approx(0.5));
    }
    CHECK(find.find(skin, {0.3, 0.05, 0.5}).empty());
    std::vector<char> out(static_cast<std::size_t>(skin.vertex_count()), 0);
    out[5] = 1;
    const auto without = find.find(skin, {0.3, 0.3, 0}, out);
    CHECK(std::ssize(without) == skin.vertex_count() - 1);
    CHECK(std::none_of(without.begin(), without.end(), [](const Pull& pull) { return pull.vertices[0] == 5; }));
}

TEST_CASE("only reverse pulls reach a tip") {
    TriangleMesh spiked = shapes::icosphere(4);
    for (int v = 0; v < spiked.vertex_count(); ++v)
        if (const double up = spiked.points(v, 2); up > 0.95) spiked.points.row(v) *= 1 + 8 * (up - 0.95);
    const FitSurface target(spiked);
    const TriangleMesh skin = shapes::icosphere(3);
    const double tip = spiked.points.col(2).maxCoeff();
    double forward = 0, reverse = 0;
    for (const Pull& pull : Correspondences(target, sample_surface(spiked, 4000)).find(skin, {0.1, 1, 0.5}))
        (pull.is_vertex() ? forward : reverse) = std::max(pull.is_vertex() ? forward : reverse, pull.target.z());
    CHECK(reverse > 0.97 * tip);
    CHECK(forward < 0.97 * tip);
}

TEST_CASE("border vertices go to the rim and no others do; without facing what faces away is found, too") {
    const FitSurface target(shapes::bumpy_sheet(20, 20));
    TriangleMesh skin = shapes::sheet(12, 12);
    const Eigen::RowVector3d middle = target.mesh().points.colwise().mean();
    skin.points = (1.1 * (skin.points.rowwise() - skin.points.colwise().mean())).rowwise() + middle; // reaches beyond the rim
    const std::vector<bool> border = boundary_vertices(skin), rim = boundary_vertices(target.mesh());
    Points low = target.mesh().points.colwise().minCoeff(), high = target.mesh().points.colwise().maxCoeff();
    int on_rim = 0;
    const auto find = [&](const TriangleMesh& mesh, bool facing) { return Correspondences(target, sample_surface(target.mesh(), 300), facing).find(mesh, {0.3, 0.5, 0}); };
    for (const Pull& pull : find(skin, true)) {
        const Vector3d& p = pull.target;
        const bool there = std::min({p.x() - low(0, 0), high(0, 0) - p.x(), p.y() - low(0, 1), high(0, 1) - p.y()}) < 1e-9;
        CHECK(there == border[pull.vertices[0]]);
        on_rim += there;
    }
    CHECK(on_rim == std::count(border.begin(), border.end(), true));
    CHECK(std::ssize(find(shapes::turned_inside_out(skin), true)) == on_rim); // the rim asks for no facing
}
