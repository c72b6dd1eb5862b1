#pragma once

#include "lissom/mesh/types.h"

#include <memory>
#include <vector>

namespace lissom {

enum class PartHow {
    paste,   ///< its Laplacian coordinates, turned and scaled as its border is
    low_pass ///< what stands out of a smoothed surface, on that of the other (Skins 5.1)
};

struct PartSpec {
    int from = 0;               ///< number of the skin whose shape it takes
    std::vector<int> vertices;  ///< of the skins
    double feather = -1;        ///< how far around the part the two shapes go over into each other, along the edges of `from`; below 0: 0.7 of the part's radius √(area/π)
    PartHow how = PartHow::paste;
};

/// A part of one shape set into others of the same connectivity, so that the surface stays smooth across its border.
///
/// For each piece of the part the ring around it decides a similarity (Procrustes) that carries the part's shape T to where it belongs. Then,
/// pasted: minimise Σ_i |(L x)_i − (L T)_i|² / a_i over the piece's vertices, two rings around it fixed: T itself where the rings agree,
/// else with a biharmonic correction; L and a are the cotangent Laplacian and areas of the part's own shape. By low-pass: both shapes are
/// smoothed away by (a + ℓ⁴ L a⁻¹ L) x̄ = a x within the piece, and what the part's differs by is put on the other's turned as that is.
/// With a feather the vertices around give way instead: the part itself is T, and in the feather the two shapes' Laplacian coordinates are mixed.
///
/// Cost: one factor of the part's vertices; `apply` a solve, so that it follows changing weights.
class PartPaste {
public:
    /// Call step() until it returns false.
    /// @param shape  of `from`, kept by reference: must outlive it
    /// @throws InvalidInput `empty-part`, `vertex-out-of-range`, `whole-part` (all of a piece of the surface: nothing is left to join), `bad-option`
    PartPaste(const TriangleMesh& shape, const PartSpec& part);
    ~PartPaste();
    PartPaste(PartPaste&&) noexcept;

    /// One slice. @returns true while there is more. @throws SolverFailure
    bool step();

    /// Sets the part into a shape: n×3. Vertices outside of it and its feather stay, bit for bit.
    /// @throws SolverFailure
    void apply(Points& shape) const;

    /// Vertices that it moves, ascending.
    [[nodiscard]] const std::vector<int>& moved() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace lissom
