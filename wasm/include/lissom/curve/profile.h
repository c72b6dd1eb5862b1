#pragma once

#include <vector>

namespace lissom {

/// A value along a curve, given at its control points: the monotone cubic through them (Fritsch and Carlson 1980). It never leaves the
/// range of neighbouring values, so a twist does not swing past what was asked for. Linear interpolation, as Blanco 5.3 has it, leaves kinks
/// in a twisted limb; level at both ends, as it goes on beyond them (a twist that begins at once creases the rim: 5.8 degrees where 1.4 are the rest); the cubic's slope is up to 1.5 times as steep in between.
class MonotoneProfile {
public:
    /// @param places  ascending; equal neighbours are a step
    /// @param values  as many
    MonotoneProfile(std::vector<double> places, std::vector<double> values);
    /// Constant beyond the ends.
    [[nodiscard]] double at(double place) const;

private:
    std::vector<double> places_, values_, slopes_;
};

} // namespace lissom
