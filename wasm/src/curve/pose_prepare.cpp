// How a session comes to know which curve moves which vertex.

#include "pose_state.h"

#include "lissom/curve/line_weights.h"
#include "lissom/mesh/errors.h"
#include "lissom/mesh/stopwatch.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lissom {

using Eigen::Vector3d;

namespace {

constexpr float k_far = std::numeric_limits<float>::infinity();
constexpr double k_last = EncodedCurve::k_rows - 1;

void check_options(const CurveOptions& options) {
    const auto share = [](double x, double most) { return std::isfinite(x) && x >= 0 && x <= most; };
    if (!share(options.kernel, 10) || !share(options.blend, 10) || !(options.kappa > 0) || !share(options.kappa, 100))
        throw InvalidInput("bad-option", "Widths of curves are numbers from 0 to 10 radii, reaches from above 0 to 100.");
}

Points less(const Points& points, const Vector3d& centre) { return points.rowwise() - centre.transpose(); }

SplineCurve spline(const Points& points, const std::vector<int>& rigid) {
    SplineOptions options;
    options.rigid = rigid;
    return SplineCurve(points, options);
}

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

CurveSession::CurveSession(std::shared_ptr<const WorkingMesh> model, std::vector<CurveSpec> curves, std::vector<CurveLink> links, CurveOptions options)
    : state_(std::make_unique<State>()) {
    state_->model = std::move(model);
    state_->specs = std::move(curves);
    state_->links = std::move(links);
    state_->options = options;
    state_->begin();
}

CurveSession::CurveSession(const Points& cloud, std::vector<CurveSpec> curves, std::vector<CurveLink> links, CurveOptions options)
    : state_(std::make_unique<State>()) {
    state_->source = cloud;
    state_->specs = std::move(curves);
    state_->links = std::move(links);
    state_->options = options;
    state_->begin();
}

CurveSession::~CurveSession() = default;
CurveSession::CurveSession(CurveSession&&) noexcept = default;

void CurveSession::State::begin() {
    const int count = static_cast<int>(specs.size());
    if (count == 0) throw InvalidInput("no-curve", "There is no curve to pose. Draw one.");
    check_options(options);
    order = link_order(count, links);
    order.linked.assign(count, false); // a contour on a limb makes no skeleton
    for (const CurveLink& link : links)
        if (!is_contour(link.child) && !is_contour(link.parent)) order.linked[link.child] = order.linked[link.parent] = true;
    for (const CurveSpec& spec : specs) {
        (void)spline(spec.rest, spec.rigid); // refuses what is none
        for (const Points& still : spec.held) (void)spline(still, {});
        if (!(spec.reach >= 0) || !std::isfinite(spec.reach))
            throw InvalidInput("line-radius", "A line's reach must be 0 or more; it is " + std::to_string(spec.reach) + ".");
        if (!spec.region) continue;
        for (const int v : *spec.region)
            if (v < 0 || v >= given().rows())
                throw InvalidInput("vertex-out-of-range", "The region of a curve names vertex " + std::to_string(v) + "; the model has " + std::to_string(given().rows()) + ".");
    }
    if (model) centre = model->centre;
    else {
        Vector3d low = Vector3d::Constant(std::numeric_limits<double>::infinity()), high = -low;
        for (int v = 0; v < source.rows(); ++v)
            if (source.row(v).allFinite()) {
                low = low.cwiseMin(source.row(v).transpose());
                high = high.cwiseMax(source.row(v).transpose());
            }
        if (low.x() <= high.x()) centre = (low + high) / 2;
    }
    rest = less(given(), centre);
    regions.resize(count);
    fields.resize(count);
    radii.resize(count);
}

bool CurveSession::step() {
    State& s = *state_;
    const int count = static_cast<int>(s.specs.size());
    Stopwatch watch;
    if (s.phase == 0) {
        if (s.model) s.surface = std::make_unique<CurveSurface>(s.model);
        s.seconds.regions += watch.lap();
    } else if (s.phase <= count) {
        if (s.is_contour(s.phase - 1)) s.find_pull(s.phase - 1);
        else s.find_region(s.phase - 1);
        s.seconds.regions += watch.lap();
    } else if (s.phase == count + 1) {
        s.assign();
        s.seconds.encode += watch.lap();
    }
    ++s.phase;
    return s.phase <= count + 1;
}

double CurveSession::fraction() const { return std::min(1.0, static_cast<double>(state_->phase) / static_cast<double>(state_->specs.size() + 2)); }

void CurveSession::State::find_pull(int c) {
    constexpr int samples = 200;
    const auto line_of = [](const Points& controls, const std::vector<int>& rigid) {
        const SplineCurve drawn = spline(controls, rigid);
        Polyline line;
        for (int k = 0; k < samples; ++k) line.push_back(drawn.point(drawn.parameter(drawn.length() * k / (samples - 1))));
        return line;
    };
    CurveField& field = fields[c];
    field.side.assign(place_count(), CurveSide::none);
    field.row.assign(place_count(), 0);
    field.distance.assign(place_count(), 0); // of a contour: the weight
    std::vector<Polyline> others;
    for (int other = 0; other < static_cast<int>(specs.size()); ++other)
        if (other != c && is_contour(other)) others.push_back(line_of(specs[other].rest, specs[other].rigid));
    for (const Points& still : specs[c].held) others.push_back(line_of(still, {}));
    LineWeightsOptions how;
    how.radius = specs[c].reach;
    const LineWeights found = line_weights(*surface, line_of(specs[c].rest, specs[c].rigid), others, how);
    std::vector<bool> named(static_cast<std::size_t>(rest.rows()), !specs[c].region);
    if (specs[c].region)
        for (const int v : *specs[c].region) named[v] = true;
    for (std::size_t k = 0; k < found.vertices.size(); ++k) {
        const int v = found.vertices[k], p = model->working_of_source[v];
        if (p < 0 || !named[v]) continue;
        field.side[p] = CurveSide::inside;
        field.row[p] = static_cast<float>(found.along[k] * k_last);
        field.distance[p] = static_cast<float>(found.weights[k]);
        regions[c].push_back(v);
    }
    EncodedCurveOptions encoding;
    encoding.rigid = specs[c].rigid;
    encoding.anchor = specs[c].anchor.value_or(CurveEnd::start);
    const SplineCurve drawn = spline(specs[c].rest, specs[c].rigid);
    encoding.radius.assign(specs[c].rest.rows(), drawn.length() / 10); // read by nothing: a line has no width
    radii[c] = encoding.radius;
    curves.emplace_back(less(specs[c].rest, centre), encoding);
}

void CurveSession::State::find_region(int c) {
    const CurveSpec& spec = specs[c];
    CurveField& field = fields[c];
    const int places = place_count();
    const SplineCurve centred = spline(less(spec.rest, centre), spec.rigid);
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
        const SplineCurve in_source = spline(spec.rest, spec.rigid);
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
            }
            for (const int v : inside) {
                const int p = working(v);
                if (p < 0) continue;
                field.side[p] = CurveSide::inside;
                if (field.distance[p] == k_far) look_at(p, centred.nearest(place(p)));
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
        const Vector3d at = spline(specs[link.parent].rest, specs[link.parent].rigid).point(link.at);
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

void CurveSession::State::assign() {
    const int count = static_cast<int>(specs.size()), places = place_count();
    // Who owns a vertex: a curve of its own whose region it lies in; what lies beyond the free end of such a curve; a linked curve; what is
    // left, the nearest curve of its own. The last column is what rests.
    std::vector<int> owner(places, count);
    std::vector<std::array<int, 3>> sizes(count, {0, 0, 0}); // start, end, between
    for (int c = 0; c < count; ++c)
        for (int p = 0; p < places; ++p) {
            const CurveSide side = fields[c].side[p];
            if (side >= CurveSide::start) ++sizes[c][static_cast<int>(side) - static_cast<int>(CurveSide::start)];
        }
    bool some_linked = false; // limbs, that is
    int limbs = 0;
    for (int c = 0; c < count; ++c) {
        some_linked = some_linked || (order.linked[c] && !is_contour(c));
        limbs += !is_contour(c);
    }
    for (int p = 0; p < places; ++p) {
        if (!place(p).allFinite()) continue;
        int best = count, free_end = count, linked = count, left = count;
        double nearest = std::numeric_limits<double>::infinity(), nearest_linked = nearest, nearest_left = nearest;
        int smallest = std::numeric_limits<int>::max();
        for (int c = 0; c < count; ++c) {
            if (is_contour(c)) continue; // owns nothing: it pulls what others own
            const CurveField& field = fields[c];
            const CurveSide side = field.side[p];
            const double gap = std::isinf(field.distance[p]) ? std::numeric_limits<double>::infinity() : field.distance[p] - curves[c].radius_at(field.row[p]);
            if (order.linked[c]) {
                const bool named = !specs[c].region || side == CurveSide::inside;
                const double wanted = specs[c].region && named ? gap - 1e9 : gap; // what a recipe names is the curve's
                if (wanted < nearest_linked) {
                    nearest_linked = wanted;
                    linked = c;
                }
                continue;
            }
            if (side == CurveSide::inside) {
                const double known = std::isinf(gap) ? 0 : gap;
                if (known < nearest) {
                    nearest = known;
                    best = c;
                }
                continue;
            }
            if (side == CurveSide::none) continue;
            const CurveSide anchored = curves[c].options().anchor == CurveEnd::start ? CurveSide::start : CurveSide::end;
            if (side != anchored) {
                const int size = sizes[c][static_cast<int>(side) - static_cast<int>(CurveSide::start)];
                if (size < smallest) {
                    smallest = size;
                    free_end = c;
                }
            } else {
                const double away = (place(p) - curves[c].frame_at(anchored == CurveSide::start ? 0 : k_last).origin).norm();
                if (away < nearest_left) {
                    nearest_left = away;
                    left = c;
                }
            }
        }
        owner[p] = best < count ? best : free_end < count ? free_end : some_linked ? linked : left;
    }
    if (model && some_linked) owner = joined_owners(surface->rings(), owner);
    // Limbs that share the model have of their reach what is theirs.
    for (int c = 0; c < count; ++c)
        if (order.linked[c] && !is_contour(c) && !specs[c].region)
            std::erase_if(regions[c], [&](int v) { return owner[model ? model->working_of_source[v] : v] != c; });

    // Over how far owners blend: the limb's radius at the nearest link; without links the thinnest place of any curve.
    std::vector<std::pair<Vector3d, double>> widths;
    for (const CurveLink& link : links) {
        if (!order.linked[link.child]) continue;
        const bool at_start = curves[link.child].options().anchor == CurveEnd::start;
        widths.emplace_back(curves[link.child].curve().point(at_start ? 0 : 1), at_start ? radii[link.child].front() : radii[link.child].back());
    }
    double thinnest = std::numeric_limits<double>::infinity();
    for (int c = 0; c < count; ++c)
        if (!is_contour(c)) thinnest = std::min(thinnest, *std::min_element(radii[c].begin(), radii[c].end()));
    const bool blends = model && limbs > 1 && options.blending != CurveBlending::gaussian;
    std::vector<double> rho(blends ? static_cast<std::size_t>(places) : 0);
    for (std::size_t p = 0; p < rho.size(); ++p) {
        double width = thinnest, nearest = std::numeric_limits<double>::infinity();
        for (const auto& [at, radius] : widths)
            if (const double away = (place(static_cast<int>(p)) - at).squaredNorm(); away < nearest) {
                nearest = away;
                width = radius;
            }
        rho[p] = options.blend * width / model->scale;
    }
    const OwnerShares shares = !blends ? whole_shares(owner)
                               : options.blending == CurveBlending::geodesic ? geodesic_shares(model->mesh, owner, rho)
                                                                             : diffused_shares(model->mesh, owner, rho);
    encode(shares, owner);
}

void CurveSession::State::encode(const OwnerShares& shares, std::span<const int> owner) {
    const int count = static_cast<int>(specs.size()), places = place_count();
    const bool in_slabs = options.encoding == CurveEncoding::slabs;
    std::vector<std::vector<double>> between(count);
    for (int c = 0; c < count; ++c)
        if (model && !order.linked[c] && !is_contour(c)) between[c] = between_shares(model->mesh, fields[c]);

    struct Influence {
        int curve;
        float row;
        double weight;
    };
    std::vector<int> offsets{0};
    std::vector<Influence> influences;
    const auto add = [&](int p, int c, double share) {
        const CurveField& field = fields[c];
        const CurveSide side = field.side[p];
        if (order.linked[c] || side == CurveSide::inside) influences.push_back({c, field.row[p], share});
        else if (side == CurveSide::between && !between[c].empty()) {
            const double x = between[c][p];
            if (x < 1) influences.push_back({c, 0, share * (1 - x)});
            if (x > 0) influences.push_back({c, static_cast<float>(k_last), share * x});
        } else if (side == CurveSide::none) {
            const double t = curves[c].curve().nearest(place(p)).t;
            influences.push_back({c, static_cast<float>(curves[c].row_of(t)), share});
        } else influences.push_back({c, side == CurveSide::end ? static_cast<float>(k_last) : 0.0f, share});
    };
    for (int p = 0; p < places; ++p) {
        for (int k = shares.offsets[p]; k < shares.offsets[p + 1]; ++k)
            if (shares.owners[k] < count) add(p, shares.owners[k], shares.shares[k]);
        if (options.blending == CurveBlending::gaussian && owner[p] < count) {
            // Eq 5.7, about each linked control point, from either curve into the other: σ² = |p − a|.
            double rest_share = 1;
            for (const CurveLink& link : links) {
                const EncodedCurve &child = curves[link.child], &parent = curves[link.parent];
                const double child_t = child.options().anchor == CurveEnd::start ? 0 : 1;
                const Vector3d at_child = child.curve().point(child_t), at_parent = parent.curve().point(link.at);
                const double variance = (at_child - at_parent).norm();
                const bool of_child = owner[p] == link.child;
                if (!(variance > 0) || (!of_child && owner[p] != link.parent)) continue;
                const double weight = std::exp(-(place(p) - (of_child ? at_parent : at_child)).squaredNorm() / (2 * variance));
                if (weight < 1e-4) continue;
                const double given = std::min(weight, rest_share);
                rest_share -= given;
                influences.push_back({of_child ? link.parent : link.child,
                                      static_cast<float>(of_child ? parent.row_of(link.at) : child.row_of(child_t)), given});
            }
            influences[offsets.back()].weight *= rest_share;
        }
        double pulled = 0; // by contours; what owners have is less by as much
        for (int c = 0; c < count; ++c)
            if (is_contour(c) && fields[c].side[p] == CurveSide::inside) pulled += fields[c].distance[p];
        if (pulled > 0) {
            const double kept = std::max(0.0, 1 - pulled);
            for (std::size_t i = offsets.back(); i < influences.size(); ++i) influences[i].weight *= kept;
            for (int c = 0; c < count; ++c)
                if (is_contour(c) && fields[c].side[p] == CurveSide::inside) influences.push_back({c, fields[c].row[p], fields[c].distance[p] / std::max(1.0, pulled)});
        }
        // Four slots: `between` may have made more of them.
        const auto first = influences.begin() + offsets.back();
        if (influences.end() - first > OwnerShares::k_most) {
            std::stable_sort(first, influences.end(), [](const Influence& a, const Influence& b) { return a.weight > b.weight; });
            double all = 0, kept = 0;
            for (auto i = first; i != influences.end(); ++i) all += i->weight;
            influences.resize(offsets.back() + OwnerShares::k_most);
            for (std::size_t i = offsets.back(); i < influences.size(); ++i) kept += influences[i].weight;
            for (std::size_t i = offsets.back(); i < influences.size(); ++i) influences[i].weight *= all / kept;
        }
        offsets.push_back(static_cast<int>(influences.size()));
    }

    supports.assign(count, std::vector<RowSupport>(EncodedCurve::k_rows));
    for (int p = 0; p < places; ++p)
        for (int k = offsets[p]; k < offsets[p + 1]; ++k) {
            const auto& [c, row, weight] = influences[k];
            if (weight < 0.5 || row <= 0 || row >= k_last) continue;
            const CurveFrame& frame = curves[c].frame_at(row);
            const Vector3d local = frame.axes.transpose() * (place(p) - frame.origin);
            supports[c][static_cast<int>(std::lround(row))].take_in(local[1], local[2]);
        }
    for (int c = 0; c < count; ++c) { // rows between those of vertices, from the nearest on either side
        std::vector<RowSupport>& rows = supports[c];
        const std::vector<RowSupport> found = rows;
        const auto empty = [&](int i) { return found[i].circle() <= 0; };
        for (int i = 0; i < EncodedCurve::k_rows; ++i) {
            int before = i - 1, after = i + 1;
            while (before >= 0 && empty(before)) --before;
            while (after < EncodedCurve::k_rows && empty(after)) ++after;
            for (const int near : {before, after})
                if (near >= 0 && near < EncodedCurve::k_rows)
                    for (int k = 0; k < 16; ++k) rows[i].reach[k] = std::max(rows[i].reach[k], found[near].reach[k]);
        }
    }

    if (in_slabs)
        for (const EncodedCurve& curve : curves) slabs.emplace_back(curve);
    const auto slab_place = [&](int v, const Influence& influence) {
        const double t = curves[influence.curve].curve().parameter(influence.row / k_last * curves[influence.curve].curve().length());
        return slabs[influence.curve].place(rest.row(v).transpose(), influence.row <= 0 ? 0 : influence.row >= k_last ? 1 : std::clamp(t, 1e-12, 1 - 1e-12));
    };
    singles.resize(count);
    single_places.resize(count);
    for (int v = 0; v < rest.rows(); ++v) {
        const int p = model ? model->working_of_source[v] : v;
        if (p < 0 || offsets[p] == offsets[p + 1]) {
            resting.push_back(v);
            continue;
        }
        const Influence& first = influences[offsets[p]];
        if (offsets[p + 1] - offsets[p] == 1 && first.weight >= 1 - 1e-12) {
            singles[first.curve].vertices.push_back(v);
            singles[first.curve].rows.push_back(first.row);
            if (in_slabs) single_places[first.curve].push_back(slab_place(v, first));
            continue;
        }
        blended.vertices.push_back(v);
        for (int k = offsets[p]; k < offsets[p + 1]; ++k) {
            blended.curves.push_back(influences[k].curve);
            blended.rows.push_back(influences[k].row);
            blended.weights.push_back(influences[k].weight);
            if (in_slabs) blended_places.push_back(slab_place(v, influences[k]));
        }
        blended.offsets.push_back(static_cast<int>(blended.curves.size()));
    }
    fields.clear();
    fields.shrink_to_fit();
    surface.reset();
}

} // namespace lissom
