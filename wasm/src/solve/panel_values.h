#pragma once

#include "supernodes.h"

#include <cstdint>

namespace lissom::solve {

/// The values of a matrix, sorted by supernode, and where each belongs in its panel.
class PanelValues {
public:
    PanelValues() = default;
    PanelValues(const SparseMatrix& A, const Supernodes& nodes);

    /// Copies the values of the lower triangle.
    /// @throws InvalidInput `pattern-changed`: other non-zeros than at construction
    /// @throws SolverFailure  a value is not finite
    void take(const SparseMatrix& A);

    /// Writes the values of supernode s into its panel, which is zero elsewhere.
    void place(int s, double* panel) const {
        for (std::size_t slot = offsets_[s]; slot < offsets_[s + 1]; ++slot)
            panel[destinations_[slot]] = values_[slot];
    }

private:
    int size_ = 0;
    std::uint64_t pattern_ = 0;
    std::vector<int> slots_; ///< per entry of the lower triangle, in storage order: index into the next two
    std::vector<double> values_;
    std::vector<std::uint32_t> destinations_;
    std::vector<std::size_t> offsets_; ///< per supernode
};

} // namespace lissom::solve
