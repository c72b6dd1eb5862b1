#include "lissom/isoline/carriers.h"

#include "lissom/isoline/isolines.h"
#include "lissom/mesh/operators.h"

#include <algorithm>

namespace lissom {

void Carriers::guess_by(const Columns& others) {
    fields = Eigen::MatrixXd::Zero(details.count, others.cols());
    Eigen::VectorXd sizes = Eigen::VectorXd::Zero(details.count);
    for (Eigen::Index v = 0; v < others.rows(); ++v)
        for (int s = details.offsets[static_cast<std::size_t>(v)]; s < details.offsets[static_cast<std::size_t>(v) + 1]; ++s) {
            fields.row(details.shares[s].carrier) += details.shares[s].weight * others.row(v);
            sizes[details.shares[s].carrier] += details.shares[s].weight;
        }
    for (Eigen::Index c = 0; c < fields.rows(); ++c)
        if (sizes[c] > 0) fields.row(c) /= sizes[c];
}

Carriers patch_carriers(const TriangleMesh& mesh, const Columns& fields, const std::vector<int>& handle, std::span<const HandleEnd> ends,
                        const PatchOptions& options) {
    const auto count = static_cast<int>(ends.size());
    std::vector<int> region(handle.size(), -1);
    for (std::size_t v = 0; v < handle.size(); ++v)
        if (handle[v] >= 0 && ends[static_cast<std::size_t>(handle[v])].kind == HandleEnd::Kind::region) region[v] = handle[v];
    const Patches patches = cut_patches(mesh, fields, region, count, options);
    const Eigen::VectorXd areas = triangle_areas(mesh);

    Carriers carriers;
    carriers.details.count = patches.count;
    carriers.details.offsets.push_back(0);
    for (int v = 0; v < mesh.vertex_count(); ++v) {
        if (patches.of_vertex[v] >= 0) carriers.details.shares.push_back({patches.of_vertex[v], 1.0});
        carriers.details.offsets.push_back(static_cast<int>(carriers.details.shares.size()));
    }
    for (int c = 0; c < patches.count; ++c) {
        carriers.handle.push_back(c < count && ends[static_cast<std::size_t>(c)].kind == HandleEnd::Kind::region ? c : -1);
        std::vector<Carriers::Sample> samples;
        for (const int t : patches.triangles[c]) samples.push_back({t, areas[t]});
        carriers.samples.push_back(std::move(samples));
    }
    carriers.guess_by(fields);
    return carriers;
}

namespace {

/// Evenly along its loops, at most `most` triangles.
std::vector<Carriers::Sample> sampled(const Isoline& line, int most) {
    std::vector<int> walked;
    for (const std::vector<int>& loop : line.loops) walked.insert(walked.end(), loop.begin(), loop.end());
    const int count = static_cast<int>(walked.size()), taken = std::min(count, most);
    std::vector<Carriers::Sample> samples;
    for (int k = 0; k < taken; ++k) {
        const IsolineSegment& segment = line.segments[walked[static_cast<std::size_t>(static_cast<long long>(k) * count / taken)]];
        if (segment.length > 0) samples.push_back({segment.triangle, segment.length * segment.length}); // Eq 9
    }
    return samples;
}

} // namespace

Carriers isoline_carriers(const TriangleMesh& mesh, const Columns& fields, const ControlSets& sets, std::span<const HandleEnd> ends, int triangles) {
    Carriers carriers;
    carriers.normals_only = true;
    carriers.details.count = sets.controls();
    carriers.details.offsets.push_back(0);
    const int n = sets.basis.controls();
    std::vector<ControlSets::Entry> entries;
    for (Eigen::Index v = 0; v < fields.rows(); ++v) {
        if ((fields.row(v).array() != 0).any()) {
            sets.entries_at({fields.data() + v * fields.cols(), static_cast<std::size_t>(fields.cols())}, entries);
            for (const ControlSets::Entry& e : entries) carriers.details.shares.push_back({e.control, e.weight});
        }
        carriers.details.offsets.push_back(static_cast<int>(carriers.details.shares.size()));
    }
    carriers.handle.assign(static_cast<std::size_t>(sets.controls()), -1);
    for (int f = 0; f < sets.fields; ++f)
        if (ends[static_cast<std::size_t>(f)].kind == HandleEnd::Kind::region) carriers.handle[sets.end_control(f)] = f;
    const int each = std::max(1, triangles / sets.controls());
    const double inside = 0.25 / (n - 1); // at 0 and 1 themselves lie handles, which no isoline crosses
    for (int c = 0; c < sets.controls(); ++c) {
        const double value = std::clamp(sets.basis.abscissa(c % n), inside, 1 - inside);
        std::vector<Carriers::Sample> samples;
        if (carriers.handle[c] < 0) samples = sampled(isoline(mesh, fields.col(sets.field_of_set(c / n)), value), each);
        carriers.samples.push_back(std::move(samples));
    }
    carriers.guess_by(fields);
    return carriers;
}

} // namespace lissom
