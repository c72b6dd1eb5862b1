#include "lissom/curve/profile.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace lissom;

TEST_CASE("a profile passes through its values, never past them, and is smooth") {
    const std::vector<double> places{0, 1, 1.2, 3, 4}, values{0, 90, 90, -20, 10};
    const MonotoneProfile profile(places, values);
    for (std::size_t i = 0; i < places.size(); ++i) CHECK(profile.at(places[i]) == doctest::Approx(values[i]));
    for (std::size_t i = 0; i + 1 < places.size(); ++i)
        for (double u = 0; u <= 1; u += 0.01) {
            const double y = profile.at(places[i] + u * (places[i + 1] - places[i]));
            CHECK(y >= std::min(values[i], values[i + 1]) - 1e-12);
            CHECK(y <= std::max(values[i], values[i + 1]) + 1e-12);
        }
    for (const double place : {1.0, 1.2, 3.0}) { // one slope on either side
        const double h = 1e-6, left = (profile.at(place) - profile.at(place - h)) / h, right = (profile.at(place + h) - profile.at(place)) / h;
        CHECK(left == doctest::Approx(right).epsilon(1e-3));
    }
    CHECK(profile.at(-5) == 0);
    CHECK(profile.at(50) == 10);
}

TEST_CASE("even steps give a line but for level ends, equal values a level") {
    const MonotoneProfile line({0, 1, 2, 3}, {0, 10, 20, 30}), level({0, 1}, {7, 7}), one({2}, {5});
    for (double x = 1; x <= 2; x += 0.1) CHECK(line.at(x) == doctest::Approx(10 * x));
    CHECK(line.at(1e-4) < 1e-5);
    CHECK(line.at(3 - 1e-4) > 30 - 1e-5);
    CHECK(level.at(0.3) == doctest::Approx(7).epsilon(1e-14));
    CHECK(one.at(9) == 5);
}
