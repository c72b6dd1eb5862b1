#include "lissom/curve/extract.h"

#include "lissom/curve/region.h"
#include "lissom/curve/spline.h"
#include "lissom/mesh/errors.h"
#include "lissom/mesh/plane_section.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

namespace lissom {

using Eigen::Vector3d;

namespace {

/// What one ray of a stroke met, in working space.
struct Through {
    int triangle = -1; ///< −1: nothing
    Vector3d entry = Vector3d::Zero(), exit = Vector3d::Zero();
    bool leaves = false; ///< there is an exit
    bool within = false; ///< an odd number of crossings: the ray began inside, where the model is closed

    [[nodiscard]] Vector3d middle() const { return (entry + exit) / 2; }
    [[nodiscard]] double half_depth() const { return (exit - entry).norm() / 2; }
};

/// Two crossings nearer than this are one, at an edge or a doubled sheet; in diagonals.
constexpr double k_same = 1e-6;
/// A ray through more than so many half widths of the limb has gone on into something else.
constexpr double k_deepest = 1.5;
/// No part of a limb counts as thicker than so many times its median half depth.
constexpr double k_thickest = 1.8;

Through cast(const CurveSurface& surface, const Vector3d& origin, const Vector3d& direction) {
    const Vector3d from = surface.working().to_working(origin), along = direction.normalized();
    Through through;
    int crossings = 0;
    double last = 0;
    for (const RayHit& hit : surface.tree().hits(from, along)) {
        if (crossings > 0 && hit.depth - last < k_same) continue;
        last = hit.depth;
        if (++crossings == 1) {
            through.triangle = hit.triangle;
            through.entry = through.exit = from + hit.depth * along;
        } else if (crossings == 2) {
            through.exit = from + hit.depth * along;
            through.leaves = true;
        }
    }
    through.within = surface.working().closed && crossings % 2 == 1;
    return through;
}

/// Half the width of a limb on the screen: how far to the left and to the right of where the ray enters the surface goes on without a
/// jump in depth. One side more than twice as far as the other has run into something else and does not count. Infinite where neither side ends within three half depths.
double half_width(const CurveSurface& surface, const Through& ray, const Vector3d& along, const Vector3d& stroke) {
    constexpr int steps = 8; // a half depth
    const double reach = ray.half_depth(), step = reach / steps;
    const Vector3d aside = along.cross(stroke).normalized();
    std::array<double, 2> width{};
    width.fill(std::numeric_limits<double>::infinity());
    for (const int side : {0, 1}) {
        double before = reach;
        for (int k = 1; k <= 3 * steps; ++k) {
            const Vector3d from = ray.entry + (2 * side - 1) * k * step * aside - reach * along;
            const std::vector<RayHit> hits = surface.tree().hits(from, along);
            if (!hits.empty() && hits.front().depth - before < 4 * step) {
                before = hits.front().depth;
                continue;
            }
            width[side] = (k - 0.5) * step;
            break;
        }
    }
    const auto [less, more] = std::minmax(width[0], width[1]);
    return more > 2 * less ? less : (less + more) / 2;
}

/// Lets ray i end where the limb is as deep as wide, if it goes on into something else.
void limit_depth(const CurveSurface& surface, std::vector<Through>& all, int i, const Vector3d& along) {
    if (all[i].triangle < 0 || !all[i].leaves) return;
    const int a = std::max(0, i - 2), b = std::min(static_cast<int>(all.size()) - 1, i + 2);
    const Vector3d stroke = all[b].entry - all[a].entry;
    const double width = half_width(surface, all[i], along, stroke - stroke.dot(along) * along);
    if (all[i].half_depth() > k_deepest * width) all[i].exit = all[i].entry + 2 * width * along;
}

Finding finding(const char* code, int count) { return {.code = code, .count = count, .examples = {}, .repaired = true}; }

/// Samples that met nothing between others that did: as far along as those beside them.
int bridge(std::vector<Through>& all) {
    int bridged = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (all[i].triangle >= 0) continue;
        std::size_t before = i - 1, after = i;
        while (all[after].triangle < 0) ++after; // the last one met something
        for (; i < after; ++i, ++bridged) {
            const double u = static_cast<double>(i - before) / static_cast<double>(after - before);
            all[i].entry = (1 - u) * all[before].entry + u * all[after].entry;
            all[i].exit = (1 - u) * all[before].exit + u * all[after].exit;
            all[i].leaves = all[before].leaves && all[after].leaves;
        }
    }
    return bridged;
}

/// Of samples about a place that is no whole number, the mean; it takes the last trembling out of entries and exits.
template <class Value>
auto about(const std::vector<Through>& all, double at, Value value) {
    const int middle = static_cast<int>(std::lround(at)), last = static_cast<int>(all.size()) - 1;
    const int reach = std::min({1, middle, last - middle});
    auto sum = value(all[middle]);
    for (int k = 1; k <= reach; ++k) sum += value(all[middle - k]) + value(all[middle + k]);
    return decltype(sum)(sum / (2 * reach + 1));
}

SplineCurve through(const std::vector<Vector3d>& at) {
    Points controls(std::ssize(at), 3);
    for (std::size_t i = 0; i < at.size(); ++i) controls.row(static_cast<Eigen::Index>(i)) = at[i].transpose();
    return SplineCurve(controls);
}

double median(std::vector<double> values) {
    std::nth_element(values.begin(), values.begin() + std::ssize(values) / 2, values.end());
    return values[values.size() / 2];
}

/// Moves the points to the centres of their limb's sections where those are the limb's. @returns its radius at each
std::vector<double> centre(const CurveSurface& surface, std::vector<Vector3d>& at, const std::vector<double>& half_depth, int rounds) {
    const std::vector<Vector3d> start = at;
    const double usual = median(half_depth);
    std::vector<double> radius = half_depth;
    for (double& r : radius) r = std::min(r, k_thickest * usual);
    const std::vector<double> fallback = radius;
    for (int round = 0; round < rounds; ++round) {
        const SplineCurve curve = through(at);
        for (std::size_t i = 0; i < at.size(); ++i) {
            const Vector3d u = curve.tangent(static_cast<double>(i) / static_cast<double>(at.size() - 1));
            const std::vector<SectionLine> lines = plane_section(surface.mesh(), surface.tree(), u, at[i]);
            const int l = line_around(lines, u, at[i]);
            const bool is_limb = l >= 0 && lines[l].closed && lines[l].radius() < 1.6 * fallback[i] && (lines[l].centroid - start[i]).norm() < fallback[i];
            at[i] = is_limb ? lines[l].centroid : start[i];
            radius[i] = is_limb ? lines[l].radius() : fallback[i];
        }
    }
    return radius;
}

} // namespace

ExtractedCurve extract_curve(const CurveSurface& surface, const Stroke& drawn, const ExtractOptions& options) {
    const Stroke line = filtered(drawn, options.filter);
    std::vector<Through> all;
    for (int i = 0; i < line.size(); ++i) all.push_back(cast(surface, line.origins.row(i), line.directions.row(i)));

    // Walk inwards from both ends to the first hit.
    int first = 0, last = line.size() - 1;
    while (first <= last && all[first].triangle < 0) ++first;
    while (last >= first && all[last].triangle < 0) --last;
    if (last < first) throw InvalidInput("stroke-off-model", "The stroke does not touch the model. Draw over the part you want to bend.");
    if (last == first) throw InvalidInput("stroke-too-short", "Only one point of the stroke lies on the model. Draw along the part you want to bend.");
    ExtractedCurve curve;
    if (const int beside = first + line.size() - 1 - last; beside > 0) curve.warnings.push_back(finding("stroke-overshoots", beside));
    all.assign(all.begin() + first, all.begin() + last + 1);
    if (2 * std::count_if(all.begin(), all.end(), [](const Through& t) { return t.within; }) > std::ssize(all))
        throw InvalidInput("eye-inside-model", "The stroke was drawn from inside the model. Move the view back until you see the model from outside, then draw again.");
    for (const Through& t : all)
        if (t.triangle >= 0 && (curve.hits.empty() || curve.hits.back() != t.triangle)) curve.hits.push_back(t.triangle);
    if (const int bridged = bridge(all); bridged > 0) curve.warnings.push_back(finding("stroke-crosses-gap", bridged));

    const bool is_sheet = 2 * std::count_if(all.begin(), all.end(), [](const Through& t) { return t.leaves; }) < std::ssize(all);
    curve.kind = is_sheet || options.kind == ExtractOptions::Kind::surface ? CurveKind::surface : CurveKind::skeleton;
    if (is_sheet && options.kind == ExtractOptions::Kind::skeleton) curve.warnings.push_back(finding("open-sheet", 1));

    std::vector<Vector3d> at;
    std::vector<double> half_depth;
    std::vector<char> limited(all.size(), 0);
    for (const double sample : control_samples(part_of(line, first, last), options.fit, options.least_controls, options.most_controls)) {
        const int middle = static_cast<int>(std::lround(sample));
        if (curve.kind == CurveKind::surface) {
            at.push_back(all[middle].entry);
        } else {
            for (int i = std::max(0, middle - 1); i <= std::min(static_cast<int>(all.size()) - 1, middle + 1); ++i)
                if (!limited[i]) {
                    limited[i] = 1;
                    limit_depth(surface, all, i, line.directions.row(first + i).normalized());
                }
            at.push_back(about(all, sample, [](const Through& t) { return t.middle(); }));
            half_depth.push_back(about(all, sample, [](const Through& t) { return t.half_depth(); }));
        }
    }
    if (curve.kind == CurveKind::skeleton) curve.radius = centre(surface, at, half_depth, options.rounds);
    curve.controls.resize(std::ssize(at), 3);
    for (std::size_t i = 0; i < at.size(); ++i) curve.controls.row(static_cast<Eigen::Index>(i)) = surface.working().to_source(at[i]).transpose();
    if (curve.kind == CurveKind::surface) curve.radius = curve_radius(surface, SplineCurve(curve.controls));
    else
        for (double& r : curve.radius) r = surface.working().scale * std::max(r, k_same);
    return curve;
}

} // namespace lissom
