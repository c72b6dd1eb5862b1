#include "lissom/wear/part_paste.h"

#include "refusal.h"
#include "shapes.h"

#include "lissom/match/folds.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

using Eigen::Affine3d;
using Eigen::AngleAxisd;
using Eigen::Vector3d;
using lissom::PartHow;
using lissom::PartPaste;
using lissom::PartSpec;
using lissom::Points;
using lissom::TriangleMesh;

namespace {

/// A ball with a nose at +z, as high as asked.
TriangleMesh face(double height, double wave = 0) {
    TriangleMesh ball = shapes::icosphere(4);
    for (Eigen::Index v = 0; v < ball.points.rows(); ++v) {
        const Vector3d d = ball.points.row(v);
        const double away = std::acos(std::min(1.0, d.z()));
        ball.points.row(v) *= 1 + height * std::exp(-std::pow(away / 0.3, 2)) + wave * std::sin(4 * d.x()) * std::sin(3 * d.y());
    }
    return ball;
}

std::vector<int> around_nose(double reach) {
    const TriangleMesh ball = shapes::icosphere(4);
    std::vector<int> part;
    for (int v = 0; v < ball.vertex_count(); ++v)
        if (std::acos(std::min(1.0, ball.points(v, 2))) < reach) part.push_back(v);
    return part;
}

int tip() {
    Eigen::Index v = 0;
    face(1).points.col(2).maxCoeff(&v);
    return static_cast<int>(v);
}

Points pasted(const TriangleMesh& from, Points shape, const PartSpec& part) {
    PartPaste paste(from, part);
    while (paste.step()) {
    }
    paste.apply(shape);
    return shape;
}

} // namespace

TEST_CASE("a part of the shape itself changes nothing, however it is taken") {
    const TriangleMesh shape = face(0.4, 0.05);
    for (const PartHow how : {PartHow::paste, PartHow::low_pass})
        for (const double feather : {-1.0, 0.0, 0.3}) CHECK((pasted(shape, shape.points, {0, around_nose(0.5), feather, how}) - shape.points).cwiseAbs().maxCoeff() < 1e-7);
}

TEST_CASE("a nose is carried whole, and the surface stays smooth around it") {
    const TriangleMesh from = face(0.5, 0.02), onto = face(0, -0.04);
    const auto pairs = lissom::neighbouring_triangles(from);
    for (const PartHow how : {PartHow::paste, PartHow::low_pass}) {
        const Points result = pasted(from, onto.points, {0, around_nose(0.6), -1, how});
        CHECK(result.row(tip()).norm() == doctest::Approx(1.5).epsilon(0.05));
        CHECK(lissom::count_folds({result, from.triangles}, pairs, 0.5) <= lissom::count_folds(from, pairs, 0.5));
    }
}

TEST_CASE("whatever lies outside of a part and its feather stays bit for bit") {
    const TriangleMesh from = face(0.5), onto = face(0);
    PartPaste paste(from, {0, around_nose(0.4), 0.3, PartHow::paste});
    while (paste.step()) {
    }
    Points shape = onto.points;
    paste.apply(shape);
    std::vector<char> moved(static_cast<std::size_t>(shape.rows()), 0);
    for (const int v : paste.moved()) moved[static_cast<std::size_t>(v)] = 1;
    int changed = 0;
    for (Eigen::Index v = 0; v < shape.rows(); ++v)
        if (!moved[static_cast<std::size_t>(v)]) changed += shape.row(v) != onto.points.row(v);
    CHECK(changed == 0);
    for (const int v : around_nose(0.4)) CHECK(moved[static_cast<std::size_t>(v)]);
    CHECK(paste.moved().size() > around_nose(0.4).size());
}

TEST_CASE("where shapes are moved, turned and scaled the part goes along") {
    const TriangleMesh from = face(0.4), onto = face(0.1, 0.05);
    const Affine3d b(Eigen::Translation3d(3, -1, 2) * AngleAxisd(2, Vector3d(1, 2, 3).normalized()) * Eigen::Scaling(2.0));
    for (const PartHow how : {PartHow::paste, PartHow::low_pass}) {
        const PartSpec part{0, around_nose(0.5), -1, how};
        const TriangleMesh plain{pasted(from, onto.points, part), from.triangles};
        for (const double size : {1.0, 1e-5, 1e4}) {
            const Affine3d a(Eigen::Translation3d(0, 9 * size, 0) * AngleAxisd(0.8, Vector3d::UnitZ()) * Eigen::Scaling(size));
            const Points other = pasted(shapes::moved(from, a), shapes::moved(onto, b).points, part);
            CHECK((other - shapes::moved(plain, b).points).cwiseAbs().maxCoeff() < 1e-6);
        }
    }
}

TEST_CASE("pieces of a part each have their own place; open borders may belong to one") {
    const TriangleMesh sheet = shapes::bumpy_sheet(30, 30);
    std::vector<int> part;
    for (int v = 0; v < sheet.vertex_count(); ++v)
        if ((sheet.points.row(v) - sheet.points.row(0)).norm() < 0.25 || (sheet.points.row(v) - sheet.points.row(sheet.vertex_count() - 1)).norm() < 0.25) part.push_back(v);
    TriangleMesh higher = sheet;
    higher.points.col(2) *= 2;
    higher.points.col(0) *= 1.3;
    for (const double feather : {0.0, 0.2}) {
        const Points result = pasted(higher, sheet.points, {0, part, feather, PartHow::paste});
        CHECK(result.allFinite());
        CHECK((result - sheet.points).rowwise().norm().maxCoeff() < 0.3);
    }
}

TEST_CASE("parts that cannot be set in are refused") {
    const TriangleMesh shape = shapes::icosphere(2);
    std::vector<int> all(static_cast<std::size_t>(shape.vertex_count()));
    std::iota(all.begin(), all.end(), 0);
    const auto code = [&](const TriangleMesh& mesh, const PartSpec& part) { return refusal([&] { PartPaste(mesh, part); }); };
    CHECK(code(shape, {0, {}, 0, PartHow::paste}) == "empty-part");
    CHECK(code(shape, {0, all, 0, PartHow::paste}) == "whole-part");
    CHECK(code(shape, {0, {3}, 100, PartHow::paste}) == "whole-part");
    CHECK(code(shape, {0, {3, shape.vertex_count()}, 0, PartHow::paste}) == "vertex-out-of-range");
    CHECK(code(shape, {0, {3, -1}, 0, PartHow::paste}) == "vertex-out-of-range");
    CHECK(code(shapes::two_spheres(2), {0, all, 0, PartHow::paste}) == "whole-part"); // all of one of two pieces
    CHECK(code(shape, {0, {3}, std::numeric_limits<double>::quiet_NaN(), PartHow::paste}) == "bad-option");
}
