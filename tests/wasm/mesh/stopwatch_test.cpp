#include "lissom/mesh/stopwatch.h"

#include <doctest/doctest.h>

using lissom::Stopwatch;

TEST_CASE("laps follow on one another without gap or overlap") {
    using Clock = std::chrono::steady_clock;
    const auto seconds = [](Clock::duration d) { return std::chrono::duration<double>(d).count(); };
    const auto before = Clock::now();
    Stopwatch watch;
    const auto made = Clock::now();
    double sum = 0;
    auto asked = made;
    for (int lap = 0; lap < 3; ++lap) {
        const auto start = Clock::now();
        while (Clock::now() - start < std::chrono::milliseconds(2)) {}
        asked = Clock::now();
        const double took = watch.lap();
        CHECK(took >= 0.002);
        sum += took;
    }
    CHECK(sum <= seconds(Clock::now() - before));
    CHECK(sum >= seconds(asked - made));
}
