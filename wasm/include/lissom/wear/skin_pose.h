#pragma once

#include "lissom/mesh/working_mesh.h"

#include <memory>

namespace lissom {

struct SkinPoseOptions {
    double strength = 1;       ///< 0: at rest, 1: the whole pose; more exaggerates
    bool keep_stretch = false; ///< takes over what the pose stretches as well; else the surface only turns
};

struct SkinPoseSeconds {
    double prepare = 0; ///< places of both models, and the factor
    double solve = 0;   ///< the last call of `give`
};

/// Gives poses of one model to another of which there are skins of one connectivity.
///
/// The first skin goes along with its model: each vertex keeps its nearest place there, and what leads from it, turned as the surface around
/// turns. How its triangles are mapped (rotation and stretch of each) is then wanted of the second skin's triangles, whose vertices are those
/// that fit best, K u = Σ_t ∇ᵀ A_t (F_t − I) with K the cotangent stiffness; and the second model goes along with its skin. Where the whole
/// stands: it moves as the first skin does in the mean, in proportion to its size. Where triangles only turn, they may keep, in their own turned
/// frames, the stretch that they come to: rotations alone fit no surface that bends.
///
/// Models that stand alike but for 15 degrees are taken to stand in one space; others are first laid on one another by their skins.
///
/// Source: Sumner and Popović, "Deformation transfer for triangle meshes", 2004, section 4, in the form of Botsch et al., "Deformation transfer
/// for detail-preserving surface editing", 2006.
/// Limits: what lies far off the skin (hair, a stand) goes rigidly with its nearest place.
/// Cost: prepare a walk of the tree for each vertex and one factor of the skin; a pose is some passes and at most three solves of three columns.
class SkinPose {
public:
    /// Call step() until it returns false.
    /// @param source,target  the two models; read until step() has returned false
    /// @param from,to        their skins, n×3 each, in the spaces of their models
    /// @throws InvalidInput `wrong-size`, `vertex-out-of-range`, `non-finite-position`, `flat-skin` (no area)
    SkinPose(const WorkingMesh& source, const WorkingMesh& target, const Triangles& triangles, const Points& from, const Points& to);
    ~SkinPose();
    SkinPose(SkinPose&&) noexcept;

    /// One slice. @returns true while there is more. @throws SolverFailure
    bool step();
    [[nodiscard]] double fraction() const;

    /// The target in a pose of the source.
    /// @param pose  source positions, vertex by vertex as the source's
    /// @returns     target positions, one per source vertex of the target; those without a finite position as they are
    /// @throws InvalidInput `wrong-size`, `non-finite-position` (of a vertex that is finite at rest), `bad-option`  @throws SolverFailure
    [[nodiscard]] Points give(const Points& pose, const SkinPoseOptions& options = {});

    /// Vertices of the skin.
    [[nodiscard]] int unknowns() const;
    /// Solves in the last call of `give`.
    [[nodiscard]] int rounds() const;
    [[nodiscard]] const SkinPoseSeconds& seconds() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace lissom
