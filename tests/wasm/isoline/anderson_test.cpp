#include "lissom/isoline/anderson.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>

#include <cmath>

using lissom::Anderson;

namespace {

/// A slow linear map with fixed point (1, 2, 3, …): rate 0.97.
Eigen::VectorXd slow(const Eigen::VectorXd& x) {
    Eigen::VectorXd image(x.size());
    for (Eigen::Index k = 0; k < x.size(); ++k) image[k] = k + 1 + (0.97 - 0.1 * static_cast<double>(k)) * (x[k] - static_cast<double>(k + 1));
    return image;
}

int iterations(int memory) {
    Anderson anderson(memory);
    Eigen::VectorXd x = Eigen::VectorXd::Zero(4);
    for (int k = 0; k < 2000; ++k) {
        const Eigen::VectorXd image = slow(x);
        if ((image - x).norm() < 1e-9) return k;
        x = anderson.next(x, image);
    }
    return 2000;
}

} // namespace

TEST_CASE("without memory it is the plain iteration") {
    Anderson plain(0);
    const Eigen::VectorXd x = Eigen::VectorXd::Ones(4);
    CHECK(plain.next(x, slow(x)) == slow(x));
    CHECK(plain.next(slow(x), slow(slow(x))) == slow(slow(x)));
}

TEST_CASE("a linear map is at its fixed point after as many steps as it has rates") {
    CHECK(iterations(0) > 500);
    CHECK(iterations(5) < 12);
}

TEST_CASE("a residual that has doubled makes it start afresh") {
    Anderson anderson(5);
    Eigen::VectorXd x = Eigen::VectorXd::Zero(2), image = Eigen::VectorXd::Constant(2, 1);
    (void)anderson.next(x, image);
    x = image;
    image = Eigen::VectorXd::Constant(2, 5); // residual 4 after 1
    CHECK(anderson.next(x, image) == image);
}

TEST_CASE("a residual of zero stays where it is") {
    Anderson anderson(5);
    const Eigen::VectorXd x = Eigen::VectorXd::Constant(3, 2);
    CHECK(anderson.next(x, x) == x);
    CHECK(anderson.next(x, x) == x);
}
