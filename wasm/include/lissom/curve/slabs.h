#pragma once

#include "lissom/curve/encoding.h"

#include <vector>

namespace lissom {

/// A vertex between two neighbouring planes of the thesis: coordinates in the frame of the first, and how far it is on its way to the second.
struct SlabPlace {
    int slab = 0;      ///< planes `slab` and `slab + 1`; −1: before the first, `SlabTable::k_planes − 1`: after the last
    double ratio = 0;  ///< r_m of Blanco Eq 5.4; beyond the ends α, a length
    double beta = 0, gamma = 0;
};

/// The encoding of the thesis, kept to compare with: 200 planes at equal steps of t, each vertex between two of them.
///
/// v′_m = v′_mp + r_m s′ u′_{k−1}, v′_mp = p′_{k−1} + β v′_{k−1} + γ w′_{k−1}, s′ = ((p′_k − v′_mp) · u′_k)/(u′_{k−1} · u′_k), signed.
/// Printed otherwise: Eq 5.5 has w for w′; Eq 5.6 multiplies by α_m(r_m) and takes an unsigned distance, which sends vertices of crossed
/// planes the wrong way. "The pair of planes that delimits it" is not unique, planes have no end: the slab is that of the nearest point.
/// Known limits: stairs under twist, for β and γ are those of one frame; unbounded where neighbouring planes are square to each other.
/// Source: Blanco 5.2.
class SlabTable {
public:
    static constexpr int k_planes = 200;

    explicit SlabTable(const EncodedCurve& curve);
    /// @param t  nearest parameter of x
    [[nodiscard]] SlabPlace place(const Eigen::Vector3d& x, double t) const;
    /// Planes of a posed curve, to be read by position().
    struct Planes {
        std::vector<CurveFrame> frames;
        std::vector<EncodedCurve::Across> across;
    };
    [[nodiscard]] Planes posed(const EncodedCurve& curve, const CurvePosture& posture) const;
    [[nodiscard]] static Eigen::Vector3d position(const Planes& planes, const SlabPlace& place);

private:
    std::vector<double> t_, lengths_;
    std::vector<CurveFrame> rest_;
};

} // namespace lissom
