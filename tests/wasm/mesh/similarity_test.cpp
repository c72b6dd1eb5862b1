#include "lissom/mesh/similarity.h"

#include "shapes.h"

#include <doctest/doctest.h>

#include <Eigen/LU>

#include <cmath>

using namespace lissom;
using Eigen::Affine3d;
using Eigen::Vector3d;

namespace {

Affine3d some(double scale) {
    return Eigen::Translation3d(scale * Vector3d(3, -2, 7)) * Eigen::AngleAxisd(2.3, Vector3d(1, -2, 3).normalized()) * Eigen::Scaling(scale);
}
Points images(const Affine3d& map, const Points& points) { return shapes::moved({points, Triangles(0, 3)}, map).points; }

} // namespace

TEST_CASE("a similarity is found again from what it did, from every unit to every unit") {
    const Points from = shapes::bumpy_sphere(2).points;
    for (const double scale : {1e-6, 1.0, 1e6}) {
        CAPTURE(scale);
        const Affine3d map = some(scale);
        const Similarity found = fit_similarity(from, images(map, from));
        CHECK(found.scale == doctest::Approx(scale));
        CHECK((found.affine().matrix() - map.matrix()).topRows<3>().norm() < 1e-12 * map.matrix().topRows<3>().norm());
        CHECK(misfit(found, from, images(map, from)) < 1e-12);
    }
}

TEST_CASE("of a mirror image the best turn is returned, never a reflection") {
    const Points from = shapes::bumpy_sphere(2).points, to = images(Affine3d(Eigen::Scaling(-1.0, 1.0, 1.0)), from);
    const Similarity found = fit_similarity(from, to);
    CHECK(found.rotation.determinant() == doctest::Approx(1));
    CHECK(found.scale > 0);
}

TEST_CASE("nothing near the fit fits better") {
    const Points from = shapes::bumpy_sphere(1).points;
    Points to = images(some(2), from);
    for (int v = 0; v < to.rows(); ++v) to.row(v) += 0.3 * Eigen::RowVector3d(std::sin(3.0 * v), std::cos(5.0 * v), std::sin(7.0 * v + 1));
    const Similarity best = fit_similarity(from, to);
    const double least = misfit(best, from, to);
    CHECK(least > 0.01);
    for (int k = 0; k < 7; ++k)
        for (const double by : {-0.01, 0.01}) {
            Similarity other = best;
            if (k < 3) other.translation[k] += by;
            else if (k < 6) other.rotation = Eigen::AngleAxisd(by, Vector3d::Unit(k - 3)) * other.rotation;
            else other.scale *= 1 + by;
            CHECK(misfit(other, from, to) > least);
        }
}

TEST_CASE("the misfit has no unit") {
    const Points from = shapes::bumpy_sphere(1).points, to = shapes::box(2, 4, 2).points;
    const Points some_to = to.topRows(std::min(from.rows(), to.rows())), some_from = from.topRows(some_to.rows());
    const double here = misfit(fit_similarity(some_from, some_to), some_from, some_to);
    const Points large = 1e6 * some_to;
    CHECK(misfit(fit_similarity(some_from, large), some_from, large) == doctest::Approx(here));
}

TEST_CASE("points in one place or on one line still give a finite map that carries middle to middle") {
    Points line(5, 3), place(5, 3);
    for (int k = 0; k < 5; ++k) line.row(k) << k, 2 * k, 0;
    place.rowwise() = Eigen::RowVector3d(1, 2, 3);
    for (const auto& [from, to] : {std::pair{line, Points(images(some(2), line))}, {place, line}, {line, place}}) {
        const Similarity found = fit_similarity(from, to);
        CHECK(found.affine().matrix().allFinite());
        CHECK(found.scale > 0);
        CHECK((found.affine() * Vector3d(from.colwise().mean()) - Vector3d(to.colwise().mean())).norm() < 1e-12);
    }
    CHECK(misfit(fit_similarity(line, images(some(2), line)), line, images(some(2), line)) < 1e-12);
}
