// From shares to what a pose reads: rows and weights of each vertex.

#include "pose_state.h"

#include <algorithm>
#include <cmath>

namespace lissom {

using Eigen::Vector3d;

namespace {

/// Of the influences from `first` on the largest, as many as a vertex takes; they have the weight of all.
void keep_largest(std::vector<Influence>& all, int first) {
    const auto from = all.begin() + first;
    if (all.end() - from <= OwnerShares::k_most) return;
    std::stable_sort(from, all.end(), [](const Influence& a, const Influence& b) { return a.weight > b.weight; });
    double sum = 0, kept = 0;
    for (auto i = from; i != all.end(); ++i) {
        sum += i->weight;
        if (i - from < OwnerShares::k_most) kept += i->weight;
    }
    all.resize(static_cast<std::size_t>(first) + OwnerShares::k_most);
    for (auto i = all.begin() + first; i != all.end(); ++i) i->weight *= sum / kept;
}

} // namespace

void CurveSession::State::encode(const OwnerShares& shares, std::span<const int> owner) {
    const Influences influences = influences_of(shares, owner);
    find_supports(influences);
    lay_out(influences);
    fields.clear();
    fields.shrink_to_fit();
    surface.reset();
}

Influences CurveSession::State::influences_of(const OwnerShares& shares, std::span<const int> owner) const {
    const int count = static_cast<int>(specs.size()), places = place_count();
    std::vector<std::vector<double>> between(count);
    bool pulls = false;
    for (int c = 0; c < count; ++c) {
        pulls = pulls || is_contour(c);
        if (model && !order.linked[c] && !is_contour(c)) between[c] = between_shares(model->mesh, fields[c]);
    }
    Influences found;
    found.offsets.reserve(static_cast<std::size_t>(places) + 1);
    found.all.reserve(shares.owners.size());
    const auto add = [&](int p, int c, double share) {
        const CurveField& field = fields[c];
        const CurveSide side = field.side[p];
        if (order.linked[c] || side == CurveSide::inside) found.all.push_back({c, field.row[p], share});
        else if (side == CurveSide::between && !between[c].empty()) {
            const double x = between[c][p];
            if (x < 1) found.all.push_back({c, 0, share * (1 - x)});
            if (x > 0) found.all.push_back({c, static_cast<float>(k_last), share * x});
        } else if (side == CurveSide::none) {
            const double t = curves[c].curve().nearest(place(p)).t;
            found.all.push_back({c, static_cast<float>(curves[c].row_of(t)), share});
        } else found.all.push_back({c, side == CurveSide::end ? static_cast<float>(k_last) : 0.0f, share});
    };
    for (int p = 0; p < places; ++p) {
        for (int k = shares.offsets[p]; k < shares.offsets[p + 1]; ++k)
            if (shares.owners[k] < count) add(p, shares.owners[k], shares.shares[k]);
        if (options.blending == CurveBlending::gaussian && owner[p] < count) add_gaussian(found, p, owner[p]);
        if (pulls) add_contours(found, p);
        keep_largest(found.all, found.offsets.back()); // `between` may have made more of them
        found.offsets.push_back(static_cast<int>(found.all.size()));
    }
    return found;
}

void CurveSession::State::add_gaussian(Influences& found, int p, int owner) const {
    // Eq 5.7, about each linked control point, from either curve into the other: σ² = |p − a|.
    double rest_share = 1;
    for (const CurveLink& link : links) {
        const EncodedCurve &child = curves[link.child], &parent = curves[link.parent];
        const double child_t = child.options().anchor == CurveEnd::start ? 0 : 1;
        const Vector3d at_child = child.curve().point(child_t), at_parent = parent.curve().point(link.at);
        const double variance = (at_child - at_parent).norm();
        const bool of_child = owner == link.child;
        if (!(variance > 0) || (!of_child && owner != link.parent)) continue;
        const double weight = std::exp(-(place(p) - (of_child ? at_parent : at_child)).squaredNorm() / (2 * variance));
        if (weight < 1e-4) continue;
        const double given = std::min(weight, rest_share);
        rest_share -= given;
        found.all.push_back({of_child ? link.parent : link.child, static_cast<float>(of_child ? parent.row_of(link.at) : child.row_of(child_t)), given});
    }
    found.all[found.offsets.back()].weight *= rest_share;
}

void CurveSession::State::add_contours(Influences& found, int p) const {
    const int count = static_cast<int>(specs.size());
    double pulled = 0;
    for (int c = 0; c < count; ++c)
        if (is_contour(c) && fields[c].side[p] == CurveSide::inside) pulled += fields[c].distance[p];
    if (!(pulled > 0)) return;
    const double kept = std::max(0.0, 1 - pulled);
    for (std::size_t i = found.offsets.back(); i < found.all.size(); ++i) found.all[i].weight *= kept;
    for (int c = 0; c < count; ++c)
        if (is_contour(c) && fields[c].side[p] == CurveSide::inside) found.all.push_back({c, fields[c].row[p], fields[c].distance[p] / std::max(1.0, pulled)});
}

void CurveSession::State::find_supports(const Influences& influences) {
    const int count = static_cast<int>(specs.size());
    supports.assign(count, std::vector<RowSupport>(EncodedCurve::k_rows));
    for (int p = 0; p < place_count(); ++p)
        for (const auto& [c, row, weight] : influences[p]) {
            if (weight < 0.5 || row <= 0 || row >= k_last) continue;
            const CurveFrame& frame = curves[c].frame_at(row);
            const Vector3d local = frame.axes.transpose() * (place(p) - frame.origin);
            supports[c][static_cast<int>(row + 0.5f)].take_in(local[1], local[2]);
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
}

void CurveSession::State::lay_out(const Influences& influences) {
    const bool in_slabs = options.encoding == CurveEncoding::slabs;
    if (in_slabs)
        for (const EncodedCurve& curve : curves) slabs.emplace_back(curve);
    const auto slab_place = [&](int v, const Influence& influence) {
        const double t = curves[influence.curve].curve().parameter(influence.row / k_last * curves[influence.curve].curve().length());
        return slabs[influence.curve].place(rest.row(v).transpose(), influence.row <= 0 ? 0 : influence.row >= k_last ? 1 : std::clamp(t, 1e-12, 1 - 1e-12));
    };
    singles.resize(specs.size());
    single_places.resize(specs.size());
    for (int v = 0; v < rest.rows(); ++v) {
        const int p = model ? model->working_of_source[v] : v;
        const std::span<const Influence> here = p < 0 ? std::span<const Influence>() : influences[p];
        if (here.empty()) {
            resting.push_back(v);
            continue;
        }
        // What a shader cannot tell from 1 is 1: it goes by the same rule.
        const auto whole = std::find_if(here.begin(), here.end(), [](const Influence& i) { return static_cast<float>(i.weight) == 1; });
        if (whole != here.end()) {
            singles[whole->curve].vertices.push_back(v);
            singles[whole->curve].rows.push_back(whole->row);
            if (in_slabs) single_places[whole->curve].push_back(slab_place(v, *whole));
            continue;
        }
        blended.vertices.push_back(v);
        for (const Influence& influence : here) {
            blended.curves.push_back(influence.curve);
            blended.rows.push_back(influence.row);
            blended.weights.push_back(influence.weight);
            if (in_slabs) blended_places.push_back(slab_place(v, influence));
        }
        blended.offsets.push_back(static_cast<int>(blended.curves.size()));
    }
}

} // namespace lissom
