#include "lissom/isoline/full_pass.h"

#include "lissom/deform/held_region.h"
#include "lissom/deform/prepared_solver.h"
#include "lissom/deform/reconstruction.h"
#include "lissom/isoline/triangle_frames.h"
#include "lissom/mesh/errors.h"
#include "lissom/mesh/operators.h"
#include "lissom/mesh/polar.h"

#include <optional>
#include <utility>

namespace lissom {

struct FullPass::State {
    const WorkingMesh& working;
    HeldRegion region{};
    Reconstruction second{};
    std::optional<PreparedSolver> solver{};
    std::vector<std::pair<int, int>> free_sources{}; ///< source vertex and its unknown
};

FullPass::FullPass(const WorkingMesh& working, std::span<const int> roi, std::span<const DeformHandle> handles) : state_(new State{.working = working}) {
    State& s = *state_;
    std::vector<Finding> warnings;
    s.region = hold_region(working, assign_roles(working, roi, handles), static_cast<int>(handles.size()), warnings);
    std::vector<int> unknown(static_cast<std::size_t>(working.mesh.vertex_count()), -1);
    Points coordinates(s.region.unknowns, 3);
    for (int k = 0; k < s.region.unknowns; ++k) {
        unknown[s.region.working[s.region.vertex_of_slot[k]]] = k;
        coordinates.row(k) = s.region.mesh.points.row(s.region.vertex_of_slot[k]);
    }
    for (int v = 0; v < static_cast<int>(working.working_of_source.size()); ++v)
        if (const int w = working.working_of_source[v]; w >= 0 && unknown[w] >= 0) s.free_sources.emplace_back(v, unknown[w]);
    if (s.region.unknowns == 0) return;
    s.second = reconstruction(s.region, cotangent_laplacian(s.region.mesh), vertex_areas(s.region.mesh));
    s.solver.emplace(std::move(s.second.equations), coordinates);
}

FullPass::~FullPass() = default;
FullPass::FullPass(FullPass&&) noexcept = default;

bool FullPass::step() { return state_->solver && !state_->solver->ready() && state_->solver->step(); }
double FullPass::fraction() const { return state_->solver ? state_->solver->fraction() : 1; }
double FullPass::memory_bytes() const {
    return state_->solver ? state_->solver->memory_bytes() + 12.0 * static_cast<double>(state_->second.T.nonZeros()) : 0;
}

Points FullPass::apply(const Points& positions, std::span<const Eigen::Affine3d> targets, int passes) const {
    const State& s = *state_;
    if (!s.solver) return positions;
    const HeldRegion& region = s.region;
    std::vector<Eigen::Matrix3d> turns;
    Columns w = Columns::Zero(region.columns() - region.unknowns, 3);
    for (int h = 0; h < region.handle_count; ++h) {
        const Eigen::Affine3d map = s.working.to_working(targets[static_cast<std::size_t>(h)]);
        turns.push_back(nearest_rotation(map.linear()));
        w.middleRows<3>(4 * h) = (map.linear() - Eigen::Matrix3d::Identity()).transpose();
        w.row(4 * h + 3) = map.translation().transpose();
    }
    Points result = positions, moved(region.mesh.vertex_count(), 3), b(region.slots(), 3);
    for (int pass = 0; pass < passes; ++pass) {
        for (Eigen::Index v = 0; v < moved.rows(); ++v)
            moved.row(v) = s.working.to_working(Eigen::Vector3d(result.row(s.working.source_of_working[region.working[static_cast<std::size_t>(v)]]))).transpose();
        const std::vector<Eigen::Matrix3d> rotations = vertex_rotations(region.mesh, moved);
        for (int k = 0; k < region.slots(); ++k) {
            const int v = region.vertex_of_slot[k];
            const Eigen::Matrix3d& R = region.role[v] == Role::region ? turns[region.handle[v]] : rotations[v];
            b.row(k) = ((R - Eigen::Matrix3d::Identity()) * s.second.delta.row(k).transpose()).transpose();
        }
        const Columns right = s.second.T * b;
        const Columns u = s.solver->solve(w, &right); // Isolines Eq 3
        if (!u.allFinite()) throw SolverFailure("The full pass ran out of numbers: a position is not finite. Move the handles less far.");
        for (const auto& [v, k] : s.free_sources) result.row(v) = s.working.source.row(v) + s.working.scale * u.row(k);
    }
    return result;
}

Points with_turned_details(const TriangleMesh& rest, const Points& moved, const Points& rest_base, const Points& moved_base, const std::vector<bool>& kept) {
    const std::vector<Eigen::Matrix3d> rotations = vertex_rotations({rest_base, rest.triangles}, moved_base);
    Points result = moved;
    for (Eigen::Index v = 0; v < moved.rows(); ++v)
        if (!kept[static_cast<std::size_t>(v)])
            result.row(v) = moved_base.row(v) + (rotations[static_cast<std::size_t>(v)] * (rest.points.row(v) - rest_base.row(v)).transpose()).transpose();
    return result;
}

} // namespace lissom
