#pragma once

#include "lissom/mesh/types.h"

#include <optional>

namespace lissom {

/// The smooth map of space that carries some points exactly to others:
/// Ψ(x) = M x + t + Σ λ_i |x − τ_i|³ with Σ λ_i = 0 and Σ λ_i τ_iᵀ = 0, the triharmonic spline (Skins Eq 3).
///
/// A similarity of either side is carried along. Far from the points it grows as |x|²: markers should span the model.
/// Source: Wang et al., "Duplicate-Skins for Compatible Mesh Modelling" (004), 3.2. Cost: dense, n³; a point n.
class RadialMap {
public:
    /// @param from,to  n×3, no two of `from` in one place
    /// @returns none where they do not decide a map: fewer than four, all in one plane, two in one place
    [[nodiscard]] static std::optional<RadialMap> between(const Points& from, const Points& to);

    /// What tells of every point how far from it the map through all the others ends: row i of G · to, divided by G_ii (Rippa 1999).
    /// @returns G, n×n; none as above, and where leaving one out leaves too few
    [[nodiscard]] static std::optional<Eigen::MatrixXd> leave_one_out(const Points& from);

    [[nodiscard]] Eigen::Vector3d operator()(const Eigen::Vector3d& x) const;
    [[nodiscard]] Points operator()(const Points& points) const;

private:
    RadialMap() = default;
    bool place(const Points& from);
    [[nodiscard]] Eigen::MatrixXd system() const;

    Points centres_; ///< moved to their middle and divided by `size_`
    Eigen::RowVector3d middle_ = Eigen::RowVector3d::Zero();
    double size_ = 1;
    Points weights_; ///< λ, then the rows of t and M
};

} // namespace lissom
