// Whose each vertex is, and how owners share it.

#include "pose_state.h"

#include <algorithm>
#include <array>
#include <limits>

namespace lissom {

using Eigen::Vector3d;

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

} // namespace lissom
