#include "lissom/mesh/chance.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace lissom;

TEST_CASE("the bits are splitmix64's") { // the first numbers of its published sequence from seed 0
    static_assert(hash_bits(0) == 0xe220a8397b1dcdafu);
    static_assert(hash_bits(0x9e3779b97f4a7c15u) == 0x6e789e6aa1b965f4u);
    CHECK(hash_bits(2 * 0x9e3779b97f4a7c15u) == 0x06c45d188009454fu);
}

TEST_CASE("a chance lies in [0, 1), whatever the bits") {
    CHECK(unit(0) == 0);
    CHECK(unit(~std::uint64_t{0}) < 1);
    CHECK(unit(std::uint64_t{1} << 63) == 0.5);
    CHECK(chance(1, 2, 3) == unit(hash_bits(1, 2, 3)));
}

TEST_CASE("seed, strand and purpose each make another number") {
    CHECK(hash_bits(1, 2, 3) != hash_bits(2, 1, 3));
    CHECK(hash_bits(1, 2, 3) != hash_bits(1, 3, 2));
    CHECK(hash_bits(1, 2, 3) != hash_bits(1, 2, 4));
}

TEST_CASE("chances are spread evenly, and those of neighbours and of two purposes have nothing in common") {
    const int n = 20000;
    double mean = 0, square = 0, neighbours = 0, purposes = 0;
    for (std::uint64_t i = 0; i < n; ++i) {
        const double u = chance(7, i, 1) - 0.5;
        mean += u / n;
        square += u * u / n;
        neighbours += u * (chance(7, i + 1, 1) - 0.5) / n;
        purposes += u * (chance(7, i, 2) - 0.5) / n;
    }
    const double sure = 5 / std::sqrt(static_cast<double>(n)); // five standard deviations, of which each is below 1/√n
    CHECK(std::abs(mean) < 0.29 * sure);
    CHECK(std::abs(square - 1.0 / 12) < 0.075 * sure);
    CHECK(std::abs(neighbours) < sure / 12);
    CHECK(std::abs(purposes) < sure / 12);
}
