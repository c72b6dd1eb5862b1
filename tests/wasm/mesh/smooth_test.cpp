#include "lissom/mesh/smooth.h"

#include <doctest/doctest.h>

using lissom::smooth;

TEST_CASE("from nothing to all of it, level at both ends and beyond, alike from either side") {
    CHECK(smooth(-3) == 0);
    CHECK(smooth(0) == 0);
    CHECK(smooth(1) == 1);
    CHECK(smooth(7) == 1);
    for (const double t : {0.1, 0.3, 0.5, 0.77}) {
        CHECK(smooth(t) + smooth(1 - t) == doctest::Approx(1));
        CHECK(smooth(t) > smooth(t - 0.05));
    }
    CHECK(smooth(1e-4) < 1e-7);
}
