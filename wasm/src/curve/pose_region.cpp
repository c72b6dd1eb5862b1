// What of a model follows one curve, and which places of it.

#include "pose_state.h"

#include "lissom/mesh/errors.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lissom {

using Eigen::Vector3d;

namespace {

constexpr float k_far = std::numeric_limits<float>::infinity();

/// Radius at each control point from points alone: the median distance of those whose nearest place is not far from it, the farther ones,
/// of other limbs, left out.
std::vector<double> cloud_radii(const SplineCurve& curve, const std::vector<NearestOnCurve>& nearest) {
    const int controls = curve.control_count();
    std::vector<double> result(controls, 0.0);
    for (int i = 0; i < controls; ++i) {
        std::vector<double> around;
        for (const auto& [t, distance] : nearest)
            if (t > 0 && t < 1 && std::abs(t * (controls - 1) - i) < 0.75) around.push_back(distance);
        if (around.empty()) continue;
        std::sort(around.begin(), around.end());
        const double close = around[around.size() / 10];
        while (around.back() > std::max(4 * close, 1e-9 * curve.length())) {
            if (around.size() == 1) break;
            around.pop_back();
        }
        result[i] = around[around.size() / 2];
    }
    const double largest = *std::max_element(result.begin(), result.end());
    for (double& r : result)
        if (!(r > 0)) r = largest > 0 ? largest : curve.length() / 10;
    return result;
}

} // namespace

void CurveSession::State::find_region(int c) {
    const CurveSpec& spec = specs[c];
    CurveField& field = fields[c];
    const int places = place_count();
    const SplineCurve centred = rest_spline(less(spec.rest, centre), spec.rigid);
    if (!(centred.length() > 0)) throw InvalidInput("curve-without-length", "All control points of curve " + std::to_string(c + 1) + " lie in one place. Draw it longer.");
    field.side.assign(places, CurveSide::none);
    field.row.assign(places, 0);
    field.distance.assign(places, k_far);
    const auto look_at = [&](int p, const NearestOnCurve& near) {
        field.row[p] = static_cast<float>(near.t <= 0 ? 0 : near.t >= 1 ? k_last : centred.arc_length(near.t) / centred.length() * k_last);
        field.distance[p] = static_cast<float>(near.distance);
    };
    const auto working = [&](int v) { return model ? model->working_of_source[v] : v; };

    if (model) {
        const SplineCurve in_source = rest_spline(spec.rest, spec.rigid);
        radii[c] = curve_radius(*surface, in_source);
        if (order.linked[c]) {
            // At a link the section is that of the trunk; the limb is as thick as it is one control point on.
            std::vector<double>& r = radii[c];
            r.front() = std::min(r.front(), r[1]);
            r.back() = std::min(r.back(), r[r.size() - 2]);
            for (int p = 0; p < places; ++p) look_at(p, centred.nearest(place(p)));
            if (spec.region)
                for (const int v : *spec.region)
                    if (working(v) >= 0) field.side[working(v)] = CurveSide::inside;
        } else {
            std::vector<int> inside;
            std::vector<double> near;
            if (spec.region) inside = *spec.region;
            else {
                RegionOptions reach;
                reach.kappa = options.kappa;
                const CurveRegion found = curve_region(*surface, in_source, radii[c], reach);
                const auto mark = [&](const std::vector<int>& vertices, CurveSide side) {
                    for (const int v : vertices)
                        if (working(v) >= 0) field.side[working(v)] = side;
                };
                mark(found.startSide, CurveSide::start);
                mark(found.endSide, CurveSide::end);
                mark(found.between, CurveSide::between);
                inside = found.vertices;
                near = found.places;
            }
            for (std::size_t i = 0; i < inside.size(); ++i) {
                const int p = working(inside[i]);
                if (p < 0) continue;
                field.side[p] = CurveSide::inside;
                if (field.distance[p] == k_far) look_at(p, near.empty() ? centred.nearest(place(p)) : centred.nearest(place(p), near[i]));
            }
            if (spec.region) sort_remainder(surface->rings(), field);
            double mean = 0;
            for (const double r : radii[c]) mean += r / static_cast<double>(radii[c].size());
            smooth_rows(model->mesh, surface->rings(), field, centred.length() / model->scale / k_last, mean / model->scale);
        }
    } else {
        std::vector<NearestOnCurve> nearest(places);
        for (int p = 0; p < places; ++p)
            if (rest.row(p).allFinite()) {
                nearest[p] = centred.nearest(place(p));
                look_at(p, nearest[p]);
            } else nearest[p] = {0, std::numeric_limits<double>::infinity()};
        radii[c] = cloud_radii(centred, nearest);
    }

    EncodedCurveOptions encoding;
    encoding.rigid = spec.rigid;
    encoding.radius = radii[c];
    encoding.kernel = options.kernel;
    encoding.held = order.link[c] < 0;
    if (!model) {
        const EncodedCurve measured(less(spec.rest, centre), encoding);
        const CurveSide far = spec.anchor == CurveEnd::end ? CurveSide::end : CurveSide::start;
        std::vector<bool> named(places, false);
        if (spec.region)
            for (const int v : *spec.region) named[v] = true;
        for (int p = 0; p < places; ++p) {
            if (!rest.row(p).allFinite()) continue;
            const bool near = field.distance[p] < options.kappa * measured.radius_at(field.row[p]);
            const bool beyond = field.row[p] <= 0 || field.row[p] >= k_last;
            if (spec.region ? named[p] : near && !beyond) field.side[p] = CurveSide::inside;
            else if (beyond) field.side[p] = field.row[p] <= 0 ? CurveSide::start : CurveSide::end;
            else field.side[p] = far;
        }
    }
    for (int v = 0; v < rest.rows(); ++v) {
        const int p = working(v);
        if (p < 0) continue;
        const bool inside = order.linked[c] && !spec.region ? field.row[p] > 0 && field.row[p] < k_last : field.side[p] == CurveSide::inside;
        if (inside) regions[c].push_back(v);
    }
    if (regions[c].empty()) {
        const auto known = std::find_if(warnings.begin(), warnings.end(), [](const Finding& f) { return f.code == "empty-region"; });
        Finding& finding = known == warnings.end() ? warnings.emplace_back(Finding{"empty-region", 0, {}, false}) : *known;
        ++finding.count;
        if (finding.examples.size() < 8) finding.examples.push_back(c);
    }

    // The anchor: a child hangs on the end that is nearer to its parent, a root stays at the end with more beyond it.
    if (spec.anchor) encoding.anchor = *spec.anchor;
    else if (order.link[c] >= 0) {
        const CurveLink& link = links[order.link[c]];
        const Vector3d at = rest_spline(specs[link.parent].rest, specs[link.parent].rigid).point(link.at);
        const auto away = [&](Eigen::Index row) { return (spec.rest.row(row).transpose() - at).norm(); };
        encoding.anchor = away(0) <= away(spec.rest.rows() - 1) ? CurveEnd::start : CurveEnd::end;
    } else {
        int at_start = 0, at_end = 0;
        for (int p = 0; p < places; ++p) {
            const bool start = order.linked[c] ? field.row[p] <= 0 : field.side[p] == CurveSide::start;
            const bool end = order.linked[c] ? field.row[p] >= k_last : field.side[p] == CurveSide::end;
            at_start += start;
            at_end += end;
        }
        encoding.anchor = at_start >= at_end ? CurveEnd::start : CurveEnd::end;
    }
    curves.emplace_back(less(spec.rest, centre), encoding);
}

} // namespace lissom
