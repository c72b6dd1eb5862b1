#include "lissom/deform/implicit_system.h"

#include "lissom/mesh/operators.h"

#include <algorithm>
#include <cmath>

namespace lissom {
namespace {

using Eigen::Vector3d;

/// Strength of the term that gives an orientation to a piece that only points hold, against E_R of a piece
/// that turns once from end to end (which is about 1 whatever the resolution).
constexpr double k_rest_weight = 2e-2;

class Assembly {
public:
    Assembly(const HeldRegion& region, const SparseMatrix& L, const Eigen::VectorXd& areas, int coherence_ring)
        : region_(region), L_(L), areas_(areas), coherence_ring_(coherence_ring),
          mean_area_(areas.mean()), edge_(mean_edge_length(region.mesh)) {}

    ImplicitSystem run(std::span<const int> blended, double blend_weight, RowPair* rows) {
        find_gradients();
        express_gradients();
        const int columns = region_.columns();
        EntryRows<4> left, right;
        RowBuilder<4> row(columns);
        for (int i = 0; i < region_.mesh.vertex_count(); ++i) {
            if (!in_laplacian_energy(i)) continue;
            add_coherence(i, row); // first three numbers of an entry: Λ times the gradients
            add_laplacian(i, row); // the fourth: the row of E_L
            row.append_to(right);
            add_gradient(i, 1, row);
            add_laplacian(i, row);
            row.append_to(left);
        }
        add_blends(blended, std::sqrt(blend_weight), row, left, right);
        if (rows != nullptr) *rows = row_pair(left, right, region_.unknowns, columns);
        else out_.equations = normal_equations(left, right, region_.unknowns, columns);
        return std::move(out_);
    }

private:
    [[nodiscard]] bool solves_gradient(int i) const { return region_.piece[i] >= 0; }

    void find_gradients() {
        GradientNeeds needs;
        for (int i = 0; i < region_.mesh.vertex_count(); ++i) {
            needs.wanted.push_back(solves_gradient(i));
            needs.movable.push_back(region_.role[i] == Role::free);
        }
        out_.gradients = ring_gradients(region_.mesh, region_.rings, needs);
        laplacian_ = L_ * out_.gradients.rest; // δ of v′, up to the area
    }

    /// Whose map is the gradient of vertex i, if not its own ring's: a region handle's own vertices, and vertices
    /// of a piece without a single usable ring, which follow whatever holds it.
    [[nodiscard]] int prescribing_handle(int i) const {
        if (region_.role[i] == Role::region) return region_.handle[i];
        if (!solves_gradient(i) || out_.gradients.offsets[i] < out_.gradients.offsets[i + 1]) return -1;
        const HeldPiece& piece = region_.pieces[region_.piece[i]];
        if (piece.touches_fixed) return -1;
        if (!piece.region_handles.empty()) return piece.region_handles.front();
        return piece.pose >= 0 ? region_.handle_count + piece.pose : -1;
    }

    void express_gradients() {
        std::vector<Vector3d> coefficients;
        out_.offsets.push_back(0);
        for (int s = 0; s < region_.slots(); ++s) {
            const int i = region_.vertex_of_slot[s];
            out_.gradient_handle.push_back(prescribing_handle(i));
            for (int e = out_.gradients.offsets[i]; e < out_.gradients.offsets[i + 1]; ++e) {
                const int slot = region_.slot[out_.gradients.vertices[e]];
                if (slot < 0) continue;
                out_.slots.push_back(slot);
                coefficients.push_back(out_.gradients.coefficients.row(e).transpose());
            }
            out_.offsets.push_back(static_cast<int>(out_.slots.size()));
        }
        out_.coefficients.resize(static_cast<Eigen::Index>(coefficients.size()), 3);
        for (std::size_t e = 0; e < coefficients.size(); ++e) out_.coefficients.row(static_cast<Eigen::Index>(e)) = coefficients[e].transpose();

        for (const int i : out_.gradients.displaced) out_.displaced.push_back(region_.slot[i]);
        std::sort(out_.displaced.begin(), out_.displaced.end());
        out_.displacement.resize(static_cast<Eigen::Index>(out_.displaced.size()), 3);
        for (std::size_t k = 0; k < out_.displaced.size(); ++k) {
            const int i = region_.vertex_of_slot[out_.displaced[k]];
            out_.displacement.row(static_cast<Eigen::Index>(k)) = out_.gradients.rest.row(i) - region_.mesh.points.row(i);
        }
    }

    /// Adds `value` times the displacement of vertex k, in generalised columns: (W − I)(v, 1) for handles.
    void add_position(int k, const Eigen::Vector4d& value, RowBuilder<4>& row) const {
        switch (region_.role[k]) {
        case Role::fixed: return;
        case Role::free: row.add(region_.slot[k], value); return;
        case Role::region:
        case Role::point: {
            const int column = region_.handle_column(region_.handle[k]);
            for (int d = 0; d < 3; ++d) row.add(column + d, region_.mesh.points(k, d) * value);
            row.add(column + 3, value);
        }
        }
    }

    /// Adds `weight` (M_i − I), one number for each column of M.
    void add_gradient(int i, double weight, RowBuilder<4>& row) const {
        if (const int h = prescribing_handle(i); h >= 0) {
            for (int d = 0; d < 3; ++d) row.add(region_.handle_column(h) + d, weight * Eigen::Vector4d::Unit(d));
            return;
        }
        for (int e = out_.gradients.offsets[i]; e < out_.gradients.offsets[i + 1]; ++e) {
            Eigen::Vector4d value = Eigen::Vector4d::Zero();
            value.head<3>() = weight * out_.gradients.coefficients.row(e).transpose();
            add_position(out_.gradients.vertices[e], value, row);
        }
    }

    /// Row i of Λ times the gradients, Λ the graph Laplacian of SF: E_R = Σ tr(M Λ Mᵀ) (Eq 2.7).
    void add_coherence(int i, RowBuilder<4>& row) {
        if (!solves_gradient(i)) return; // the rows of a prescribed gradient multiply no unknown
        const auto ring = neighbours(i);
        const double pair = 2; // each pair stands in the sum as (i, j) and as (j, i)
        add_gradient(i, pair * static_cast<double>(ring.size()), row);
        for (const int j : ring) add_gradient(j, -pair, row);
        if (const HeldPiece& piece = region_.pieces[region_.piece[i]]; piece.pose >= 0) {
            const double weight = k_rest_weight / std::max(piece.free_count, 1);
            add_gradient(i, weight, row);
            const int column = region_.handle_column(region_.handle_count + piece.pose);
            for (int d = 0; d < 3; ++d) row.add(column + d, -weight * Eigen::Vector4d::Unit(d));
        }
    }

    /// Rows M_i δ_i − d_i of E_T (Fu 3.3.3), in the units of E_L; d_i comes with the drag.
    void add_blends(std::span<const int> blended, double weight, RowBuilder<4>& row, EntryRows<4>& left, EntryRows<4>& right) {
        std::vector<Eigen::Triplet<double>> entries;
        const auto count = std::ssize(blended);
        out_.blend_scale.resize(count);
        out_.blend_rest.resize(count, 3);
        for (Eigen::Index b = 0; b < count; ++b) {
            const int i = blended[static_cast<std::size_t>(b)];
            out_.blend_scale[b] = mean_area_ / (std::max(areas_[i], k_least_area * mean_area_) * edge_);
            out_.blend_rest.row(b) = out_.blend_scale[b] * laplacian_.row(i);
            const Vector3d delta = out_.blend_rest.row(b).transpose();
            for (const bool of_left : {true, false}) {
                for (int e = out_.gradients.offsets[i]; e < out_.gradients.offsets[i + 1]; ++e)
                    add_position(out_.gradients.vertices[e], weight * out_.gradients.coefficients.row(e).dot(delta) * Eigen::Vector4d::Unit(3), row);
                if (of_left)
                    for (const int column : row.touched())
                        if (column < region_.unknowns) entries.emplace_back(column, static_cast<int>(b), weight * row[column][3]);
                row.append_to(of_left ? left : right);
            }
        }
        out_.blends.resize(region_.unknowns, count);
        out_.blends.setFromTriplets(entries.begin(), entries.end());
    }

    [[nodiscard]] std::span<const int> neighbours(int i) {
        if (coherence_ring_ == 1) return region_.rings[i];
        two_ring_.clear();
        for (const int j : region_.rings[i]) {
            two_ring_.push_back(j);
            for (const int k : region_.rings[j])
                if (k != i) two_ring_.push_back(k);
        }
        std::sort(two_ring_.begin(), two_ring_.end());
        two_ring_.erase(std::unique(two_ring_.begin(), two_ring_.end()), two_ring_.end());
        return two_ring_;
    }

    /// Free and point vertices, and the handle and fixed vertices next to a free one: their details must fit too.
    [[nodiscard]] bool in_laplacian_energy(int i) const {
        if (solves_gradient(i)) return true;
        const auto ring = region_.rings[i];
        return std::any_of(ring.begin(), ring.end(), [&](int j) { return region_.role[j] == Role::free; });
    }

    /// Row i of E_L: (D(ṽ_i) − M_i δ_i)/h (Eq 2.6) with D_i = (mean area / area_i) L_i, a length, and h the mean edge
    /// length, ours: as printed E_L has a unit and E_R has none.
    void add_laplacian(int i, RowBuilder<4>& row) const {
        const double scale = mean_area_ / (std::max(areas_[i], k_least_area * mean_area_) * edge_);
        for (SparseMatrix::InnerIterator entry(L_, i); entry; ++entry)
            add_position(static_cast<int>(entry.row()), scale * entry.value() * Eigen::Vector4d::Unit(3), row);
        const Vector3d delta = scale * laplacian_.row(i).transpose();
        if (const int h = prescribing_handle(i); h >= 0) {
            for (int d = 0; d < 3; ++d) row.add(region_.handle_column(h) + d, -delta[d] * Eigen::Vector4d::Unit(3));
            return;
        }
        for (int e = out_.gradients.offsets[i]; e < out_.gradients.offsets[i + 1]; ++e)
            add_position(out_.gradients.vertices[e], -out_.gradients.coefficients.row(e).dot(delta) * Eigen::Vector4d::Unit(3), row);
    }

    static constexpr double k_least_area = 1e-2; // of the mean: the area of a needle must not outweigh all others

    const HeldRegion& region_;
    const SparseMatrix& L_;
    const Eigen::VectorXd& areas_;
    const int coherence_ring_;
    const double mean_area_, edge_;
    ImplicitSystem out_;
    Points laplacian_;
    std::vector<int> two_ring_;
};

} // namespace

ImplicitSystem implicit_system(const HeldRegion& region, const SparseMatrix& L, const Eigen::VectorXd& areas, int coherence_ring,
                               std::span<const int> blended, double blend_weight, RowPair* rows) {
    return Assembly(region, L, areas, coherence_ring).run(blended, blend_weight, rows);
}

} // namespace lissom
