#include "lissom/mesh/errors.h"

#include <doctest/doctest.h>

using namespace lissom;

TEST_CASE("a refusal carries its sentence for people and its code for programs") {
    try {
        throw InvalidInput("no-faces", "The model has no faces. Choose one that has.");
    } catch (const std::runtime_error& error) {
        CHECK(std::string(error.what()) == "The model has no faces. Choose one that has.");
        const auto* refused = dynamic_cast<const InvalidInput*>(&error);
        REQUIRE(refused != nullptr);
        CHECK(refused->code() == "no-faces");
    }
}

TEST_CASE("numbers that refuse are told apart from input that can be mended") {
    const auto caught = [](auto&& raise) -> std::string {
        try {
            raise();
        } catch (const InvalidInput&) {
            return "input";
        } catch (const SolverFailure& error) {
            return error.what();
        }
        return "nothing";
    };
    CHECK(caught([] { throw SolverFailure("pivot 3 is not positive"); }) == "pivot 3 is not positive");
    CHECK(caught([] { throw InvalidInput("a", "b"); }) == "input");
}
