#pragma once

#include "lissom/mesh/similarity.h"
#include "lissom/mesh/triangle_tree.h"
#include "lissom/wear/biharmonic_map.h"

#include <memory>
#include <vector>

namespace lissom {

/// What lies near one skin is carried to where it lies near another of the same triangles (t-FFD made smooth).
///
/// The first skin is laid on the second by a similarity; then a place at distance d from the first keeps its nearest place and what leads from there, turned
/// as the skin around turns, by the weight exp(−(d/σ)²); by the rest it follows a biharmonic map of some 1,200 places that are spread
/// evenly over the skin. So what is worn close sits as it sat, and cloth between legs or far out does not tear where the
/// nearest place jumps. Distances from the skin stay what they are where the bodies are as large but for a quarter (a similarity of both sides is carried along).
///
/// Source: Kobayashi and Ootsubo, "t-FFD", 2003, as "Duplicate-Skins" (004) 5.2 uses it; the rest measured (docs/wear.md).
/// Cost: dense, 1,200³ once; a place a walk of the tree and 1,200 distances.
class BodyMap {
public:
    /// Call step() until it returns false.
    /// @param from,to  n×3, one row per vertex of the triangles
    /// @throws InvalidInput `wrong-size`, `vertex-out-of-range`, `non-finite-position`, `flat-skin` (no area, or all in one plane)
    BodyMap(const Triangles& triangles, const Points& from, const Points& to);
    ~BodyMap();
    BodyMap(BodyMap&&) noexcept;

    /// One slice. @returns true while there is more
    bool step();

    struct Carried {
        Eigen::Vector3d place;
        Eigen::Vector3d away; ///< unit, from the second skin outward where the place belongs
        int triangle = -1;    ///< of the nearest place, and its weights
        Eigen::Vector3d weights;
    };
    [[nodiscard]] Carried carry(const Eigen::Vector3d& place) const;

    /// That lays the first skin on the second.
    [[nodiscard]] const Similarity& similarity() const;
    [[nodiscard]] const TriangleMesh& to() const;
    /// √area of the second skin: what lengths are shares of.
    [[nodiscard]] double size() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace lissom
