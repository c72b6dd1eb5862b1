#include "lissom/merge/boundary_correspondence.h"

#include "lissom/mesh/errors.h"
#include "lissom/mesh/similarity.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace lissom {
namespace {

constexpr double k_snap = 0.4;  // of the shorter neighbouring gap: nearer vertices become one
constexpr int k_samples = 64;     // of a loop whose best key is sought
constexpr double k_tie = 1e-9;  // differences below this decide nothing, for they are rounding

int place_of(const std::vector<int>& loop, int vertex, const char* which) {
    const auto found = std::find(loop.begin(), loop.end(), vertex);
    if (found == loop.end())
        throw InvalidInput("key-not-on-boundary", "A key names " + std::string(which) + " vertex " + std::to_string(vertex) +
                                                      ", which is not on the boundary it belongs to. Place the key on the boundary.");
    return static_cast<int>(found - loop.begin());
}

double step_length(const Points& points, const std::vector<int>& loop, std::size_t i) {
    return (points.row(loop[(i + 1) % loop.size()]) - points.row(loop[i])).norm();
}

/// Parameter of each vertex: key k stands at k, and arc length is even between keys.
/// @param keys  places in the loop, ascending from 0
std::vector<double> parameters(const Points& points, const std::vector<int>& loop, const std::vector<int>& keys) {
    std::vector<double> at(loop.size(), 0);
    for (std::size_t k = 0; k < keys.size(); ++k) {
        const auto first = static_cast<std::size_t>(keys[k]);
        const std::size_t last = k + 1 < keys.size() ? static_cast<std::size_t>(keys[k + 1]) : loop.size();
        double length = 0;
        for (std::size_t i = first; i < last; ++i) length += step_length(points, loop, i);
        double walked = 0;
        for (std::size_t i = first; i < last; ++i) {
            // A stretch without length is divided evenly.
            at[i] = static_cast<double>(k) + (length > 0 ? walked / length : static_cast<double>(i - first) / static_cast<double>(last - first));
            walked += step_length(points, loop, i);
        }
    }
    return at;
}

/// Gap to the nearer neighbour of each parameter on a circle of the given period.
std::vector<double> gaps(const std::vector<double>& at, double period) {
    std::vector<double> gap(at.size());
    const std::size_t n = at.size();
    for (std::size_t i = 0; i < n; ++i) {
        const double next = i + 1 < n ? at[i + 1] - at[i] : period - at[i] + at[0];
        const double before = i > 0 ? at[i] - at[i - 1] : period - at[n - 1] + at[0];
        gap[i] = std::min(next, before);
    }
    return gap;
}

/// Places whose vertices become one, nearest first; keys are among them, at distance 0.
std::vector<std::pair<int, int>> snapped(const std::vector<double>& source, const std::vector<double>& target, double period) {
    struct Candidate {
        double distance;
        int source, target;
    };
    const std::vector<double> source_gap = gaps(source, period), target_gap = gaps(target, period);
    std::vector<Candidate> candidates;
    for (int j = 0; j < std::ssize(target); ++j) {
        const auto after = static_cast<int>(std::lower_bound(source.begin(), source.end(), target[j]) - source.begin());
        for (int k = after - 2; k <= after + 1; ++k) {
            const int n = static_cast<int>(source.size()), i = (k % n + n) % n;
            double distance = std::abs(source[i] - target[j]);
            distance = std::min(distance, period - distance);
            if (distance <= k_snap * std::min(source_gap[i], target_gap[j]) + k_tie) candidates.push_back({std::round(distance / k_tie) * k_tie, i, j});
        }
    }
    std::sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
        if (a.distance != b.distance) return a.distance < b.distance;
        return std::pair(a.target, a.source) < std::pair(b.target, b.source);
    });
    std::vector<char> source_used(source.size(), 0), target_used(target.size(), 0);
    std::vector<std::pair<int, int>> pairs;
    for (const Candidate& c : candidates) {
        if (source_used[c.source] || target_used[c.target]) continue;
        source_used[c.source] = target_used[c.target] = 1;
        pairs.emplace_back(c.source, c.target);
    }
    return pairs;
}

/// Where parameter p lies among the vertices: the place before it and the fraction of the way to the next.
std::pair<int, double> locate(const std::vector<double>& at, double p, double period) {
    const auto after = std::upper_bound(at.begin(), at.end(), p);
    const int i = after == at.begin() ? static_cast<int>(at.size()) - 1 : static_cast<int>(after - at.begin()) - 1;
    const double here = after == at.begin() ? at[i] - period : at[i];
    const double next = i + 1 < std::ssize(at) ? at[i + 1] : at[0] + period;
    const double there = after == at.begin() ? at[0] : next;
    return {i, there > here ? std::clamp((p - here) / (there - here), 0.0, 1.0) : 0.5};
}

} // namespace

LoopMatch match_loops(const Points& source, const std::vector<int>& source_loop, const Points& target,
                      const std::vector<int>& target_loop, std::span<const std::pair<int, int>> keys) {
    if (keys.empty()) throw InvalidInput("no-key", "The two boundaries have no key. Mark at least one pair of points that belong together.");
    const int n = static_cast<int>(source_loop.size()), m = static_cast<int>(target_loop.size());
    LoopMatch match;
    match.target = {target_loop.rbegin(), target_loop.rend()};
    std::vector<std::pair<int, int>> places; // along the source, in loop places
    for (const auto& [s, t] : keys) places.emplace_back(place_of(source_loop, s, "source"), place_of(match.target, t, "target"));
    std::sort(places.begin(), places.end());
    for (std::size_t k = 0; k < places.size(); ++k)
        for (std::size_t l = 0; l < k; ++l)
            if (places[k].first == places[l].first || places[k].second == places[l].second)
                throw InvalidInput("key-repeated", "Two keys share a vertex. Give each key places of its own.");

    const int s0 = places.front().first, t0 = places.front().second;
    std::vector<int> source_keys, target_keys;
    int ascents = 0;
    for (const auto& [s, t] : places) {
        source_keys.push_back(s - s0);
        target_keys.push_back((t - t0 + m) % m);
    }
    for (std::size_t k = 1; k + 1 < target_keys.size(); ++k) ascents += target_keys[k + 1] > target_keys[k];
    if (const int pairs = static_cast<int>(target_keys.size()) - 2; pairs > 0 && ascents < pairs) {
        if (ascents == 0)
            throw InvalidInput(k_keys_reversed, "The keys run around the two boundaries in the wrong direction: one of the models is inside out, or the keys are mirrored.");
        throw InvalidInput("keys-out-of-order", "The keys cross: they do not follow each other around both boundaries in the same order. Swap or remove one.");
    }
    for (int i = 0; i < n; ++i) match.source.push_back(source_loop[(s0 + i) % n]);
    std::rotate(match.target.begin(), match.target.begin() + t0, match.target.end());

    const double period = static_cast<double>(keys.size());
    const std::vector<double> source_at = parameters(source, match.source, source_keys);
    const std::vector<double> target_at = parameters(target, match.target, target_keys);
    std::vector<int> partner_of_source(n, -1), partner_of_target(m, -1);
    for (const auto& [s, t] : snapped(source_at, target_at, period)) {
        partner_of_source[s] = t;
        partner_of_target[t] = s;
    }
    for (const double p : source_at) match.at_target.push_back(locate(target_at, p, period));
    // Every source vertex stands at its partner's parameter from here on.
    std::vector<double> moved = source_at;
    for (int i = 0; i < n; ++i)
        if (partner_of_source[i] >= 0) {
            moved[i] = target_at[partner_of_source[i]];
            if (moved[i] - source_at[i] > period / 2) moved[i] -= period; // the other way around the first key
            if (source_at[i] - moved[i] > period / 2) moved[i] += period;
        }
    std::vector<std::pair<double, SeamPoint>> ordered;
    for (int i = 0; i < n; ++i) {
        SeamPoint point{.source = i, .target = partner_of_source[i]};
        if (point.target < 0) std::tie(point.target_edge, point.target_fraction) = locate(target_at, moved[i], period);
        ordered.emplace_back(moved[i], point);
    }
    for (int j = 0; j < m; ++j)
        if (partner_of_target[j] < 0) {
            SeamPoint point{.target = j};
            std::tie(point.source_edge, point.source_fraction) = locate(moved, target_at[j], period);
            ordered.emplace_back(target_at[j], point);
        }
    std::stable_sort(ordered.begin(), ordered.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    for (const auto& [at, point] : ordered) match.points.push_back(point);
    return match;
}

LoopMatch match_one_by_one(const std::vector<int>& source_loop, const std::vector<int>& target_loop) {
    LoopMatch match{source_loop, {target_loop.rbegin(), target_loop.rend()}, {}, {}};
    std::rotate(match.target.begin(), match.target.end() - 1, match.target.end());
    for (int i = 0; i < std::ssize(source_loop); ++i) {
        match.points.push_back({.source = i, .target = i});
        match.at_target.emplace_back(i, 0.0);
    }
    return match;
}

std::pair<int, int> best_key(const Points& source, const std::vector<int>& source_loop, const Points& target,
                             const std::vector<int>& target_loop) {
    const std::vector<int> backward(target_loop.rbegin(), target_loop.rend());
    const auto sampled = [](const Points& points, const std::vector<int>& loop, int first) {
        std::vector<int> turned(loop);
        std::rotate(turned.begin(), turned.begin() + first, turned.end());
        const std::vector<double> at = parameters(points, turned, {0});
        Points result(k_samples, 3);
        for (int k = 0; k < k_samples; ++k) {
            const auto [i, f] = locate(at, static_cast<double>(k) / k_samples, 1);
            result.row(k) = (1 - f) * points.row(turned[i]) + f * points.row(turned[(i + 1) % turned.size()]);
        }
        return result;
    };
    const Points from = sampled(source, source_loop, 0);
    int best = 0;
    double least = 0;
    const int m = static_cast<int>(backward.size());
    const int stride = std::max(1, m / 256);
    for (int j = 0; j < m; j += stride) {
        const Points to = sampled(target, backward, j);
        const double left = misfit(fit_similarity(from, to), from, to);
        if (j == 0 || left < least - 1e-6) {
            least = left;
            best = j;
        }
    }
    return {source_loop.front(), backward[best]};
}

} // namespace lissom
