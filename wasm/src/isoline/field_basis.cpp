#include "lissom/isoline/field_basis.h"

#include "lissom/mesh/errors.h"

#include <algorithm>
#include <string>

namespace lissom {

FieldBasis::FieldBasis(BasisKind kind, int controls) : kind_(kind), controls_(controls) {
    const int least = kind == BasisKind::hats ? 2 : 3;
    if (controls < least || controls > 200)
        throw InvalidInput("bad-option", "The number of controls is " + std::to_string(controls) + "; it must be between " +
                                             std::to_string(least) + " and 200.");
}

FieldBasis::Weights FieldBasis::weights(double field) const {
    const double s = std::clamp(field, 0.0, 1.0);
    Weights w;
    if (kind_ == BasisKind::hats) {
        const int spans = controls_ - 1;
        w.first = std::min(static_cast<int>(s * spans), spans - 1);
        w.count = 2;
        const double a = s * spans - w.first;
        w.value = {1 - a, a, 0};
        w.slope = {-static_cast<double>(spans), static_cast<double>(spans), 0};
        return w;
    }
    const int spans = controls_ - 2;
    const int span = std::min(static_cast<int>(s * spans), spans - 1);
    const auto knot = [&](int k) { return std::clamp(static_cast<double>(k), 0.0, static_cast<double>(spans)); }; // in steps of 1/spans
    // Cox–de Boor with the field measured in spans.
    const double t = s * spans, left1 = t - span, right1 = span + 1 - t, left2 = t - knot(span - 1), right2 = knot(span + 2) - t;
    const double below = right1 + left2, above = right2 + left1; // lengths of the knot intervals that the linear functions share
    w.first = span;
    w.count = 3;
    w.value = {right1 * right1 / below, left2 * right1 / below + right2 * left1 / above, left1 * left1 / above};
    w.slope = {-2 * spans * right1 / below, 2 * spans * (right1 / below - left1 / above), 2 * spans * left1 / above};
    return w;
}

double FieldBasis::abscissa(int j) const {
    if (kind_ == BasisKind::hats) return static_cast<double>(j) / (controls_ - 1);
    const int spans = controls_ - 2;
    return 0.5 * (std::clamp(j - 1, 0, spans) + std::clamp(j, 0, spans)) / spans;
}

int ControlSets::end_control(int field) const {
    if (mirrored()) return field == 1 ? basis.controls() - 1 : 0;
    return field * basis.controls() + basis.controls() - 1;
}

void ControlSets::entries_at(std::span<const double> field, std::vector<Entry>& entries) const {
    entries.clear();
    for (int set = 0; set < sets(); ++set) {
        const double phi = field[static_cast<std::size_t>(field_of_set(set))];
        if (phi == 0 && !mirrored()) continue;
        const FieldBasis::Weights w = basis.weights(phi);
        for (int q = 0; q < w.count; ++q) {
            const int control = set * basis.controls() + w.first + q;
            if (mirrored()) entries.push_back({control, w.value[q], w.slope[q]});
            else entries.push_back({control, phi * w.value[q], w.value[q] + phi * w.slope[q]});
        }
    }
}

} // namespace lissom
