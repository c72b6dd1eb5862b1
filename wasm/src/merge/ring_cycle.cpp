#include "lissom/merge/ring_cycle.h"

#include <algorithm>
#include <limits>
#include <queue>
#include <utility>

namespace lissom {
namespace {

constexpr double k_far = std::numeric_limits<double>::infinity();

class Search {
public:
    Search(const WeightedGraph& graph, const std::vector<int>& left, const std::vector<int>& right)
        : graph_(graph), left_(left), right_(right), distance_(static_cast<std::size_t>(graph.size()), k_far),
          before_(static_cast<std::size_t>(graph.size()), -1), allowed_(static_cast<std::size_t>(graph.size()), 0),
          blocked_(static_cast<std::size_t>(graph.size()), 0) {
        best_.cost = k_far;
    }

    RingCycle halving() {
        std::vector<int> all;
        for (int v = 0; v < graph_.size(); ++v) all.push_back(v);
        between(0, static_cast<int>(left_.size()) - 1, all);
        return std::move(best_);
    }

    RingCycle one_by_one() {
        std::vector<int> all;
        for (int v = 0; v < graph_.size(); ++v) all.push_back(v);
        for (int k = 0; k < std::ssize(left_); ++k) search(k, all);
        return std::move(best_);
    }

private:
    /// The best ways from the slit's vertices lo … hi, which stay in `region`.
    void between(int lo, int hi, const std::vector<int>& region) {
        if (lo > hi) return;
        const int middle = (lo + hi) / 2;
        const std::vector<int> path = search(middle, region);
        if (lo < middle) between(lo, middle - 1, path.empty() ? region : side(lo, middle - 1, path, region));
        if (middle < hi) between(middle + 1, hi, path.empty() ? region : side(middle + 1, hi, path, region));
    }

    /// What of the region lies on the side of the slit's vertices lo … hi, the path itself included. Pockets that only
    /// the path touches are left out: a cheapest way has no reason to enter them.
    std::vector<int> side(int lo, int hi, const std::vector<int>& path, const std::vector<int>& region) {
        ++stamp_;
        for (const int v : region) allowed_[v] = stamp_;
        for (const int v : path) blocked_[v] = stamp_;
        std::vector<int> result, front;
        const auto reach = [&](int v) {
            if (allowed_[v] != stamp_ || blocked_[v] == stamp_) return;
            allowed_[v] = 0;
            result.push_back(v);
            front.push_back(v);
        };
        for (int k = lo; k <= hi; ++k) {
            reach(left_[k]);
            reach(right_[k]);
        }
        while (!front.empty()) {
            const int v = front.back();
            front.pop_back();
            for (int e = graph_.offsets[v]; e < graph_.offsets[v + 1]; ++e) reach(graph_.ends[e]);
        }
        result.insert(result.end(), path.begin(), path.end());
        return result;
    }

    std::vector<int> search(int k, const std::vector<int>& region) {
        ++best_.searches;
        ++stamp_;
        for (const int v : region) {
            allowed_[v] = stamp_;
            distance_[v] = k_far;
            before_[v] = -1;
        }
        const int from = left_[k], to = right_[k];
        if (allowed_[from] != stamp_ || allowed_[to] != stamp_) return {};
        std::priority_queue<std::pair<double, int>, std::vector<std::pair<double, int>>, std::greater<>> open;
        distance_[from] = 0;
        open.emplace(0.0, from);
        while (!open.empty()) {
            const auto [distance, v] = open.top();
            open.pop();
            if (distance > distance_[v]) continue;
            if (v == to) break;
            for (int e = graph_.offsets[v]; e < graph_.offsets[v + 1]; ++e) {
                const int w = graph_.ends[e];
                if (allowed_[w] != stamp_) continue;
                const double there = distance + graph_.lengths[e];
                if (there < distance_[w]) {
                    distance_[w] = there;
                    before_[w] = v;
                    open.emplace(there, w);
                }
            }
        }
        if (!(distance_[to] < k_far)) return {};
        std::vector<int> path;
        for (int v = to; v >= 0; v = before_[v]) path.push_back(v);
        std::reverse(path.begin(), path.end());
        if (distance_[to] < best_.cost) {
            best_.cost = distance_[to];
            best_.path = path;
        }
        return path;
    }

    const WeightedGraph& graph_;
    const std::vector<int>&left_, &right_;
    std::vector<double> distance_;
    std::vector<int> before_, allowed_, blocked_;
    int stamp_ = 0;
    RingCycle best_;
};

} // namespace

RingCycle cheapest_cycle(const WeightedGraph& graph, const std::vector<int>& left, const std::vector<int>& right) {
    return Search(graph, left, right).halving();
}

RingCycle cheapest_cycle_by_all_searches(const WeightedGraph& graph, const std::vector<int>& left, const std::vector<int>& right) {
    return Search(graph, left, right).one_by_one();
}

} // namespace lissom
