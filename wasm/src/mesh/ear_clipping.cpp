#include "ear_clipping.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
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

/// Some points of the plane by squares that hold about one each.
class PointGrid {
public:
    PointGrid() = default;
    PointGrid(const std::vector<Eigen::Vector2d>& points, const std::vector<int>& some) {
        if (some.empty())
            return;
        Eigen::AlignedBox2d box;
        for (const int i : some)
            box.extend(points[i]);
        const auto count = static_cast<double>(some.size());
        const Eigen::Vector2d size = box.sizes();
        low_ = box.min();
        side_ = std::max(std::sqrt(size.x() * size.y() / count), size.maxCoeff() / count);
        if (!(side_ > 0))
            side_ = 1;
        for (int d = 0; d < 2; ++d)
            cells_[d] = 1 + static_cast<int>(size[d] / side_);
        start_.assign(static_cast<std::size_t>(cells_.x()) * cells_.y() + 1, 0);
        for (const int i : some)
            ++start_[number(cell(points[i])) + 1];
        for (std::size_t c = 1; c < start_.size(); ++c)
            start_[c] += start_[c - 1];
        items_.resize(some.size());
        std::vector<int> next(start_.begin(), start_.end() - 1);
        for (const int i : some)
            items_[next[number(cell(points[i]))]++] = i;
    }

    /// Whether `test` holds for a point in or near a box.
    template <class Test>
    [[nodiscard]] bool any(const Eigen::Vector2d& low, const Eigen::Vector2d& high, const Test& test) const {
        if (items_.empty())
            return false;
        const Eigen::Vector2i from = cell(low), to = cell(high);
        for (int y = from.y(); y <= to.y(); ++y)
            for (int k = start_[number({from.x(), y})]; k < start_[number({to.x(), y}) + 1]; ++k)
                if (test(items_[k]))
                    return true;
        return false;
    }

private:
    [[nodiscard]] Eigen::Vector2i cell(const Eigen::Vector2d& p) const {
        Eigen::Vector2i at;
        for (int d = 0; d < 2; ++d)
            at[d] = static_cast<int>(std::clamp((p[d] - low_[d]) / side_, 0.0, cells_[d] - 1.0));
        return at;
    }
    [[nodiscard]] std::size_t number(const Eigen::Vector2i& at) const {
        return static_cast<std::size_t>(at.y()) * cells_.x() + at.x();
    }

    Eigen::Vector2d low_;
    Eigen::Vector2i cells_;
    double side_ = 1;
    std::vector<int> start_, items_;
};

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
        find_blockers();
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
        return blockers_.any(a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c), [&](int j) {
            const Eigen::Vector2d& q = p_[j];
            if (gone_[j] || convex_[j] || q == a || q == b || q == c)
                return false; // a corner of the ear, or one that touches it there
            return turn(a, b, q) >= 0 && turn(b, c, q) >= 0 && turn(c, a, q) >= 0;
        });
    }

    void find_blockers() {
        std::vector<int> found;
        for_each_left([&](int i) {
            if (!convex_[i])
                found.push_back(i);
        });
        blockers_ = PointGrid(p_, found);
        left_then_ = left_;
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
        bool is_spoilt = false;
        for (const int j : {before, after}) {
            ++version_[j];
            const bool was_convex = convex_[j];
            convex_[j] = is_convex(j);
            is_spoilt = is_spoilt || (was_convex && !convex_[j]); // only after a forced cut
        }
        if (times_stuck_ <= k_patience && (is_spoilt || left_ < left_then_ / 2)) // short searches as the polygon shrinks
            find_blockers();
        offer(before);
        offer(after);
    }

    const std::vector<Eigen::Vector2d>& p_;
    int left_, first_ = 0, times_stuck_ = 0;
    std::vector<int> prev_, next_, version_;
    std::vector<bool> gone_, convex_;
    PointGrid blockers_; ///< corners that were not convex when `left_then_` were left
    int left_then_ = 0;
    std::priority_queue<Ear> ears_;
};

} // namespace

std::vector<std::array<int, 3>> clip_ears(const std::vector<Eigen::Vector2d>& corners) {
    return Clipper(corners).run();
}

} // namespace lissom
