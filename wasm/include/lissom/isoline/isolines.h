#pragma once

#include "lissom/mesh/types.h"

#include <Eigen/Core>

#include <vector>

namespace lissom {

/// Where an isoline crosses one triangle, the larger values to its left seen from outside.
struct IsolineSegment {
    int triangle = 0;
    Eigen::Vector3d from, to;
    double length = 0; ///< l_k of Isolines Eq 9
};

/// All points of one value, which may be several loops (and chains, where the surface has a boundary).
struct Isoline {
    double value = 0;
    std::vector<IsolineSegment> segments;       ///< by triangle, ascending
    std::vector<std::vector<int>> loops;        ///< segment numbers in the order they are walked; chains last, each once
    int closed = 0;                             ///< how many of `loops` are closed: the first ones
    [[nodiscard]] double length() const;
};

/// The isoline of one value. A vertex counts as above where field > value, so that one that passes exactly through
/// vertices crosses each triangle at most once.
/// @param field  one number a vertex
[[nodiscard]] Isoline isoline(const TriangleMesh& mesh, const Eigen::VectorXd& field, double value);

} // namespace lissom
