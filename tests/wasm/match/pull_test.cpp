#include "lissom/match/pull.h"

#include <doctest/doctest.h>

using lissom::Pull;

TEST_CASE("a pull at a vertex is all that vertex's") {
    const Pull pull = Pull::of_vertex(7, {1, 2, 3}, 0.5);
    CHECK(pull.is_vertex());
    CHECK(pull.weights.sum() == 1);
    CHECK(pull.weight == 0.5);
    CHECK_FALSE(Pull{{1, 2, 3}, {0.2, 0.3, 0.5}, {0, 0, 0}}.is_vertex());
}
