#include "lissom/match/sharp_paths.h"

#include "lissom/mesh/point_tree.h"
#include "lissom/mesh/surface_paths.h"
#include "lissom/mesh/triangle_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <queue>
#include <tuple>

namespace lissom {

using Eigen::RowVector3d;
using Eigen::Vector3d;

namespace {

constexpr double k_infinite = std::numeric_limits<double>::infinity();
/// A piece this much longer than the way between its ends is cut: a quarter of a circle is 1.11 times, a half 1.57 times.
constexpr double k_bent = 1.3;
constexpr int k_loop_pieces = 4;
constexpr double k_shortest_piece = 3; // of L
constexpr int k_candidates = 12;       // vertices that a corner may have
constexpr double k_corner_reach = 2.5; // of L
/// Cosine of the turn from which a line has a kink (10 degrees): some vertex of the path goes there. Less than a corner, and more than most circles turn from point to point.
constexpr double k_kink = 0.985;

/// A line by its length.
class Measured {
public:
    explicit Measured(const SharpLine& line) : points_(line.points), closed_(line.closed) {
        if (closed_) {
            points_.conservativeResize(points_.rows() + 1, 3);
            points_.row(points_.rows() - 1) = line.points.row(0);
        }
        at_.push_back(0);
        for (Eigen::Index i = 1; i < points_.rows(); ++i) at_.push_back(at_.back() + (points_.row(i) - points_.row(i - 1)).norm());
    }
    [[nodiscard]] double length() const { return at_.back(); }
    [[nodiscard]] bool closed() const { return closed_; }
    [[nodiscard]] RowVector3d place(double s) const {
        if (closed_ && length() > 0) s -= length() * std::floor(s / length());
        const auto after = std::clamp<std::ptrdiff_t>(std::upper_bound(at_.begin(), at_.end(), s) - at_.begin(), 1, std::ssize(at_) - 1);
        const auto i = static_cast<std::size_t>(after);
        const double step = at_[i] - at_[i - 1], part = step > 0 ? std::clamp((s - at_[i - 1]) / step, 0.0, 1.0) : 0;
        if (part == 0) return points_.row(after - 1); // corners exactly
        if (part == 1) return points_.row(after);
        return (1 - part) * points_.row(after - 1) + part * points_.row(after);
    }
    /// Lengths of the line's own points strictly between two.
    [[nodiscard]] std::vector<double> between(double from, double to) const {
        std::vector<double> found;
        const double turn = closed_ ? length() : 0;
        for (int round = 0; round <= (closed_ ? 1 : 0); ++round)
            for (std::size_t i = 0; i + (closed_ ? 1 : 0) < at_.size(); ++i)
                if (const double s = at_[i] + round * turn; s > from && s < to) found.push_back(s);
        return found;
    }

    /// Where between two lengths the line has kinks: cosine of the turn, length; sharpest first.
    [[nodiscard]] std::vector<std::pair<double, double>> kinks(double from, double to) const {
        std::vector<std::pair<double, double>> found;
        const auto n = std::ssize(at_);
        for (int round = 0; round <= (closed_ ? 1 : 0); ++round)
            for (std::ptrdiff_t i = closed_ ? 0 : 1; i + 1 < n; ++i) {
                const double s = at_[static_cast<std::size_t>(i)] + (round ? length() : 0);
                if (s <= from || s >= to) continue;
                const RowVector3d in = points_.row(i) - points_.row(i > 0 ? i - 1 : n - 2), out = points_.row(i + 1) - points_.row(i);
                const double lengths = in.norm() * out.norm();
                if (const double cosine = lengths > 0 ? in.dot(out) / lengths : 1; cosine < k_kink) found.emplace_back(cosine, s);
            }
        std::sort(found.begin(), found.end());
        return found;
    }

private:
    Points points_;
    std::vector<double> at_;
    bool closed_;
};

/// Part of a line, to be asked how far places are from it and where along it.
class Piece {
public:
    Piece(const Measured& line, double from, double to) {
        at_ = line.between(from, to);
        at_.insert(at_.begin(), from);
        at_.push_back(to);
        mesh_.points.resize(std::ssize(at_), 3);
        for (Eigen::Index i = 0; i < mesh_.points.rows(); ++i) mesh_.points.row(i) = line.place(at_[static_cast<std::size_t>(i)]);
        mesh_.triangles.resize(mesh_.points.rows() - 1, 3);
        for (int i = 0; i < mesh_.triangles.rows(); ++i) mesh_.triangles.row(i) << i, i + 1, i + 1;
        tree_.emplace(mesh_);
    }
    Piece(const Piece&) = delete;
    Piece& operator=(const Piece&) = delete;

    struct Nearest {
        double distance = k_infinite, at = 0;
    };
    [[nodiscard]] Nearest nearest(const Vector3d& p, double reach = k_infinite) const {
        const auto found = tree_->nearest_where(p, reach, -1, [](int) { return true; });
        if (found.triangle < 0) return {};
        const auto i = static_cast<std::size_t>(found.triangle);
        return {found.distance, std::min(at_[i] + (found.point - mesh_.points.row(found.triangle).transpose()).norm(), at_[i + 1])};
    }

private:
    std::vector<double> at_;
    TriangleMesh mesh_;
    std::optional<TriangleTree> tree_;
};

/// The nearest sequence that never falls, by least squares (pool adjacent violators).
void make_rising(std::vector<double>& values) {
    std::vector<std::pair<double, int>> pools; // mean, count
    for (const double value : values) {
        pools.emplace_back(value, 1);
        while (pools.size() > 1 && pools[pools.size() - 2].first > pools.back().first) {
            const auto [mean, count] = pools.back();
            pools.pop_back();
            auto& [first, number] = pools.back();
            first = (first * number + mean * count) / (number + count);
            number += count;
        }
    }
    std::size_t i = 0;
    for (const auto& [mean, count] : pools)
        for (int k = 0; k < count; ++k) values[i++] = mean;
}

/// Lengths along a line that rise, so changed that each kink has one, the sharpest first; those between go along.
void put_on_kinks(std::vector<double>& at, const Measured& line) {
    const std::vector<double> before = at;
    std::map<std::size_t, double> fixed{{0, at.front()}, {at.size() - 1, at.back()}};
    for (const auto& [cosine, s] : line.kinks(at.front(), at.back())) {
        auto high = fixed.begin(); // the first beyond the kink
        while (high->second <= s) ++high;
        const std::size_t first = std::prev(high)->first + 1, last = high->first; // those that may go there
        std::size_t best = last;
        for (std::size_t i = first; i < last; ++i)
            if (best == last || std::abs(before[i] - s) < std::abs(before[best] - s)) best = i;
        if (best < last && std::prev(high)->second < s) fixed[best] = s;
    }
    for (auto low = fixed.begin(), high = std::next(low); high != fixed.end(); ++low, ++high) {
        const double from = before[low->first], width = before[high->first] - from;
        for (std::size_t i = low->first; i <= high->first; ++i) {
            const double part = width > 0 ? (before[i] - from) / width : static_cast<double>(i - low->first) / static_cast<double>(high->first - low->first);
            at[i] = i == low->first ? low->second : i == high->first ? high->second : low->second + part * (high->second - low->second);
        }
    }
}

Points places_on(const Points& skin, const std::vector<int>& path, const Measured& line, double from, double to) {
    const Piece piece(line, from, to);
    const auto n = path.size();
    std::vector<double> nearest(n), spread(n, 0);
    for (std::size_t i = 0; i < n; ++i) {
        nearest[i] = piece.nearest(skin.row(path[i]).transpose()).at;
        if (i > 0) spread[i] = spread[i - 1] + (skin.row(path[i]) - skin.row(path[i - 1])).norm();
    }
    const double whole = spread.back();
    nearest.front() = from;
    nearest.back() = to;
    make_rising(nearest);
    std::vector<double> at(n);
    for (std::size_t i = 0; i < n; ++i) {
        const double even = from + (to - from) * (whole > 0 ? spread[i] / whole : static_cast<double>(i) / static_cast<double>(n - 1));
        at[i] = i == 0 ? from : i + 1 == n ? to : (nearest[i] + even) / 2;
    }
    put_on_kinks(at, line);
    Points places(std::ssize(path), 3);
    for (std::size_t i = 0; i < n; ++i) places.row(static_cast<Eigen::Index>(i)) = line.place(at[i]);
    return places;
}

/// A place that a path begins, ends or is cut at.
struct Node {
    RowVector3d place;
    int vertex = -1;
    bool cut = false;   ///< not of the model: it may be dropped, and lies wherever its vertex is nearest to
    double snapped = k_infinite; ///< distance of the marker that it is
};
struct Stop {
    double at; ///< along the line
    int node;
};

class PathFinder {
public:
    PathFinder(const TriangleMesh& skin, const std::vector<SharpLine>& lines, const std::vector<Anchor>& markers, const SharpPathOptions& options)
        : skin_(skin), options_(options), L_(options.edge_length), graph_(edge_graph(skin)), taken_(static_cast<std::size_t>(skin.vertex_count()), 0), cost_(taken_.size(), k_infinite),
          before_(taken_.size(), -1) {
        for (const SharpLine& line : lines) lines_.emplace_back(line);
        for (const Anchor& marker : markers) taken_[marker.vertex] = 1;
        make_corners(lines);
        snap(markers);
        for (std::size_t k = 0; k < lines_.size(); ++k) cut(k);
        choose_vertices();
    }

    SharpPaths find() {
        struct Wanted {
            double length;
            int line;
            std::size_t stop;
        };
        std::vector<Wanted> wanted;
        for (std::size_t k = 0; k < lines_.size(); ++k) {
            if (stops_[k].size() < 2) fail(static_cast<int>(k));
            for (std::size_t i = 0; i + 1 < stops_[k].size(); ++i) wanted.push_back({stops_[k][i + 1].at - stops_[k][i].at, static_cast<int>(k), i});
        }
        std::sort(wanted.begin(), wanted.end(), [](const Wanted& a, const Wanted& b) { return std::tie(a.length, a.line, a.stop) < std::tie(b.length, b.line, b.stop); });
        std::map<std::pair<int, std::size_t>, std::vector<int>> ways;
        for (const Wanted& w : wanted) {
            std::vector<int> way = shortest(w.line, stops_[w.line][w.stop], stops_[w.line][w.stop + 1]);
            if (way.empty()) {
                fail(w.line);
                continue;
            }
            for (std::size_t i = 0; i + 1 < way.size(); ++i) used_.insert({std::minmax(way[i], way[i + 1]), 1});
            for (const int v : way) taken_[v] = 1;
            ways[{w.line, w.stop}] = std::move(way);
        }
        for (auto& [where, way] : ways) {
            const auto next = ways.find({where.first, where.second + 1});
            if (next != ways.end()) straighten(where.first, stops_[where.first][where.second + 1], way, next->second);
        }
        for (const auto& [where, way] : ways) {
            const Stop &first = stops_[where.first][where.second], &last = stops_[where.first][where.second + 1];
            SharpPath& path = found_.paths.emplace_back();
            path.line = where.first;
            path.from = first.at;
            path.to = last.at;
            path.curve.vertices = way;
            path.curve.layer = options_.layer;
            path.places = places_on(skin_.points, way, lines_[where.first], first.at, last.at);
        }
        std::sort(found_.failed.begin(), found_.failed.end());
        found_.failed.erase(std::unique(found_.failed.begin(), found_.failed.end()), found_.failed.end());
        return std::move(found_);
    }

private:
    void fail(int line) { found_.failed.push_back(line); }

    void make_corners(const std::vector<SharpLine>& lines) {
        std::map<std::array<double, 3>, int> corners;
        stops_.resize(lines.size());
        for (std::size_t k = 0; k < lines.size(); ++k) {
            if (lines[k].closed) continue;
            for (const bool end : {false, true}) {
                const RowVector3d p = lines[k].points.row(end ? lines[k].points.rows() - 1 : 0);
                const auto [at, fresh] = corners.try_emplace({p.x(), p.y(), p.z()}, static_cast<int>(nodes_.size()));
                if (fresh) nodes_.push_back({p});
                stops_[k].push_back({end ? lines_[k].length() : 0, at->second});
            }
        }
    }

    /// Markers at corners, then markers on lines, nearest first.
    void snap(const std::vector<Anchor>& markers) {
        const double reach = options_.snap * L_;
        std::vector<std::tuple<double, std::size_t, int>> at_corners; // distance, marker, node
        for (std::size_t m = 0; m < markers.size(); ++m)
            for (std::size_t c = 0; c < nodes_.size(); ++c)
                if (const double d = (nodes_[c].place.transpose() - markers[m].place).norm(); d <= reach) at_corners.emplace_back(d, m, static_cast<int>(c));
        std::sort(at_corners.begin(), at_corners.end());
        std::vector<char> done(markers.size(), 0);
        for (const auto& [d, m, c] : at_corners) {
            if (done[m] || nodes_[c].vertex >= 0) continue;
            done[m] = 1;
            nodes_[c].vertex = markers[m].vertex;
            found_.moved_markers.push_back({markers[m].vertex, nodes_[c].place.transpose()});
        }
        std::vector<std::unique_ptr<Piece>> whole;
        for (const Measured& line : lines_) whole.push_back(std::make_unique<Piece>(line, 0, line.length()));
        for (std::size_t m = 0; m < markers.size(); ++m) {
            if (done[m]) continue;
            Piece::Nearest best;
            std::size_t line = 0;
            for (std::size_t k = 0; k < whole.size(); ++k)
                if (const auto near = whole[k]->nearest(markers[m].place, reach); near.distance < best.distance) {
                    best = near;
                    line = k;
                }
            if (!(best.distance <= reach)) continue;
            // A second marker at a corner that has one already stays what it is: none of its lines goes through it.
            if (!lines_[line].closed() && (best.at <= 0 || best.at >= lines_[line].length())) continue;
            const RowVector3d place = lines_[line].place(best.at);
            stops_[line].push_back({best.at, static_cast<int>(nodes_.size())});
            nodes_.push_back({place, markers[m].vertex});
            found_.moved_markers.push_back({markers[m].vertex, place.transpose()});
        }
        for (auto& stops : stops_) std::sort(stops.begin(), stops.end(), [](const Stop& a, const Stop& b) { return std::tie(a.at, a.node) < std::tie(b.at, b.node); });
    }

    void cut(std::size_t k) {
        const Measured& line = lines_[k];
        std::vector<Stop>& stops = stops_[k];
        if (!(line.length() > 0)) {
            stops.clear();
            return;
        }
        if (line.closed()) { // once around: the first stop is the last, too
            if (stops.empty()) stops.push_back({0, add_cut(line, 0)});
            stops.push_back({stops.front().at + line.length(), stops.front().node});
        }
        std::vector<Stop> all;
        for (std::size_t i = 0; i + 1 < stops.size(); ++i) {
            all.push_back(stops[i]);
            const double from = stops[i].at, to = stops[i + 1].at;
            const double quarter = line.length() / k_loop_pieces;
            const int pieces = line.closed() ? std::max(1, static_cast<int>(std::ceil((to - from) / quarter - 1e-9))) : 1;
            for (int p = 0; p < pieces; ++p) {
                const double a = from + (to - from) * p / pieces, b = from + (to - from) * (p + 1) / pieces;
                if (p > 0) all.push_back({a, add_cut(line, a)});
                halve(line, a, b, all);
            }
        }
        all.push_back(stops.back());
        stops = std::move(all);
    }

    void halve(const Measured& line, double from, double to, std::vector<Stop>& all) {
        const double chord = (line.place(to) - line.place(from)).norm();
        if (to - from <= k_bent * chord || to - from < 2 * k_shortest_piece * L_) return;
        const double middle = (from + to) / 2;
        halve(line, from, middle, all);
        all.push_back({middle, add_cut(line, middle)});
        halve(line, middle, to, all);
    }

    int add_cut(const Measured& line, double at) {
        nodes_.push_back({line.place(at), -1, true});
        return static_cast<int>(nodes_.size()) - 1;
    }

    /// Nearest pairs first; corners of the model before cuts.
    void choose_vertices() {
        const PointTree tree(skin_.points);
        std::vector<std::pair<int, double>> near;
        for (const Node& node : nodes_)
            if (node.vertex >= 0) taken_[node.vertex] = 1;
        for (const bool cuts : {false, true}) {
            std::vector<std::tuple<double, int, int>> pairs; // squared distance, node, vertex
            for (std::size_t c = 0; c < nodes_.size(); ++c) {
                if (nodes_[c].vertex >= 0 || nodes_[c].cut != cuts) continue;
                tree.nearest(nodes_[c].place.transpose(), k_candidates, near);
                for (const auto& [v, squared] : near)
                    if (!taken_[v] && squared <= k_corner_reach * k_corner_reach * L_ * L_ && graph_.offsets[v + 1] > graph_.offsets[v]) pairs.emplace_back(squared, static_cast<int>(c), v);
            }
            std::sort(pairs.begin(), pairs.end());
            for (const auto& [squared, c, v] : pairs)
                if (nodes_[c].vertex < 0 && !taken_[v]) {
                    nodes_[c].vertex = v;
                    taken_[v] = 1;
                }
        }
        for (std::size_t k = 0; k < lines_.size(); ++k) { // cuts without a vertex are none; the others lie where their vertices are nearest
            std::vector<Stop>& stops = stops_[k];
            std::erase_if(stops, [&](const Stop& stop) { return nodes_[stop.node].cut && nodes_[stop.node].vertex < 0; });
            for (std::size_t i = 1; i + 1 < stops.size(); ++i)
                if (nodes_[stops[i].node].cut) put_nearest(k, stops[i], stops[i - 1].at, stops[i + 1].at);
        }
    }

    void put_nearest(std::size_t line, Stop& stop, double from, double to) {
        const double margin = 0.25 * std::min(stop.at - from, to - stop.at);
        const Piece around(lines_[line], from + margin, to - margin);
        stop.at = around.nearest(skin_.points.row(nodes_[stop.node].vertex).transpose()).at;
    }

    /// Dijkstra 1959, in the strip around the piece; ties fall to the smaller vertex.
    std::vector<int> shortest(int line, const Stop& from, const Stop& to) {
        const int start = nodes_[from.node].vertex, goal = nodes_[to.node].vertex;
        if (start < 0 || goal < 0 || start == goal) return {};
        const Piece piece(lines_[line], from.at, to.at);
        const double reach = options_.reach * L_;
        std::map<int, double> off; // squared distance in L²; infinity outside the strip
        const auto squared_off = [&](int v) {
            const auto [at, fresh] = off.try_emplace(v, k_infinite);
            if (fresh) {
                const double d = piece.nearest(skin_.points.row(v).transpose(), reach).distance;
                at->second = d * d / (L_ * L_);
            }
            return at->second;
        };
        std::vector<int> touched{start};
        std::priority_queue<std::pair<double, int>, std::vector<std::pair<double, int>>, std::greater<>> open;
        cost_[start] = 0;
        open.emplace(0, start);
        while (!open.empty()) {
            const auto [c, v] = open.top();
            open.pop();
            if (v == goal) break;
            if (c > cost_[v]) continue;
            for (int k = graph_.offsets[v]; k < graph_.offsets[v + 1]; ++k) {
                const int w = graph_.ends[k];
                if ((taken_[w] && w != goal) || squared_off(w) == k_infinite || used_.contains(std::minmax(v, w))) continue;
                const double along = c + graph_.lengths[k] * (1 + options_.stray * (std::min(squared_off(v), 1e6) + squared_off(w)) / 2);
                if (along < cost_[w] || (along == cost_[w] && v < before_[w])) {
                    if (cost_[w] == k_infinite) touched.push_back(w);
                    cost_[w] = along;
                    before_[w] = v;
                    open.emplace(along, w);
                }
            }
        }
        std::vector<int> way;
        if (cost_[goal] < k_infinite)
            for (int v = goal; v >= 0; v = before_[v]) way.push_back(v);
        std::reverse(way.begin(), way.end());
        for (const int v : touched) {
            cost_[v] = k_infinite;
            before_[v] = -1;
        }
        skip(way);
        return way;
    }

    [[nodiscard]] bool joined(int a, int b) const {
        const auto begin = graph_.ends.begin() + graph_.offsets[a], end = graph_.ends.begin() + graph_.offsets[a + 1];
        return std::binary_search(begin, end, b);
    }

    /// Three vertices of one straight line must not be a triangle: where the two outer ones are joined, the middle one is left out.
    void skip(std::vector<int>& way) const {
        for (std::size_t i = 1; i + 1 < way.size();)
            if (joined(way[i - 1], way[i + 1]) && !used_.contains(std::minmax(way[i - 1], way[i + 1]))) {
                way.erase(way.begin() + static_cast<std::ptrdiff_t>(i));
                if (i > 1) --i;
            } else ++i;
    }

    /// The same across a cut, which then moves on by one vertex.
    void straighten(int line, Stop& stop, std::vector<int>& way, std::vector<int>& next) {
        if (!nodes_[stop.node].cut || next.size() < 3 || way.size() < 2) return;
        const int before = way[way.size() - 2], after = next[1];
        if (!joined(before, after) || used_.contains(std::minmax(before, after))) return;
        const auto& stops = stops_[line];
        const auto i = static_cast<std::size_t>(&stop - stops.data());
        nodes_[stop.node].vertex = after;
        way.back() = after;
        next.erase(next.begin());
        put_nearest(static_cast<std::size_t>(line), stop, stops[i - 1].at, stops[i + 1].at);
    }

    const TriangleMesh& skin_;
    SharpPathOptions options_;
    double L_;
    WeightedGraph graph_;
    std::vector<Measured> lines_;
    std::vector<Node> nodes_;
    std::vector<std::vector<Stop>> stops_; ///< of each line, along it
    std::vector<char> taken_;
    std::map<std::pair<int, int>, int> used_;
    std::vector<double> cost_;
    std::vector<int> before_;
    SharpPaths found_;
};

} // namespace

std::vector<SharpLine> sharp_lines(const Points& points, const std::vector<EdgeCurve>& curves) {
    std::vector<SharpLine> lines;
    for (const EdgeCurve& curve : curves) {
        SharpLine line{Points(std::ssize(curve.vertices), 3), curve.closed};
        for (std::size_t i = 0; i < curve.vertices.size(); ++i) line.points.row(static_cast<Eigen::Index>(i)) = points.row(curve.vertices[i]);
        lines.push_back(std::move(line));
    }
    return lines;
}

SharpPaths find_sharp_paths(const TriangleMesh& skin, const std::vector<SharpLine>& lines, const std::vector<Anchor>& markers, const SharpPathOptions& options) {
    if (lines.empty()) return {};
    return PathFinder(skin, lines, markers, options).find();
}

Points places_along(const Points& skin, const std::vector<int>& path, const SharpLine& line, double from, double to) { return places_on(skin, path, Measured(line), from, to); }

EdgeCurves SharpPaths::locks(int vertices, std::span<const SharpPaths> of_models, const std::vector<int>& fixed, EdgeCurves::Along along) {
    std::vector<EdgeCurve> curves;
    for (const SharpPaths& model : of_models)
        for (const SharpPath& path : model.paths) curves.push_back(path.curve);
    return EdgeCurves(vertices, std::move(curves), fixed, along);
}

std::vector<Anchor> anchors_of(const std::vector<SharpPath>& paths) {
    std::map<int, Vector3d> places;
    for (const SharpPath& path : paths)
        for (std::size_t i = 0; i < path.curve.vertices.size(); ++i) places.try_emplace(path.curve.vertices[i], path.places.row(static_cast<Eigen::Index>(i)).transpose());
    std::vector<Anchor> anchors;
    for (const auto& [v, place] : places) anchors.push_back({v, place});
    return anchors;
}

} // namespace lissom
