#include "lissom/isoline/field_basis.h"

#include "refusal.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <vector>

using namespace lissom;

namespace {

double valued(const FieldBasis& basis, double field, double (*of)(const FieldBasis&, int)) {
    const FieldBasis::Weights w = basis.weights(field);
    double sum = 0;
    for (int q = 0; q < w.count; ++q) sum += w.value[q] * of(basis, w.first + q);
    return sum;
}

std::vector<FieldBasis> bases() {
    return {{BasisKind::quadratic, 3}, {BasisKind::quadratic, 4}, {BasisKind::quadratic, 10}, {BasisKind::hats, 2}, {BasisKind::hats, 20}};
}

} // namespace

TEST_CASE("the controls share one everywhere, and reproduce the field itself at their abscissae") {
    for (const FieldBasis& basis : bases())
        for (double field = 0; field <= 1; field += 1.0 / 64) {
            const FieldBasis::Weights w = basis.weights(field);
            CHECK(w.first >= 0);
            CHECK(w.first + w.count <= basis.controls());
            for (int q = 0; q < w.count; ++q) CHECK(w.value[q] >= -1e-15);
            CHECK(valued(basis, field, [](const FieldBasis&, int) { return 1.0; }) == doctest::Approx(1).epsilon(1e-14));
            CHECK(std::abs(valued(basis, field, [](const FieldBasis& b, int j) { return b.abscissa(j); }) - field) < 1e-14);
        }
}

TEST_CASE("one control alone decides each end") {
    for (const FieldBasis& basis : bases()) {
        const FieldBasis::Weights low = basis.weights(0), high = basis.weights(1);
        CHECK(low.first == 0);
        CHECK(low.value[0] == 1);
        CHECK(high.first + high.count == basis.controls());
        CHECK(high.value[high.count - 1] == 1);
    }
}

TEST_CASE("slopes are the differences of values, and the spline has no corner") {
    for (const FieldBasis& basis : bases()) {
        std::vector<double> left(static_cast<std::size_t>(basis.controls())), right = left, slope = left;
        for (double field = 0.013; field < 0.98; field += 0.037) {
            const double h = 1e-7;
            for (auto* out : {&left, &right, &slope}) std::fill(out->begin(), out->end(), 0.0);
            const auto a = basis.weights(field - h), b = basis.weights(field + h), m = basis.weights(field);
            for (int q = 0; q < m.count; ++q) {
                left[a.first + q] = a.value[q];
                right[b.first + q] = b.value[q];
                slope[m.first + q] = m.slope[q];
            }
            for (std::size_t j = 0; j < left.size(); ++j)
                if (basis.kind() == BasisKind::quadratic || a.first == b.first) CHECK(std::abs((right[j] - left[j]) / (2 * h) - slope[j]) < 1e-4);
        }
    }
}

TEST_CASE("two fields that mirror each other share one set, three have one each") {
    std::vector<ControlSets::Entry> entries;
    const ControlSets two{FieldBasis(BasisKind::quadratic, 10), 2};
    CHECK(two.controls() == 10);
    CHECK(two.end_control(0) == 0);
    CHECK(two.end_control(1) == 9);
    two.entries_at(std::array{1.0, 0.0}, entries);
    CHECK(entries.front().control == 0);
    CHECK(entries.front().weight == 1);

    const ControlSets three{FieldBasis(BasisKind::quadratic, 10), 3};
    CHECK(three.controls() == 30);
    three.entries_at(std::array{0.25, 0.75, 0.0}, entries);
    double sum = 0;
    for (const auto& e : entries) {
        CHECK(e.control < 20);
        sum += e.weight;
    }
    CHECK(sum == doctest::Approx(1).epsilon(1e-14));
    three.entries_at(std::array{0.0, 1.0, 0.0}, entries);
    CHECK(entries.back().control == three.end_control(1));
    CHECK(entries.back().weight == 1);
}

TEST_CASE("too few controls are refused") {
    CHECK(refusal([] { (void)FieldBasis(BasisKind::quadratic, 2); }) == "bad-option");
    CHECK(refusal([] { (void)FieldBasis(BasisKind::hats, 1); }) == "bad-option");
    CHECK(refusal([] { (void)FieldBasis(BasisKind::hats, 1000); }) == "bad-option");
}
