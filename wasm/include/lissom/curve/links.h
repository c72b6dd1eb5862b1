#pragma once

#include <Eigen/Geometry>

#include <span>
#include <vector>

namespace lissom {

/// A curve that hangs on another: it takes over the other's motion at that place.
struct CurveLink {
    int child = 0, parent = 0; ///< numbers of curves
    double at = 0;             ///< place on the parent, in [0, 1]
};

/// How linked curves are ordered. A merge of two control points is a link whose places coincide at rest.
struct LinkOrder {
    std::vector<int> order;  ///< all curves, each after its parent; else as given
    std::vector<int> link;   ///< per curve: the number of the link that it is the child of; −1: a root
    std::vector<int> root;   ///< per curve: the root of its tree
    /// Whether a curve has links at all.
    std::vector<bool> linked;
};

/// @throws InvalidInput `link-range` (a curve that is not there, a place outside [0, 1]), `link-twice` (two parents),
///                      `link-ring` (a curve would hang on itself)
[[nodiscard]] LinkOrder link_order(int curves, std::span<const CurveLink> links);

} // namespace lissom
