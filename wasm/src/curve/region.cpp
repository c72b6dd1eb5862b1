#include "lissom/curve/region.h"

#include "lissom/mesh/errors.h"
#include "lissom/mesh/plane_section.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace lissom {

using Eigen::Vector3d;

namespace {

SplineCurve in_working_space(const WorkingMesh& working, const SplineCurve& curve) {
    Points controls = curve.controls();
    for (Eigen::Index i = 0; i < controls.rows(); ++i) controls.row(i) = working.to_working(Vector3d(controls.row(i))).transpose();
    return SplineCurve(controls);
}

/// Nearest places on a curve for very many points: of a coarse row of samples the nearest, of the fine ones around it the nearest, then the
/// foot on the chords beside that. Where two stretches of the curve are about equally near, either may be told.
class SampledCurve {
public:
    explicit SampledCurve(const SplineCurve& curve) {
        const int count = k_coarse * k_fine * curve.span_count();
        for (int k = 0; k <= count; ++k) {
            samples_.push_back(curve.point(static_cast<double>(k) / count));
            along_.push_back(k == 0 ? 0 : along_.back() + (samples_[k] - samples_[k - 1]).norm());
        }
    }

    [[nodiscard]] NearestOnCurve nearest(const Vector3d& p) const {
        const int last = static_cast<int>(samples_.size()) - 1;
        const int coarse = best(p, 0, last, k_fine);
        const int i = best(p, std::max(0, coarse - k_fine), std::min(last, coarse + k_fine), 1);
        NearestOnCurve near{static_cast<double>(i) / last, (samples_[i] - p).norm()};
        for (const int from : {i - 1, i}) {
            if (from < 0 || from >= last) continue;
            const Vector3d chord = samples_[from + 1] - samples_[from];
            const double u = chord.squaredNorm() > 0 ? std::clamp((p - samples_[from]).dot(chord) / chord.squaredNorm(), 0.0, 1.0) : 0;
            if (const double distance = (samples_[from] + u * chord - p).norm(); distance < near.distance) near = {(from + u) / last, distance};
        }
        return near;
    }
    [[nodiscard]] double arc_length(double t) const {
        const double at = t * static_cast<double>(along_.size() - 1);
        const std::size_t i = std::min(static_cast<std::size_t>(at), along_.size() - 2);
        return along_[i] + (at - static_cast<double>(i)) * (along_[i + 1] - along_[i]);
    }
    [[nodiscard]] double length() const { return along_.back(); }

private:
    static constexpr int k_coarse = 4, k_fine = 8; // samples a span, and fine ones between those

    [[nodiscard]] int best(const Vector3d& p, int first, int last, int step) const {
        int found = first;
        double least = (samples_[first] - p).squaredNorm();
        for (int i = first + step; i <= last; i += step)
            if (const double squared = (samples_[i] - p).squaredNorm(); squared < least) {
                least = squared;
                found = i;
            }
        return found;
    }

    std::vector<Vector3d> samples_;
    std::vector<double> along_;
};

enum class Place : char { unknown, inside, before, after, beside };

/// Where vertices lie relative to a curve; each is looked at once.
class Places {
public:
    Places(const CurveSurface& surface, const SplineCurve& curve, std::vector<double> radius, const RegionOptions& options)
        : points_(surface.mesh().points), sampled_(curve), start_(curve.point(0)), end_(curve.point(1)), at_start_(curve.tangent(0)), at_end_(curve.tangent(1)), radius_(std::move(radius)), options_(options), place_(static_cast<std::size_t>(points_.rows()), Place::unknown),
          t_(place_.size(), 0) {}

    [[nodiscard]] Place of(int v) {
        if (place_[v] == Place::unknown) place_[v] = options_.method == RegionMethod::planes ? by_planes(points_.row(v)) : by_distance(points_.row(v), t_[v]);
        return place_[v];
    }
    [[nodiscard]] double t(int v) {
        (void)of(v);
        return t_[v];
    }
    /// Local radius, linear between control points.
    [[nodiscard]] double radius(double t) const {
        const double at = t * static_cast<double>(radius_.size() - 1);
        const std::size_t i = std::min(static_cast<std::size_t>(at), radius_.size() - 2);
        const double u = at - static_cast<double>(i);
        return (1 - u) * radius_[i] + u * radius_[i + 1];
    }
    /// Ways along the curve.
    [[nodiscard]] double from_start(double t) const { return sampled_.arc_length(t); }
    [[nodiscard]] double to_end(double t) const { return sampled_.length() - sampled_.arc_length(t); }
    [[nodiscard]] double largest_radius() const { return *std::max_element(radius_.begin(), radius_.end()); }

private:
    [[nodiscard]] Place by_distance(const Vector3d& p, double& t) const {
        const NearestOnCurve near = sampled_.nearest(p);
        t = near.t;
        if (t <= 0 && (p - start_).dot(at_start_) <= 0) return Place::before;
        if (t >= 1 && (p - end_).dot(at_end_) >= 0) return Place::after;
        return near.distance < options_.kappa * radius(t) ? Place::inside : Place::beside;
    }
    [[nodiscard]] Place by_planes(const Vector3d& p) const {
        if ((p - start_).dot(at_start_) < 0) return Place::before;
        return (p - end_).dot(at_end_) > 0 ? Place::after : Place::inside;
    }

    const Points& points_;
    SampledCurve sampled_;
    Vector3d start_, end_, at_start_, at_end_;
    std::vector<double> radius_;
    const RegionOptions& options_;
    std::vector<Place> place_;
    std::vector<double> t_;
};

/// Triangles to start from: those hit, or the nearest along the curve; of the thesis's method only the two at its ends.
std::vector<int> seed_triangles(const CurveSurface& surface, const SplineCurve& curve, const RegionOptions& options) {
    std::vector<int> seeds = options.hits;
    if (seeds.empty()) {
        const int steps = 8 * curve.span_count();
        for (int k = 0; k <= steps; ++k)
            if (const int t = surface.tree().nearest(curve.point(static_cast<double>(k) / steps)).triangle; t >= 0) seeds.push_back(t);
    }
    if (options.method == RegionMethod::planes && seeds.size() > 2) seeds = {seeds.front(), seeds.back()};
    return seeds;
}

enum class Part : char { open, region, start, end, between, still };

/// Grows the region and sorts what remains.
class Segmentation {
public:
    Segmentation(const CurveSurface& surface, const SplineCurve& curve, Places& places)
        : surface_(surface), curve_(curve), places_(places), part_(static_cast<std::size_t>(surface.mesh().vertex_count()), Part::open) {}

    void flood(const std::vector<int>& triangles) {
        for (const int t : triangles)
            for (int k = 0; k < 3; ++k) grow(surface_.mesh().triangles(t, k));
    }

    /// Pieces of the model that no seed lies on: all that is inside.
    void add_other_pieces() {
        const Components pieces = components(surface_.rings());
        piece_ = pieces.of_vertex;
        has_region_.assign(static_cast<std::size_t>(pieces.count), 0);
        for (std::size_t v = 0; v < part_.size(); ++v)
            if (part_[v] == Part::region) has_region_[piece_[v]] = 1;
        if (pieces.count == 1) return;
        Eigen::AlignedBox3d near;
        for (int k = 0; k <= 64; ++k) near.extend(curve_.point(k / 64.0));
        const Vector3d reach = Vector3d::Constant(places_.largest_radius() * 4);
        near = {near.min() - reach, near.max() + reach};
        const std::vector<char> seeded = has_region_;
        for (int v = 0; v < static_cast<int>(part_.size()); ++v)
            if (!seeded[piece_[v]] && near.contains(Vector3d(surface_.mesh().points.row(v))) && places_.of(v) == Place::inside) {
                part_[v] = Part::region;
                has_region_[piece_[v]] = 1;
            }
    }

    /// Sorts the rest, piece by piece of what hangs together outside the region.
    void sort_rest() {
        for (int v = 0; v < static_cast<int>(part_.size()); ++v) {
            if (part_[v] != Part::open) continue;
            if (has_region_[piece_[v]]) {
                sort_piece(v);
            } else {
                const Place place = places_.of(v);
                part_[v] = place == Place::before ? Part::start : place == Place::after ? Part::end : Part::still;
            }
        }
    }

    [[nodiscard]] std::vector<int> source(Part part) const {
        std::vector<int> found;
        for (int v = 0; v < static_cast<int>(part_.size()); ++v)
            if (part_[v] == part) found.push_back(v);
        return surface_.source_vertices(found);
    }
    [[nodiscard]] bool empty() const { return std::find(part_.begin(), part_.end(), Part::region) == part_.end(); }

private:
    void grow(int seed) {
        std::vector<int> open{seed};
        while (!open.empty()) {
            const int v = open.back();
            open.pop_back();
            if (part_[v] != Part::open || places_.of(v) != Place::inside) continue;
            part_[v] = Part::region;
            for (const int w : surface_.rings()[v])
                if (part_[w] == Part::open) open.push_back(w);
        }
    }

    void sort_piece(int seed) {
        std::vector<int> piece{seed};
        part_[seed] = Part::still; // seen
        bool at_start = false, at_end = false;
        for (std::size_t i = 0; i < piece.size(); ++i)
            for (const int w : surface_.rings()[piece[i]]) {
                if (part_[w] == Part::region) touch(piece[i], at_start, at_end);
                if (part_[w] != Part::open) continue;
                part_[w] = Part::still;
                piece.push_back(w);
            }
        const Part part = at_start ? (at_end ? Part::between : Part::start) : at_end ? Part::end : Part::region;
        for (const int v : piece) part_[v] = part;
    }

    /// Which end a border of the region lies at, if any: beyond a disk, or, where it is too far from the curve, within that reach of one.
    void touch(int outside, bool& at_start, bool& at_end) {
        const Place place = places_.of(outside);
        const double t = places_.t(outside);
        const double reach = places_.radius(t);
        at_start |= place == Place::before || (place == Place::beside && places_.from_start(t) < reach);
        at_end |= place == Place::after || (place == Place::beside && places_.to_end(t) < reach);
    }

    const CurveSurface& surface_;
    const SplineCurve& curve_;
    Places& places_;
    std::vector<Part> part_;
    std::vector<int> piece_;
    std::vector<char> has_region_;
};

} // namespace

CurveRegion curve_region(const CurveSurface& surface, const SplineCurve& rest, const std::vector<double>& given, const RegionOptions& options) {
    if (!(options.kappa > 0) || !std::isfinite(options.kappa))
        throw InvalidInput("curve-reach", "The reach of a curve must be greater than 0; it is " + std::to_string(options.kappa) + ". 1.5 is usual.");
    std::vector<double> radius = given.empty() ? curve_radius(surface, rest) : given;
    const bool fits = std::ssize(radius) == rest.control_count() && std::all_of(radius.begin(), radius.end(), [](double r) { return r > 0 && std::isfinite(r); });
    if (!fits)
        throw InvalidInput("curve-radius", "A curve of " + std::to_string(rest.control_count()) + " control points needs as many radii, all greater than 0. Give them, or leave them out.");
    for (double& r : radius) r /= surface.working().scale;
    const SplineCurve curve = in_working_space(surface.working(), rest);
    Places places(surface, curve, std::move(radius), options);
    Segmentation parts(surface, curve, places);
    parts.flood(seed_triangles(surface, curve, options));
    parts.add_other_pieces();
    if (parts.empty()) return {};
    parts.sort_rest();
    CurveRegion found{parts.source(Part::region), {}, parts.source(Part::start), parts.source(Part::end), parts.source(Part::between)};
    found.places.reserve(found.vertices.size());
    for (const int v : found.vertices) found.places.push_back(places.t(surface.working().working_of_source[v]));
    return found;
}

CurveRegion curve_region(const WorkingMesh& model, const SplineCurve& rest, const std::vector<double>& radius, double kappa) {
    return curve_region(CurveSurface(model), rest, radius, {.kappa = kappa});
}

std::vector<double> curve_radius(const CurveSurface& surface, const SplineCurve& source) {
    const SplineCurve curve = in_working_space(surface.working(), source);
    constexpr double least = 1e-6; // of the diagonal: a curve far from everything reaches nothing
    std::vector<double> radius;
    for (int i = 0; i < curve.control_count(); ++i) {
        const double t = static_cast<double>(i) / (curve.control_count() - 1);
        const Vector3d p = curve.point(t), u = curve.tangent(t);
        // A hair inside an end, whose plane may lie in a flat cap.
        const Vector3d at = i == 0 ? Vector3d(p + 1e-6 * u) : i == curve.control_count() - 1 ? Vector3d(p - 1e-6 * u) : p;
        const std::vector<SectionLine> lines = plane_section(surface.mesh(), surface.tree(), u, at);
        const int l = line_around(lines, u, at);
        double r = 0;
        if (l >= 0) {
            const SectionLine& line = lines[l];
            const double near = line.nearest(at);
            if (!line.closed) r = line.radius();
            else if (near > 0.25 * line.radius()) r = std::min(line.radius(), 1.8 * near);
            else r = 0.7 * line.farthest(at);
        }
        radius.push_back(r);
    }
    // Where a plane misses the model (beyond its tip), as at the nearest control point that has one.
    for (std::size_t i = 0; i < radius.size(); ++i)
        for (std::size_t step = 1; step < radius.size() && radius[i] <= 0; ++step) {
            if (i >= step && radius[i - step] > 0) radius[i] = radius[i - step];
            else if (i + step < radius.size() && radius[i + step] > 0) radius[i] = radius[i + step];
        }
    for (double& r : radius) r = surface.working().scale * std::max(r, least);
    return radius;
}

} // namespace lissom
