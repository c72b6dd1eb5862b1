#pragma once

#include "strips.h"

namespace lissom::solve {

/// Columns factored together before the rest of the front is updated: one slice of work.
constexpr int k_block_columns = 64;

/// One supernode's dense matrix, symmetric, lower part only: `panel` (its columns, PanelShape) and
/// `update`, the `height`×`height` triangle that is passed on to the parent (triangle_size doubles).
struct Front {
    PanelShape shape;
    double* panel;
    double* update;
};

/// Adds a child's update matrix into a front.
/// @param place  for each of the child's `rows`, its row in the front (ascending)
void extend_add(const Front& front, const double* child_update, int rows, const int* place);

/// A pivot that is not positive.
struct Breakdown {
    int column = -1; ///< within the front; −1: none
    double pivot = 0;
};

/// Factors the columns [begin, begin + k_block_columns) of a front and updates all that follows them.
/// `begin` is a multiple of k_block_columns; the blocks before it are done.
[[nodiscard]] Breakdown factor_block(const Front& front, int begin);

/// Multiply-adds of factor_block, about.
[[nodiscard]] double block_work(PanelShape shape, int begin);

} // namespace lissom::solve
