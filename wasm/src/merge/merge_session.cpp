#include "merge_state.h"

#include "lissom/merge/seam_flips.h"
#include "lissom/mesh/errors.h"
#include "lissom/mesh/stopwatch.h"

#include <string>
#include <utility>

namespace lissom {

MergeSession::MergeSession(const WorkingMesh& source, const WorkingMesh& target, std::span<const MergeBoundary> boundaries, MergeOptions options,
                           std::span<const int> roi, std::span<const MergeHandle> handles)
    : state_(new State{.source = source, .target = target, .options = options}) {
    Stopwatch watch;
    state_->cut(boundaries);
    state_->check_sizes();
    state_->refine();
    state_->prepare(roi, handles);
    state_->prepare_seconds = watch.lap();
}

MergeSession::MergeSession(const WorkingMesh& source, const WorkingMesh& target, const PaintedRegions& regions, MergeOptions options)
    : state_(new State{.source = source, .target = target, .options = options}) {
    Stopwatch watch;
    state_->find_boundary(regions);
    state_->check_sizes();
    state_->prepare({}, {});
    state_->prepare_seconds = watch.lap();
}

MergeSession::~MergeSession() = default;
MergeSession::MergeSession(MergeSession&&) noexcept = default;

bool MergeSession::step() {
    const bool more = state_->deform->step();
    if (!more)
        for (const Finding& w : state_->deform->warnings())
            if (w.code == "factor-shifted") state_->warnings.push_back(w);
    return more;
}
double MergeSession::fraction() const { return state_->deform->fraction(); }

MergeResult MergeSession::merge(std::span<const MergeKeys> keys, bool settle) const {
    const State& s = *state_;
    if (keys.size() != s.source_part.loops.size())
        throw InvalidInput("boundary-count", "There are " + std::to_string(s.source_part.loops.size()) + " pairs of boundaries but keys for " +
                                                 std::to_string(keys.size()) + ".");
    Stopwatch watch;
    MergeResult result;
    std::vector<LoopMatch> matches;
    result.source_turned = s.looks_turned;
    try {
        matches = s.match(keys, result.source_turned, result.keys, result.warnings);
    } catch (const InvalidInput& error) {
        if (error.code() != k_keys_reversed) throw;
        result.source_turned = !result.source_turned; // three keys know better than volumes
        result.keys.clear();
        result.warnings.clear();
        matches = s.match(keys, result.source_turned, result.keys, result.warnings);
    }
    if (result.source_turned) result.warnings.push_back({"source-turned", 1, {}, true});

    const Points positions = s.deform_source(matches, result.keys, result.source_turned, settle, result.solve_seconds);
    watch.lap();
    JoinedMesh joined = stitch(s.target_part, s.source_part, result.source_turned, positions, matches);
    flip_thin_triangles(joined, s.target_part, s.source_part);
    std::vector<char> moved(static_cast<std::size_t>(joined.target_vertices), 0);
    if (s.options.smoothing > 0) {
        smooth_seam(joined, s.options.smoothing);
        flip_thin_triangles(joined, s.target_part, s.source_part);
        for (const std::vector<int>& seam : joined.seams)
            for (const int v : seam)
                if (v < joined.target_vertices) moved[v] = 1;
    }
    result.seam = seam_figures(joined);
    result.model = to_files(joined, s.target_part, s.target, s.source_part, s.source, moved);
    result.stitch_seconds = watch.lap();
    return result;
}

const std::vector<double>& MergeSession::energies() const { return state_->energies; }
const std::optional<Placement>& MergeSession::placement() const { return state_->placement; }
int MergeSession::free_vertices() const { return state_->deform->free_vertices(); }
int MergeSession::degenerate_vertices() const { return state_->deform->degenerate_vertices(); }
double MergeSession::prepare_seconds() const { return state_->prepare_seconds; }
double MergeSession::factor_seconds() const { return state_->deform->factor_seconds(); }
double MergeSession::memory_bytes() const { return state_->deform->memory_bytes(); }
const std::vector<Finding>& MergeSession::warnings() const { return state_->warnings; }

} // namespace lissom
