#pragma once

#include "lissom/match/fit_surface.h"
#include "lissom/match/pull.h"
#include "lissom/mesh/surface_samples.h"

#include <vector>

namespace lissom {

struct CorrespondenceRules {
    double least_cosine = 0.3; ///< between the normals of skin and surface
    double reach = 0.15;       ///< farther places do not count
    double reverse = 0.5;      ///< weight of all samples of the surface together, as a share of that of all vertices asked about; 0: none
};

/// Where the places of a skin should go, asked again as the skin moves.
///
/// Forward, each vertex to the nearest place of the surface that faces as it does, by its share of the area and the cosine; a vertex of the skin's border to the
/// surface's rim alone, others never there; what the surface ignores pulls nothing. In reverse, each sample of the surface is a place that the skin's nearest place should reach: without these, tips (ears, horns,
/// toes) stay short, for nothing in their neighbourhood is nearest to a tip.
/// Weights of vertices have a mean of 1 before any is left out.
class Correspondences {
public:
    /// @param surface  kept by reference
    /// @param samples  of it, for the way back
    /// @param facing   false: normals say nothing
    Correspondences(const FitSurface& surface, const SurfacePlaces& samples, bool facing = true);

    /// @param left_out  one flag per vertex of the skin, or none: where nothing is asked forward
    /// @param masked    one flag per vertex of the skin, or none: triangles of only these are pulled at by no sample
    [[nodiscard]] std::vector<Pull> find(const TriangleMesh& skin, const CorrespondenceRules& rules, const std::vector<char>& left_out = {}, const std::vector<char>& masked = {});

private:
    const FitSurface& surface_;
    Points places_, facing_; ///< of samples
    bool has_facing_;
    std::vector<int> hints_; ///< triangle found last, per vertex of the skin
    std::vector<int> reverse_hints_;
    int triangles_ = -1;     ///< of the skin asked last: hints hold while it has as many
};

} // namespace lissom
