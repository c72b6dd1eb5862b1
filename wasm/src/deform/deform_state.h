#pragma once

#include "lissom/deform/deform_session.h"
#include "lissom/deform/held_region.h"
#include "lissom/deform/implicit_system.h"
#include "lissom/deform/prepared_solver.h"
#include "lissom/deform/reconstruction.h"
#include "lissom/mesh/stopwatch.h"

#include <optional>
#include <utility>
#include <vector>

namespace lissom {

/// What a session knows between drags.
struct PreparedDeform {
    const WorkingMesh& working;
    DeformOptions options;
    std::vector<DeformHandle> handles;

    HeldRegion region{};
    ImplicitSystem implicit{};
    Reconstruction rebuild{};
    std::optional<PreparedSolver> first{};  ///< Eq 2.8; not for the naive method
    std::optional<PreparedSolver> second{}; ///< Eq 2.10/2.11; not where shear stays
    std::vector<std::pair<int, int>> free_sources{};   ///< source vertex and its unknown
    std::vector<std::pair<int, int>> handle_sources{}; ///< source vertex and its handle

    std::vector<int> blended{};                   ///< vertices of the region with a row of E_T
    std::vector<int> blend_rows{}, blend_slots{}; ///< blended vertices that are free: their place in the options, their slot

    std::vector<Finding> warnings{};
    double assemble_seconds = 0, factor_seconds = 0;

    /// Which source vertex takes its position from where. Welded copies follow their working vertex; a vertex
    /// without one (no triangle uses it) follows a region handle that names it.
    void map_sources(const Roles& roles);
    /// Factors and right-hand sides for the roles and pieces found.
    void assemble();
    /// Gives a solver that lacks digits the rows to correct its solutions by.
    void add_rows(PreparedSolver& solver);

    [[nodiscard]] bool has_first() const { return options.method != DeformMethod::naive; }
    [[nodiscard]] bool has_second() const { return options.method != DeformMethod::implicit || options.remove_shear; }
};

struct DeformSession::State {
    PreparedDeform prepared;
};

/// One drag, see DeformSession::deform.
[[nodiscard]] DeformResult drag(const PreparedDeform& prepared, std::span<const Eigen::Affine3d> targets, bool settle,
                                const Points* details);

} // namespace lissom
