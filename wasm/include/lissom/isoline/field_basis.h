#pragma once

#include <array>
#include <span>
#include <vector>

namespace lissom {

enum class BasisKind {
    quadratic, ///< uniform quadratic B-spline, clamped at both ends: smooth with few controls
    hats       ///< piecewise linear between isolines at equal steps (Isolines 4.2)
};

/// A function of one field value in [0, 1] by its controls: at most three of them matter anywhere.
///
/// The values sum to one, and at 0 and 1 a single control is left, the first and the last.
class FieldBasis {
public:
    struct Weights {
        int first = 0;                 ///< control that value[0] belongs to
        int count = 0;                 ///< 2 or 3
        std::array<double, 3> value{}; ///< ≥ 0, sum 1
        std::array<double, 3> slope{}; ///< d value / d field, sum 0
    };

    /// @param controls  at least 3 for `quadratic`, 2 for `hats`
    /// @throws InvalidInput `bad-option`
    FieldBasis(BasisKind kind, int controls);

    [[nodiscard]] int controls() const { return controls_; }
    [[nodiscard]] BasisKind kind() const { return kind_; }
    /// @param field  clamped to [0, 1]
    [[nodiscard]] Weights weights(double field) const;
    /// Where control j acts most: Greville's abscissa. With it Σ abscissa(j) value_j = field.
    [[nodiscard]] double abscissa(int j) const;

private:
    BasisKind kind_;
    int controls_;
};

/// Which fields carry controls: x′ = Σ_i φ_i Σ_j b_j(φ_i) r_ij (x, 1), or with two fields in all, which mirror each
/// other, one set alone: x′ = Σ_j b_j(φ_1) r_j (x, 1) (Isolines 4.1).
struct ControlSets {
    FieldBasis basis;
    int fields = 0;

    struct Entry {
        int control;   ///< set · basis.controls() + j
        double weight; ///< of its transformation; all of them sum to the sum of the fields (one set: to 1)
        double slope;  ///< d weight / d field of its set
    };

    [[nodiscard]] bool mirrored() const { return fields == 2; }
    [[nodiscard]] int sets() const { return mirrored() ? 1 : fields; }
    [[nodiscard]] int field_of_set(int set) const { return mirrored() ? 1 : set; }
    [[nodiscard]] int controls() const { return sets() * basis.controls(); }
    /// The control that alone decides where field `field` is 1.
    [[nodiscard]] int end_control(int field) const;

    /// The controls of one vertex into `entries` (cleared first); fields of 0 are left out.
    /// @param field  `fields` values in [0, 1]
    void entries_at(std::span<const double> field, std::vector<Entry>& entries) const;
};

} // namespace lissom
