#include "lissom/deform/reconstruction.h"

#include <algorithm>

namespace lissom {
namespace {

constexpr double k_least_area = 1e-2; // of the mean: the row of a needle must not outweigh all others

void add_row(const HeldRegion& region, const SparseMatrix& L, int i, double weight, RowBuilder<1>& row) {
    using One = RowBuilder<1>::Value;
    for (SparseMatrix::InnerIterator entry(L, i); entry; ++entry) {
        const int k = static_cast<int>(entry.row());
        const double value = weight * entry.value();
        if (region.slot[k] < 0) continue;
        if (region.handle[k] < 0) {
            row.add(region.slot[k], One(value));
            continue;
        }
        const int column = region.handle_column(region.handle[k]);
        for (int d = 0; d < 3; ++d) row.add(column + d, One(value * region.mesh.points(k, d)));
        row.add(column + 3, One(value));
    }
}

} // namespace

Reconstruction reconstruction(const HeldRegion& region, const SparseMatrix& L, const Eigen::VectorXd& areas, RowPair* rows) {
    Reconstruction out;
    const double mean_area = areas.mean();
    EntryRows<1> left, right;
    RowBuilder<1> row(region.columns());
    std::vector<Eigen::Triplet<double>> details;
    for (int i = 0; i < region.mesh.vertex_count(); ++i) {
        const auto ring = region.rings[i];
        const bool counts = region.piece[i] >= 0 ||
                            std::any_of(ring.begin(), ring.end(), [&](int j) { return region.role[j] == Role::free; });
        if (!counts) continue;
        const double weight = mean_area / std::max(areas[i], k_least_area * mean_area);
        add_row(region, L, i, weight, row);
        row.append_to(left);
        add_row(region, L, i, 1, row);
        row.append_to(right);
        if (region.slot[i] < 0) continue;
        for (SparseMatrix::InnerIterator entry(L, i); entry; ++entry)
            if (const int k = static_cast<int>(entry.row()); region.role[k] == Role::free)
                details.emplace_back(region.slot[k], region.slot[i], weight * entry.value());
    }
    if (rows != nullptr) *rows = row_pair(left, right, region.unknowns, region.columns());
    else out.equations = normal_equations(left, right, region.unknowns, region.columns());
    out.T.resize(region.unknowns, region.slots());
    out.T.setFromTriplets(details.begin(), details.end());

    const Points delta = L * region.mesh.points;
    out.delta.resize(region.slots(), 3);
    for (int s = 0; s < region.slots(); ++s) out.delta.row(s) = delta.row(region.vertex_of_slot[s]);
    return out;
}

} // namespace lissom
