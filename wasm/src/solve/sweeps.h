#pragma once

#include "strips.h"
#include "supernodes.h"

#include <memory>

namespace lissom::solve {

/// L and what says where its numbers stand.
struct Factor {
    Supernodes supernodes;
    std::vector<std::size_t> panel_offsets; ///< per supernode, in doubles
    std::unique_ptr<double[]> numbers;      ///< panels, see PanelShape

    [[nodiscard]] PanelShape shape(int s) const { return {supernodes.width(s), supernodes.height(s)}; }
};

/// X ← (L Lᵀ)⁻¹ X in elimination order, all columns in one pass down and one pass up, so that the factor is
/// read twice whatever k is. Each column's arithmetic is the same whatever stands beside it.
///
/// @param X  n×k, row-major
/// @param k  1 to 4
void solve_sweeps(const Factor& factor, double* X, int k);

} // namespace lissom::solve
