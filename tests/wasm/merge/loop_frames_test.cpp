#include "lissom/merge/loop_frames.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

using namespace lissom;
using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

constexpr int k_count = 48;

/// A wavy loop with normals that lean out of it.
struct Loop {
    Points points{k_count, 3}, normals{k_count, 3};
    Loop() {
        for (int k = 0; k < k_count; ++k) {
            const double a = 2 * std::numbers::pi * k / k_count;
            points.row(k) << (1 + 0.2 * std::cos(2 * a)) * std::cos(a), 0.15 * std::sin(3 * a), std::sin(a);
            normals.row(k) = Eigen::RowVector3d(std::cos(a), 0.4, std::sin(a)).normalized();
        }
    }
    [[nodiscard]] Loop moved(double scale, const Matrix3d& turn, const Vector3d& by) const {
        Loop out = *this;
        out.points = (scale * points * turn.transpose()).rowwise() + by.transpose();
        out.normals = normals * turn.transpose();
        return out;
    }
};

LoopMatch one_by_one() {
    std::vector<int> source(k_count);
    std::iota(source.begin(), source.end(), 0);
    std::vector<int> target(source.rbegin(), source.rend());
    std::rotate(target.begin(), target.end() - 1, target.end()); // vertex 0 first
    return match_one_by_one(source, target);
}

LoopImage image(const Loop& source, const Loop& target) {
    return image_of_loop(one_by_one(), source.points, source.normals, target.points, target.normals);
}

} // namespace

TEST_CASE("a loop carried to where a similarity takes it turns and grows by that similarity at every place") {
    const Loop loop;
    const Matrix3d turn = Eigen::AngleAxisd(2.1, Vector3d(1, -1, 2).normalized()).toRotationMatrix();
    for (const double scale : {1e-4, 1.0, 50.0}) {
        const Loop there = loop.moved(scale, turn, {3, 4, 5});
        const LoopImage found = image(loop, there);
        REQUIRE(found.rotation.size() == k_count);
        for (int i = 0; i < k_count; ++i) {
            CHECK((found.positions.row(i) - there.points.row(i)).norm() < 1e-12);
            CHECK((found.rotation[i] - turn).norm() < 1e-9);
            CHECK(found.scale[i] == doctest::Approx(scale));
        }
    }
}

TEST_CASE("frames are rotations, and they carry tangents to tangents, whatever the two loops") {
    const Loop source;
    Loop target = source;
    for (int k = 0; k < k_count; ++k) target.points.row(k) << 2 * source.points(k, 0), source.points(k, 2), 0.5 * source.points(k, 1);
    for (int k = 0; k < k_count; ++k) target.normals.row(k) = Eigen::RowVector3d(0.2, 0.1, 1).normalized();
    const LoopImage found = image(source, target);
    for (int i = 0; i < k_count; ++i) {
        const Matrix3d& R = found.rotation[i];
        CHECK((R.transpose() * R - Matrix3d::Identity()).norm() < 1e-12);
        CHECK(R.determinant() == doctest::Approx(1));
        const int next = (i + 1) % k_count, before = (i + k_count - 1) % k_count;
        const Vector3d from = source.points.row(next) - source.points.row(before), to = target.points.row(next) - target.points.row(before);
        CHECK((R * from.normalized() - to.normalized()).norm() < 1e-9);
        CHECK(found.scale[i] == doctest::Approx(to.norm() / from.norm()));
    }
}

TEST_CASE("places without a frame take the turn of the whole loop") {
    Loop loop;
    const Matrix3d turn = Eigen::AngleAxisd(0.7, Vector3d(0, 1, 1).normalized()).toRotationMatrix();
    const Loop there = loop.moved(3, turn, {0, 0, 1});
    loop.normals.row(5).setZero();                                                                 // no normal
    loop.normals.row(9) = (loop.points.row(10) - loop.points.row(8)).normalized(); // one along the loop
    const LoopImage found = image(loop, there);
    for (const int i : {5, 9}) {
        CHECK((found.rotation[i] - turn).norm() < 1e-9);
        CHECK(found.scale[i] == doctest::Approx(3));
    }
}
