#include "lissom/deform/deform_session.h"

#include "deform_state.h"

#include "lissom/mesh/errors.h"
#include "lissom/mesh/operators.h"

#include <string>
#include <utility>

namespace lissom {
namespace {

void check(const DeformOptions& options) {
    if (options.iterations < 1)
        throw InvalidInput("bad-option", "The number of iterations is " + std::to_string(options.iterations) + "; it must be 1 or more.");
    if (options.coherence_ring != 1 && options.coherence_ring != 2)
        throw InvalidInput("bad-option", "The coherence ring is " + std::to_string(options.coherence_ring) + "; it must be 1 or 2.");
}

} // namespace

void PreparedDeform::map_sources(const Roles& roles) {
    std::vector<int> unknown(roles.role.size(), -1);
    for (int k = 0; k < region.unknowns; ++k) unknown[region.working[region.vertex_of_slot[k]]] = k;
    for (int v = 0; v < static_cast<int>(working.working_of_source.size()); ++v) {
        const int w = working.working_of_source[v];
        if (w < 0) continue;
        if (roles.handle[w] >= 0) handle_sources.emplace_back(v, roles.handle[w]);
        else if (unknown[w] >= 0) free_sources.emplace_back(v, unknown[w]);
    }
    for (int h = 0; h < static_cast<int>(handles.size()); ++h)
        for (const int v : handles[h].vertices)
            if (working.working_of_source[v] < 0 && working.source.row(v).allFinite()) handle_sources.emplace_back(v, h);
}

void PreparedDeform::assemble() {
    if (region.unknowns == 0) return;
    const SparseMatrix L = cotangent_laplacian(region.mesh);
    const Eigen::VectorXd areas = vertex_areas(region.mesh);
    Points coordinates(region.unknowns, 3);
    for (int k = 0; k < region.unknowns; ++k) coordinates.row(k) = region.mesh.points.row(region.vertex_of_slot[k]);
    std::vector<int> local(static_cast<std::size_t>(working.mesh.vertex_count()), -1);
    for (int v = 0; v < std::ssize(region.working); ++v) local[region.working[v]] = v;
    for (std::size_t b = 0; b < options.blended.size(); ++b) {
        const int w = working.working_of_source[options.blended[b].vertex], v = w < 0 ? -1 : local[w];
        if (v < 0 || region.role[v] != Role::free) continue;
        blended.push_back(v);
        blend_rows.push_back(static_cast<int>(b));
        blend_slots.push_back(region.slot[v]);
    }
    if (has_first()) {
        implicit = implicit_system(region, L, areas, options.coherence_ring, blended, options.blend_weight);
        first.emplace(std::move(implicit.equations), coordinates);
    }
    if (has_second()) {
        rebuild = reconstruction(region, L, areas);
        second.emplace(std::move(rebuild.equations), coordinates);
    }
}

void PreparedDeform::add_rows(PreparedSolver& solver) {
    const SparseMatrix L = cotangent_laplacian(region.mesh);
    const Eigen::VectorXd areas = vertex_areas(region.mesh);
    RowPair rows;
    if (first && &solver == &*first) (void)implicit_system(region, L, areas, options.coherence_ring, blended, options.blend_weight, &rows);
    else (void)reconstruction(region, L, areas, &rows);
    solver.refine_by(std::move(rows));
}

DeformSession::DeformSession(const WorkingMesh& working, std::span<const int> roi, std::span<const DeformHandle> handles,
                             DeformOptions options)
    : state_(new State{{.working = working, .options = options, .handles = {handles.begin(), handles.end()}}}) {
    check(options);
    PreparedDeform& p = state_->prepared;
    Stopwatch watch;
    const Roles roles = assign_roles(working, roi, handles);
    p.region = hold_region(working, roles, static_cast<int>(handles.size()), p.warnings);
    p.map_sources(roles);
    p.assemble();
    p.assemble_seconds = watch.lap();
}

DeformSession::~DeformSession() = default;
DeformSession::DeformSession(DeformSession&&) noexcept = default;

bool DeformSession::step() {
    Stopwatch watch;
    bool more = false;
    for (std::optional<PreparedSolver>* solver : {&state_->prepared.first, &state_->prepared.second}) {
        if (!*solver || (*solver)->ready()) continue;
        more = true;
        if ((*solver)->step()) break;
        if ((*solver)->shifted()) state_->prepared.warnings.push_back({"factor-shifted", 1, {}, true});
        if ((*solver)->needs_rows()) state_->prepared.add_rows(**solver);
        break;
    }
    state_->prepared.factor_seconds += watch.lap();
    return more;
}

double DeformSession::fraction() const {
    double done = 0, all = 0;
    for (const std::optional<PreparedSolver>* solver : {&state_->prepared.first, &state_->prepared.second}) {
        if (!*solver) continue;
        done += (*solver)->fraction() * (*solver)->work();
        all += (*solver)->work();
    }
    return all > 0 ? done / all : 1;
}

DeformResult DeformSession::deform(std::span<const Eigen::Affine3d> targets, bool settle, const Points* details) const {
    if (targets.size() != state_->prepared.handles.size())
        throw InvalidInput("handle-count", "There are " + std::to_string(state_->prepared.handles.size()) + " handles but " +
                                               std::to_string(targets.size()) + " targets. Give one for each handle.");
    for (std::size_t h = 0; h < targets.size(); ++h)
        if (!targets[h].matrix().allFinite())
            throw InvalidInput("non-finite-target", "The target of handle " + std::to_string(h + 1) +
                                                        " holds a number that is not finite. Reset the handle.");
    if ((details == nullptr ? 0 : details->rows()) != std::ssize(state_->prepared.options.blended))
        throw InvalidInput("detail-count", "There are " + std::to_string(state_->prepared.options.blended.size()) + " blended vertices; give a detail for each.");
    return drag(state_->prepared, targets, settle, details);
}

int DeformSession::free_vertices() const { return state_->prepared.region.unknowns; }
int DeformSession::degenerate_vertices() const { return static_cast<int>(state_->prepared.implicit.displaced.size()); }
double DeformSession::assemble_seconds() const { return state_->prepared.assemble_seconds; }
double DeformSession::factor_seconds() const { return state_->prepared.factor_seconds; }
const std::vector<Finding>& DeformSession::warnings() const { return state_->prepared.warnings; }

bool DeformSession::corrects() const {
    const auto corrects_in = [](const std::optional<PreparedSolver>& solver) { return solver && solver->corrects(); };
    return corrects_in(state_->prepared.first) || corrects_in(state_->prepared.second);
}

double DeformSession::memory_bytes() const {
    double bytes = 0;
    for (const std::optional<PreparedSolver>* solver : {&state_->prepared.first, &state_->prepared.second})
        if (*solver) bytes += (*solver)->memory_bytes();
    constexpr double entry = sizeof(double) + sizeof(int);
    bytes += entry * static_cast<double>(state_->prepared.rebuild.T.nonZeros());
    bytes += static_cast<double>(state_->prepared.implicit.slots.size()) * (3 * sizeof(double) + sizeof(int));
    return bytes;
}

} // namespace lissom
