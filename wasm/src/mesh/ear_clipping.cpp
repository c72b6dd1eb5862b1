#include "ear_clipping.h"

#include <algorithm>
#include <queue>

namespace lissom {

namespace {

/// A corner this close to straight (sine of its turn) is no ear: its triangle would have no area.
constexpr double k_straight = 1e-10;

/// An outline that leaves no ear this often crosses itself everywhere: it has no inside to keep clear of.
constexpr int k_patience = 64;

double turn(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
    return (b.x() - a.x()) * (c.y() - b.y()) - (b.y() - a.y()) * (c.x() - b.x());
}

class Clipper {
public:
    explicit Clipper(const std::vector<Eigen::Vector2d>& corners)
        : p_(corners), left_(static_cast<int>(corners.size())), prev_(left_), next_(left_), version_(left_, 0),
          gone_(left_, false), convex_(left_) {
        for (int i = 0; i < left_; ++i) {
            prev_[i] = (i + left_ - 1) % left_;
            next_[i] = (i + 1) % left_;
        }
        for (int i = 0; i < left_; ++i)
            convex_[i] = is_convex(i);
        for (int i = 0; i < left_; ++i)
            if (!convex_[i])
                blockers_.push_back(i);
        std::sort(blockers_.begin(), blockers_.end(), [&](int i, int j) { return p_[i].x() < p_[j].x(); });
        for (int i = 0; i < left_; ++i)
            offer(i);
    }

    std::vector<std::array<int, 3>> run() {
        std::vector<std::array<int, 3>> triangles;
        while (left_ > 2) {
            const int i = best_ear();
            triangles.push_back({prev_[i], i, next_[i]});
            cut(i);
        }
        return triangles;
    }

private:
    struct Ear {
        bool hollow; ///< not convex: taken only when all else fails
        double cut;
        int corner, version;
        bool operator<(const Ear& other) const { // the queue's top is its largest: shortest cut, then first corner
            if (hollow != other.hollow)
                return hollow;
            return cut != other.cut ? cut > other.cut : corner > other.corner;
        }
    };

    [[nodiscard]] bool is_convex(int i) const {
        const Eigen::Vector2d &a = p_[prev_[i]], &b = p_[i], &c = p_[next_[i]];
        return turn(a, b, c) > k_straight * (b - a).norm() * (c - b).norm();
    }

    /// Only corners that are not convex can lie in the way (if any corner does, one of these does).
    [[nodiscard]] bool is_blocked(int i) const {
        const Eigen::Vector2d &a = p_[prev_[i]], &b = p_[i], &c = p_[next_[i]];
        const double low = std::min({a.x(), b.x(), c.x()}), high = std::max({a.x(), b.x(), c.x()});
        auto at = std::lower_bound(blockers_.begin(), blockers_.end(), low,
                                   [&](int j, double x) { return p_[j].x() < x; });
        for (; at != blockers_.end() && p_[*at].x() <= high; ++at) {
            const Eigen::Vector2d& q = p_[*at];
            if (gone_[*at] || convex_[*at] || q == a || q == b || q == c)
                continue; // a corner of the ear, or one that touches it there
            if (turn(a, b, q) >= 0 && turn(b, c, q) >= 0 && turn(c, a, q) >= 0)
                return true;
        }
        return false;
    }

    [[nodiscard]] double cut_length(int i) const { return (p_[prev_[i]] - p_[next_[i]]).squaredNorm(); }

    void offer(int i) {
        if (times_stuck_ > k_patience || (convex_[i] && !is_blocked(i)))
            ears_.push({!convex_[i], cut_length(i), i, version_[i]});
    }

    int best_ear() {
        for (;;) {
            while (!ears_.empty()) {
                const Ear ear = ears_.top();
                ears_.pop();
                if (!gone_[ear.corner] && version_[ear.corner] == ear.version)
                    return ear.corner;
            }
            // What is left crosses itself or has no area: cut a corner although something is in the way, so that
            // the work ends with every corner used.
            if (++times_stuck_ <= k_patience)
                return least_bad();
            for_each_left([&](int i) { offer(i); });
        }
    }

    int least_bad() {
        Ear best{true, 0, -1, 0};
        for_each_left([&](int i) {
            const Ear ear{!convex_[i], cut_length(i), i, 0};
            if (best.corner < 0 || best < ear)
                best = ear;
        });
        return best.corner;
    }

    template <class Visit>
    void for_each_left(Visit visit) {
        while (gone_[first_])
            ++first_;
        for (int i = first_, count = 0; count < left_; i = next_[i], ++count)
            visit(i);
    }

    void cut(int i) {
        const int before = prev_[i], after = next_[i];
        next_[before] = after;
        prev_[after] = before;
        gone_[i] = true;
        --left_;
        for (const int j : {before, after}) {
            ++version_[j];
            const bool was_convex = convex_[j];
            convex_[j] = is_convex(j);
            if (was_convex && !convex_[j]) // can only happen after a forced cut
                blockers_.insert(std::lower_bound(blockers_.begin(), blockers_.end(), p_[j].x(),
                                                  [&](int b, double x) { return p_[b].x() < x; }),
                                 j);
        }
        if (left_ < static_cast<int>(blockers_.size()) / 2) // keep the search short as the polygon shrinks
            std::erase_if(blockers_, [&](int b) { return gone_[b] || convex_[b]; });
        offer(before);
        offer(after);
    }

    const std::vector<Eigen::Vector2d>& p_;
    int left_, first_ = 0, times_stuck_ = 0;
    std::vector<int> prev_, next_, version_;
    std::vector<bool> gone_, convex_;
    std::vector<int> blockers_; ///< ascending x; may still hold corners that have since become harmless
    std::priority_queue<Ear> ears_;
};

} // namespace

std::vector<std::array<int, 3>> clip_ears(const std::vector<Eigen::Vector2d>& corners) {
    return Clipper(corners).run();
}

} // namespace lissom
