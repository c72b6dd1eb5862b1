#pragma once

#include "lissom/match/distances.h"
#include "lissom/match/fit_surface.h"
#include "lissom/match/outer_surface.h"
#include "lissom/mesh/working_mesh.h"

#include <optional>

namespace lissom {

/// Whether a model is scattered points, with a surface drawn through them.
[[nodiscard]] bool is_points(const WorkingMesh& model);

/// A model at unit size about its middle, which neither turning nor triangulation changes, and the way back.
struct PlacedModel {
    const WorkingMesh& working;
    std::optional<OuterSurface> outer; ///< where only that is fitted to; none: the whole model is
    SurfaceSize size;                  ///< of the whole model
    FitSurface surface;

    /// @throws InvalidInput `flat-model`. @param which  one it is, for who is told
    PlacedModel(const WorkingMesh& model, const std::string& which, std::optional<OuterSurface> seen = {});

    /// Leaves source vertices out of the surface. @throws InvalidInput `bad-mask`
    void ignore(const std::vector<int>& source_vertices, const std::string& which);

    [[nodiscard]] bool is_points() const { return lissom::is_points(working); }
    /// A soup, pieces that reach into one another, or a surface drawn through points: how it hangs together means nothing.
    [[nodiscard]] bool is_loose() const;

    [[nodiscard]] const TriangleMesh& mesh() const { return surface.mesh(); }
    [[nodiscard]] Points inwards(const Points& places) const;
    [[nodiscard]] Points outwards(const Points& places) const;
};

} // namespace lissom
