#include "lissom/hair/hair_session.h"

#include "hair_state.h"

#include "lissom/hair/dual_field.h"
#include "lissom/hair/iterative_field.h"
#include "lissom/hair/scalp_shell.h"
#include "lissom/mesh/errors.h"
#include "lissom/mesh/stopwatch.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lissom {

using Eigen::Vector3d;

namespace {

constexpr double k_shell_reach = 0.2; // of the head height: how far from the scalp the shell goes on
constexpr std::size_t k_shell_slice = 192;

/// To multiples of 2⁻¹⁶: what rounding the factor's history has left (some 1e-12) goes, so that the same style gives
/// the same bytes whatever was drawn before it.
template <typename Matrix>
void snap(Matrix& vectors) {
    vectors = (vectors.array() * 0x1p16).round() * 0x1p-16;
}

/// Where a root lies on a map of the head that keeps angles from its top (azimuthal, equidistant).
Eigen::Vector2f root_uv(const Vector3d& root, UpAxis up) {
    const Vector3d d = root.normalized();
    const int top = static_cast<int>(up), a = (top + 2) % 3, b = (top + 1) % 3;
    const double across = std::hypot(d[a], d[b]);
    const double angle = std::atan2(across, d[top]) / std::numbers::pi; // 0 at the top, 1 below
    const double scale = across > 0 ? 0.5 * angle / across : 0;
    return Eigen::Vector2d(0.5 + scale * d[a], 0.5 + scale * d[b]).cast<float>();
}

TriangleMesh moved(TriangleMesh mesh, const Vector3d& by) {
    mesh.points.rowwise() += by.transpose();
    return mesh;
}

Vector3d middle(const TriangleMesh& mesh) {
    if (mesh.triangle_count() == 0)
        throw InvalidInput("head-empty", "The head has no triangle, so there is nothing for hair to grow on.");
    Vector3d low = Vector3d::Constant(INFINITY), high = -low;
    for (Eigen::Index t = 0; t < mesh.triangles.size(); ++t) {
        const Vector3d p = mesh.points.row(mesh.triangles.data()[t]);
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
    }
    return (low + high) / 2;
}

} // namespace

HeadShape::HeadShape(const TriangleMesh& mesh, std::span<const int> scalp_vertices, int resolution, UpAxis up)
    : origin(middle(mesh)), scalp(scalp_vertices.begin(), scalp_vertices.end()), whole(moved(mesh, -origin)),
      volume(hair_volume(whole, scalp, resolution, up)), roots(whole, scalp) {
    // Roots number the triangles of the head that was given; so do painted lengths its vertices.
    volume_of_roots = volume;
    volume_of_roots.head = whole;
}

struct HairSession::State {
    std::shared_ptr<HeadShape> head;
    std::shared_ptr<const GridBilaplacian> bilaplacian;
    std::vector<int> shell;
    std::vector<FieldConstraint> shell_block; // what is factored of it so far
    std::unique_ptr<DualField> alone, whole;  // the field of the style alone, and with the scalp
    std::unique_ptr<IterativeField> many_alone, many_whole;
    std::shared_ptr<const StyledField> style;
    std::vector<Finding> warnings;
    std::vector<FieldConstraint> constraints; // of the last style, then of the scalp
    int stage = 0;
    double prepare = 0, update = 0, field = 0;
};

HairSession::HairSession(const TriangleMesh& head, std::span<const int> scalp, int resolution, UpAxis up)
    : state_(std::make_unique<State>()) {
    Stopwatch clock;
    state_->head = std::make_shared<HeadShape>(head, scalp, resolution, up);
    state_->prepare = clock.lap();
}

HairSession::~HairSession() = default;
HairSession::HairSession(HairSession&&) noexcept = default;

bool HairSession::step() {
    Stopwatch clock;
    State& s = *state_;
    HeadShape& head = *s.head;
    const double h = head.volume.head_height;
    if (s.stage == 0) {
        head.distance = std::make_unique<HeadDistance>(head.volume.head, head.volume.distance);
    } else if (s.stage == 1) {
        s.bilaplacian = std::make_shared<GridBilaplacian>(head.volume.field.size);
        s.alone = std::make_unique<DualField>(s.bilaplacian);
        s.whole = std::make_unique<DualField>(s.bilaplacian);
    } else if (s.stage == 2) {
        s.shell = scalp_shell(head.volume.field, *head.distance, head.roots.points(), k_shell_reach * h);
    } else if (s.shell_block.size() < s.shell.size()) {
        for (std::size_t n = std::min(s.shell.size() - s.shell_block.size(), k_shell_slice); n > 0; --n)
            s.shell_block.push_back({s.shell[s.shell_block.size()], Vector3d::Zero()});
        s.whole->set_constraints(s.shell_block);
    }
    ++s.stage;
    const bool more = s.stage < 3 || s.shell_block.size() < s.shell.size();
    s.prepare += clock.lap();
    if (!more && !s.style) set_style({});
    return more;
}

double HairSession::fraction() const {
    if (state_->stage < 3) return 0.2 * state_->stage;
    return state_->shell.empty() ? 1 : 0.6 + 0.4 * static_cast<double>(state_->shell_block.size()) / static_cast<double>(state_->shell.size());
}

void HairSession::set_style(const HairStyle& given) {
    State& s = *state_;
    const HeadShape& head = *s.head;
    const Grid& grid = head.volume.field;
    const HairStyle style = moved(given, -head.origin);
    std::vector<Finding> warnings = check_style(style, head);

    Stopwatch updating;
    const std::vector<FieldConstraint> wanted = style_constraints(style, *head.distance, grid);
    std::vector<TailSection> ties; // C1 of each ponytail; radius 0: it has none
    for (const Ponytail& tail : style.ponytails) {
        const std::vector<TailSection> sections = tail_sections(tail, grid.step);
        ties.push_back(sections.empty() ? TailSection{Vector3d::Zero(), Vector3d::UnitY(), 0} : sections.front());
    }
    const double guarded = std::max(1.5 * grid.step, StrandGrowth::parting_reach * head.volume.head_height);
    auto styled = std::make_shared<StyledField>(StyledField{{grid, Points::Zero(grid.count(), 3)},
                                                            PartingGuard(style.partings, *head.distance, grid.step, guarded),
                                                            TailTie(std::move(ties)),
                                                            wanted.empty()});
    if (wanted.empty()) {
        warnings.push_back({"style-empty", 1, {}, false});
        s.constraints.clear();
        s.update = updating.lap();
        s.field = 0;
    } else {
        std::vector<char> asked(static_cast<std::size_t>(grid.count()), 0);
        for (const FieldConstraint& c : wanted) asked[static_cast<std::size_t>(c.node)] = 1;
        const bool dense = wanted.size() + s.shell.size() <= static_cast<std::size_t>(dense_limit);
        Points near_scalp(static_cast<Eigen::Index>(s.shell.size()), 3);
        if (dense) {
            s.alone->set_constraints(wanted);
            near_scalp = s.alone->field_at(s.shell);
        } else {
            if (!s.many_alone) s.many_alone = std::make_unique<IterativeField>(s.bilaplacian);
            if (!s.many_whole) s.many_whole = std::make_unique<IterativeField>(s.bilaplacian);
            s.many_alone->set_constraints(wanted);
            const Points t = s.many_alone->field();
            for (std::size_t i = 0; i < s.shell.size(); ++i) near_scalp.row(static_cast<Eigen::Index>(i)) = t.row(s.shell[i]);
        }
        snap(near_scalp);
        // Where style and scalp both ask, the style has its way.
        std::vector<FieldConstraint> both = wanted;
        for (const FieldConstraint& c : shell_constraints(s.shell, near_scalp, grid, *head.distance))
            if (!asked[static_cast<std::size_t>(c.node)]) both.push_back(c);
        FieldSolver& solver = dense ? static_cast<FieldSolver&>(*s.whole) : *s.many_whole;
        solver.set_constraints(both);
        s.constraints = std::move(both);
        s.update = updating.lap();
        Stopwatch solving;
        styled->field.vectors = solver.field();
        snap(styled->field.vectors);
        s.field = solving.lap();
    }
    s.style = std::move(styled);
    s.warnings = std::move(warnings);
}

HairSession::Growth HairSession::grow(int from, int count, const GrowthOptions& growth, const DetailOptions& detail) const {
    if (from < 0 || count < 0 || from > most_strands - count)
        throw InvalidInput("too-many-strands", "A head takes up to 1,000,000 strands, but " +
                                                   std::to_string(static_cast<long long>(from) + count) +
                                                   " were asked for. A real head has about 100,000.");
    Growth out;
    out.head_ = state_->head;
    out.style_ = state_->style;
    GrowthOptions curled = growth;
    curled.wave = shortest_turn(detail, out.head_->volume.head_height);
    out.growth_ = std::make_unique<StrandGrowth>(out.head_->volume_of_roots, *out.head_->distance, out.style_->field,
                                                 out.head_->roots, out.style_->partings, std::move(curled));
    out.detail_options_ = detail;
    const bool none = out.style_->empty || count == 0;
    out.from_ = out.next_ = from;
    out.end_ = none ? from : from + count;
    out.guides_wanted_ = none ? 0 : StrandDetail::guides;
    if (none) // what is wrong with the options is said whether or not anything grows
        StrandDetail(out.head_->volume, *out.head_->distance, out.style_->partings, out.style_->tails, detail, growth.seed, {});
    out.figures_.reached.assign(out.style_->tails.sections().size(), 0);
    out.figures_.gathered.assign(out.style_->tails.sections().size(), 0);
    return out;
}

bool HairSession::Growth::step() {
    constexpr int slice = 64;
    if (next_ >= end_) return false;
    if (static_cast<int>(guides_.size()) < guides_wanted_) {
        for (int k = 0; k < slice && static_cast<int>(guides_.size()) < guides_wanted_; ++k)
            guides_.push_back(growth_->grow(guides_.size()));
        return true;
    }
    if (!detail_)
        detail_ = std::make_unique<StrandDetail>(head_->volume, *head_->distance, style_->partings, style_->tails, detail_options_,
                                                 growth_->options().seed, std::move(guides_)),
        guides_wanted_ = 0;
    if (strands_.root_triangle.empty()) {
        const auto count = static_cast<std::size_t>(end_ - from_);
        strands_.offsets.reserve(count + 1);
        strands_.root_triangle.reserve(count);
        strands_.clumps.reserve(count);
        strands_.root_weights.reserve(2 * count);
        strands_.root_uvs.reserve(2 * count);
    }
    for (int k = 0; k < slice && next_ < end_; ++k, ++next_) {
        Strand strand = growth_->grow(static_cast<std::uint64_t>(next_));
        strands_.clumps.push_back(static_cast<std::uint32_t>(detail_->apply(strand, static_cast<std::uint64_t>(next_))));
        add(strand);
    }
    return next_ < end_;
}

double HairSession::Growth::fraction() const {
    return end_ == from_ ? 1 : static_cast<double>(next_ - from_) / (end_ - from_);
}

void HairSession::Growth::add(const Strand& strand) {
    const std::size_t needed = strands_.points.size() + 3 * strand.points.size();
    if (needed > strands_.points.capacity()) { // by what is to come, not by doubling: memory counts here
        const double done = next_ - from_ + 1.0, all = end_ - from_;
        strands_.points.reserve(std::max(needed + needed / 16, std::min(needed * 2, static_cast<std::size_t>(1.02 * static_cast<double>(needed) / done * all) + 4096)));
    }
    const double deep = -0.005 * head_->volume.head_height;
    for (const Vector3d& p : strand.points) {
        for (int d = 0; d < 3; ++d) strands_.points.push_back(static_cast<float>(p[d]));
        if (head_->distance->at(p) < deep) ++figures_.inside_head;
    }
    strands_.offsets.push_back(static_cast<std::uint32_t>(strands_.points.size() / 3));
    strands_.root_triangle.push_back(strand.root.triangle);
    strands_.root_weights.push_back(static_cast<float>(strand.root.b));
    strands_.root_weights.push_back(static_cast<float>(strand.root.c));
    const Eigen::Vector2f uv = root_uv(strand.root.position, head_->volume.up);
    strands_.root_uvs.insert(strands_.root_uvs.end(), {uv.x(), uv.y()});
    if (strand.points.size() < 4) ++figures_.short_strands;
    for (std::size_t t = 0; t < style_->tails.sections().size(); ++t) {
        const TailPassage passage = passage_of(strand.points, style_->tails.sections()[t]);
        if (passage.reaches) ++figures_.reached[t];
        if (passage.reaches && passage.passes) ++figures_.gathered[t];
    }
}

const Vector3d& HairSession::origin() const { return state_->head->origin; }
const HairVolume& HairSession::volume() const { return state_->head->volume; }
const VectorField& HairSession::field() const { return state_->style->field; }
const std::vector<FieldConstraint>& HairSession::constraints() const { return state_->constraints; }
const std::vector<Finding>& HairSession::warnings() const { return state_->warnings; }
double HairSession::prepare_seconds() const { return state_->prepare; }
double HairSession::update_seconds() const { return state_->update; }
double HairSession::field_seconds() const { return state_->field; }

} // namespace lissom
