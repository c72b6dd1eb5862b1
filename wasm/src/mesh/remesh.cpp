#include "lissom/mesh/remesh.h"

#include "lissom/mesh/edge_lengths.h"
#include "lissom/mesh/edge_surgery.h"
#include "lissom/mesh/errors.h"
#include "lissom/mesh/half_edges.h"
#include "lissom/mesh/operators.h"
#include "lissom/mesh/topology.h"
#include "lissom/mesh/triangle_tree.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <string>
#include <tuple>

namespace lissom {

using Eigen::Vector3d;
using Pair = std::pair<int, int>;

namespace {

constexpr double k_long = 4.0 / 3, k_short = 4.0 / 5;
constexpr double k_infinite = std::numeric_limits<double>::infinity();
/// Cosine between a triangle's normals before and after a collapse or a move, below which it counts as turned over; and between neighbours that lie on one another.
constexpr double k_turned = 0.35, k_folded = -0.2;
/// Between each new triangle of a swap and the two old ones together.
constexpr double k_swap_turn = 0.82;
constexpr double k_better = 1e-6;
constexpr double k_evening = 0.6; // of the way to the mean of the ring
constexpr double k_same_side = 0.2; // cosine of a vertex's normal and that of the surface
constexpr int k_by_angle = 3;       // last rounds that swap by angles
constexpr double k_border_turn = 0.5; // cosine of 60 degrees
/// Cosine of the turn (10 degrees) from which a curve has a kink that one of its vertices goes to.
constexpr double k_kink = 0.985;
constexpr int k_operations = 4;

double facing_cosine(const Vector3d& p, const Vector3d& a, const Vector3d& b) {
    const Vector3d u = a - p, v = b - p;
    const double lengths = u.norm() * v.norm();
    return lengths > 0 ? u.dot(v) / lengths : -1;
}

/// A curve of the given mesh to slide along.
struct Rail {
    TriangleMesh mesh;
    std::unique_ptr<TriangleTree> tree;
    std::vector<std::pair<double, Vector3d>> kinks; ///< cosine of the turn and place, sharpest first

    Rail(const TriangleMesh& of, const EdgeCurve& curve) : mesh{Points(std::ssize(curve.vertices), 3), {}} {
        const int n = static_cast<int>(curve.vertices.size());
        for (int i = 0; i < n; ++i) mesh.points.row(i) = of.points.row(curve.vertices[static_cast<std::size_t>(i)]);
        mesh.triangles.resize(curve.closed ? n : n - 1, 3);
        for (int i = 0; i < mesh.triangles.rows(); ++i) mesh.triangles.row(i) << i, (i + 1) % n, (i + 1) % n;
        const auto at = [&](int i) -> Vector3d { return mesh.points.row((i + n) % n); };
        for (int i = curve.closed ? 0 : 1; i < n - (curve.closed ? 0 : 1); ++i)
            if (const double turn = -facing_cosine(at(i), at(i - 1), at(i + 1)); turn < k_kink) kinks.emplace_back(turn, at(i));
        std::stable_sort(kinks.begin(), kinks.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    }
    [[nodiscard]] Vector3d nearest(const Vector3d& p) {
        if (!tree) tree = std::make_unique<TriangleTree>(mesh); // the mesh is where it stays by now
        return tree->nearest(p).point;
    }
};

} // namespace

struct Remesher::State {
    TriangleMesh given;
    RemeshOptions options;
    Points given_normals;
    TriangleTree tree;
    std::vector<double> given_lengths;
    int of_given_curves = 0;
    std::vector<int> fixed_at; ///< the caller's

    EdgeSurgery surgery;
    EdgeCurves curves{0};
    std::vector<Rail> rails;
    std::vector<Vector3d> points;
    std::vector<double> lengths; ///< wanted at each vertex
    std::vector<int> hints;      ///< triangle of the given surface found last
    int slice = 0;
    bool full = false;

    State(const TriangleMesh& mesh, const std::vector<EdgeCurve>& marked, const std::vector<int>& fixed, const RemeshOptions& o)
        : given(mesh), options(o), tree(given), fixed_at(fixed), surgery(mesh.triangles, mesh.vertex_count()) {
        const double area = triangle_areas(mesh).sum();
        if (!(area > 0)) throw InvalidInput("flat-model", "The surface has no area to put triangles on. Choose another model.");
        if (!(options.edge_length > 0)) options.edge_length = mean_edge_length(mesh);
        const double L = options.edge_length;
        if (options.most_vertices <= 0) options.most_vertices = static_cast<int>(std::min(8 * area / (0.866 * L * L) + 1000.0, 1e9));
        given_normals.resize(mesh.triangle_count(), 3);
        for (int t = 0; t < mesh.triangle_count(); ++t) {
            const auto corner = [&](int k) -> Vector3d { return mesh.points.row(mesh.triangles(t, k)); };
            given_normals.row(t) = (corner(1) - corner(0)).cross(corner(2) - corner(0)).stableNormalized().transpose();
        }
        for (int v = 0; v < mesh.vertex_count(); ++v) points.push_back(mesh.points.row(v));
        hints.assign(points.size(), -1);
        mark(marked, fixed);
        std::vector<char> creases(points.size(), 0);
        for (int v = 0; v < mesh.vertex_count(); ++v) creases[v] = curves.tied(v);
        lengths = given_lengths = edge_lengths(mesh, L, options.adapt, creases);
    }

    /// Borders become curves, too, and what cannot be edited is fixed.
    void mark(const std::vector<EdgeCurve>& marked, const std::vector<int>& fixed) {
        std::vector<EdgeCurve> all = marked;
        std::vector<int> stay = fixed;
        of_given_curves = static_cast<int>(marked.size());
        const EdgeCurves given_curves(given.vertex_count(), marked);
        std::vector<Pair> rim;
        for_each_edge(half_edges(given), [&](auto first, auto last) {
            if (last - first == 1 && !given_curves.has_edge(first->a, first->b)) rim.emplace_back(first->a, first->b);
            if (last - first > 2 || (last - first == 2 && first->forward == (first + 1)->forward)) stay.insert(stay.end(), {first->a, first->b});
        });
        const std::vector<int> loose = non_manifold_vertices(given);
        stay.insert(stay.end(), loose.begin(), loose.end());
        std::vector<char> corners(points.size(), 0);
        for (int v = 0; v < given.vertex_count(); ++v) corners[v] = given_curves.tied(v);
        std::vector<std::array<int, 2>> beside(points.size(), {-1, -1});
        for (const auto& [a, b] : rim) {
            (beside[a][0] < 0 ? beside[a][0] : beside[a][1]) = b;
            (beside[b][0] < 0 ? beside[b][0] : beside[b][1]) = a;
        }
        for (std::size_t v = 0; v < points.size(); ++v)
            if (beside[v][1] >= 0 && -facing_cosine(points[v], points[beside[v][0]], points[beside[v][1]]) < k_border_turn) corners[v] = 1;
        for (EdgeCurve& curve : chained(given.vertex_count(), rim, corners)) {
            if (curve.closed && corners[curve.vertices.front()]) stay.push_back(curve.vertices.front());
            all.push_back(std::move(curve));
        }
        for (const EdgeCurve& curve : all) rails.emplace_back(given, curve);
        // A given curve of another mesh would be believed.
        for (const EdgeCurve& curve : marked)
            for (std::size_t i = 0; i + (curve.closed ? 0 : 1) < curve.vertices.size(); ++i) {
                const int a = curve.vertices[i], b = curve.vertices[(i + 1) % curve.vertices.size()];
                const auto at = surgery.sides(a, b);
                if (at.left < 0 && at.right < 0) throw InvalidInput("bad-curve", "A curve goes from vertex " + std::to_string(a) + " to " + std::to_string(b) + ", which no edge joins.");
            }
        curves = EdgeCurves(given.vertex_count(), std::move(all), stay, EdgeCurves::Along::edited);
    }

    [[nodiscard]] double ratio(int a, int b) const { return (points[a] - points[b]).norm() / ((lengths[a] + lengths[b]) / 2); }

    struct Candidate {
        double ratio;
        int a, b;
    };
    template <class Wanted>
    [[nodiscard]] std::vector<Candidate> candidates(Wanted wanted) const {
        std::vector<Candidate> found;
        for (const auto& [a, b] : surgery.edges())
            if (const double r = ratio(a, b); wanted(r)) found.push_back({r, a, b});
        return found;
    }

    void split() {
        auto list = candidates([](double r) { return r > k_long; });
        std::sort(list.begin(), list.end(), [](const Candidate& p, const Candidate& q) { return std::tie(q.ratio, p.a, p.b) < std::tie(p.ratio, q.a, q.b); });
        for (const auto& [r, a, b] : list) {
            full = full || surgery.vertex_count() >= options.most_vertices;
            if (full) return;
            if (!curves.may_split(a, b)) continue;
            const int middle = surgery.split(a, b);
            if (middle < 0) continue;
            points.push_back((points[a] + points[b]) / 2);
            lengths.push_back((lengths[a] + lengths[b]) / 2);
            hints.push_back(hints[a]);
            curves.split(a, b, middle);
        }
    }

    [[nodiscard]] Vector3d normal(const EdgeSurgery::Corners& c) const { return (points[c[1]] - points[c[0]]).cross(points[c[2]] - points[c[0]]); }

    /// Whether the triangles at v, but for those that `other` has, too, would turn over or get too long an edge with v at a place.
    [[nodiscard]] bool harms(int v, int other, const Vector3d& place, double longest) const {
        for (const int t : surgery.around(v)) {
            const auto& c = surgery.corners(t);
            if (std::find(c.begin(), c.end(), other) != c.end()) continue;
            const auto k = static_cast<std::size_t>(std::find(c.begin(), c.end(), v) - c.begin());
            const Vector3d &q = points[c[(k + 1) % 3]], &r = points[c[(k + 2) % 3]];
            if ((q - place).norm() > longest || (r - place).norm() > longest) return true;
            const Vector3d before = normal(c), after = (q - place).cross(r - place);
            if (!(after.dot(before) > k_turned * after.norm() * before.norm())) return true;
        }
        return false;
    }

    void collapse() {
        auto list = candidates([](double r) { return r < k_short; });
        std::sort(list.begin(), list.end(), [](const Candidate& p, const Candidate& q) { return std::tie(p.ratio, p.a, p.b) < std::tie(q.ratio, q.a, q.b); });
        for (const auto& [r, a, b] : list) {
            if (!surgery.alive(a) || !surgery.alive(b) || !(ratio(a, b) < k_short)) continue; // it may have grown
            const auto at = surgery.sides(a, b);
            if (at.left < 0 && at.right < 0) continue;
            const EdgeCurves::Collapse rule = curves.may_collapse(a, b);
            if (!rule.allowed || !surgery.may_collapse(a, b)) continue;
            const int kept = rule.kept >= 0 ? rule.kept : a, taken = kept == a ? b : a;
            const Vector3d place = rule.kept >= 0 ? points[kept] : Vector3d((points[a] + points[b]) / 2);
            const double longest = k_long * (lengths[a] + lengths[b]) / 2;
            if (harms(kept, taken, place, longest) || harms(taken, kept, place, longest)) continue;
            points[kept] = place;
            surgery.collapse(kept, taken);
            curves.collapse(kept, taken);
        }
    }

    [[nodiscard]] int off_valence(int v, int change) const {
        const auto neighbours = static_cast<int>(surgery.around(v).size());
        // A vertex of a border or curve has half of its neighbours on each side: six where it has two sides, four triangles' fans where it has one.
        const int best = on_rim[v] ? 3 : 6;
        return (neighbours + change - best) * (neighbours + change - best);
    }

    void swap(bool by_angle) {
        on_rim.assign(points.size(), 0);
        const auto all = surgery.edges();
        for (const auto& [a, b] : all)
            if (const auto at = surgery.sides(a, b); at.left < 0 || at.right < 0) on_rim[a] = on_rim[b] = 1;
        for (const auto& [a, b] : all) {
            const auto at = surgery.sides(a, b);
            if (!at.inner() || !curves.may_swap(a, b)) continue;
            const int p = at.left_corner, q = at.right_corner;
            const double largest_before = std::min(facing_cosine(points[p], points[a], points[b]), facing_cosine(points[q], points[a], points[b]));
            const double largest_after = std::min(facing_cosine(points[a], points[p], points[q]), facing_cosine(points[b], points[p], points[q]));
            if (by_angle ? !(largest_after > largest_before + k_better)
                         : off_valence(a, -1) + off_valence(b, -1) + off_valence(p, 1) + off_valence(q, 1) >= off_valence(a, 0) + off_valence(b, 0) + off_valence(p, 0) + off_valence(q, 0))
                continue;
            // By neighbours, too, no angle may come near a straight line.
            if (!by_angle && largest_after < std::min(largest_before, -0.7)) continue;
            if (!surgery.may_swap(a, b)) continue;
            const Vector3d old = normal(surgery.corners(at.left)) + normal(surgery.corners(at.right));
            const Vector3d first = normal({a, q, p}), second = normal({q, b, p});
            if (!(first.dot(old) > k_swap_turn * first.norm() * old.norm()) || !(second.dot(old) > k_swap_turn * second.norm() * old.norm())) continue;
            surgery.swap(a, b);
        }
    }

    /// A move that neither turns a triangle over nor folds it onto the next at v.
    [[nodiscard]] bool harmless(int v, const Vector3d& place) {
        fan_before.clear();
        fan_after.clear();
        for (const int t : surgery.around(v)) {
            const auto& c = surgery.corners(t);
            const auto k = static_cast<std::size_t>(std::find(c.begin(), c.end(), v) - c.begin());
            const Vector3d &q = points[c[(k + 1) % 3]], &r = points[c[(k + 2) % 3]];
            const Vector3d before = (q - points[v]).cross(r - points[v]).stableNormalized(), after = (q - place).cross(r - place).stableNormalized();
            if (!(after.dot(before) > k_turned)) return false;
            fan_before.push_back({c[(k + 1) % 3], c[(k + 2) % 3], before});
            fan_after.push_back({c[(k + 1) % 3], c[(k + 2) % 3], after});
        }
        for (std::size_t i = 0; i < fan_after.size(); ++i)
            for (std::size_t j = 0; j < fan_after.size(); ++j)
                if (fan_after[i].to == fan_after[j].from)
                    if (const double bend = fan_after[i].normal.dot(fan_after[j].normal); bend < k_folded && bend < fan_before[i].normal.dot(fan_before[j].normal)) return false;
        return true;
    }

    /// For each kink the nearest vertex of its curve that is free to go there.
    [[nodiscard]] std::vector<std::pair<int, Vector3d>> on_kinks() const {
        std::vector<std::pair<int, Vector3d>> found;
        for (std::size_t k = 0; k < rails.size(); ++k) {
            std::set<int> gone;
            for (const auto& [turn, place] : rails[k].kinks) {
                int nearest = -1;
                double least = k_infinite;
                for (const int v : curves.curves()[k].vertices)
                    if (const double d = (points[v] - place).norm(); d < least) {
                        nearest = v;
                        least = d;
                    }
                if (nearest < 0 || curves.is_corner(nearest) || curves.through(nearest).size() != 1 || least > lengths[nearest] || !gone.insert(nearest).second) continue;
                found.emplace_back(nearest, place);
            }
        }
        std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
        return found;
    }

    void relax() {
        const int n = surgery.numbered();
        const auto to_kinks = on_kinks();
        auto next_kink = to_kinks.begin();
        std::vector<Vector3d> normals(points.size(), Vector3d::Zero());
        for (int v = 0; v < n; ++v)
            for (const int t : surgery.around(v)) normals[v] += normal(surgery.corners(t));
        std::vector<std::array<int, 2>> beside(points.size(), {-1, -1});
        for (const EdgeCurve& curve : curves.curves()) {
            const std::size_t m = curve.vertices.size();
            for (std::size_t i = 0; i < m; ++i)
                if (curve.closed || (i > 0 && i + 1 < m)) beside[curve.vertices[i]] = {curve.vertices[(i + m - 1) % m], curve.vertices[(i + 1) % m]};
        }
        for (int v = 0; v < n; ++v) {
            if (!surgery.alive(v) || curves.is_corner(v)) continue;
            const Vector3d p = points[v];
            Vector3d to;
            if (curves.tied(v)) {
                if (curves.through(v).size() != 1) continue;
                to = p + k_evening * ((points[beside[v][0]] + points[beside[v][1]]) / 2 - p);
                while (next_kink != to_kinks.end() && next_kink->first < v) ++next_kink;
                if (next_kink != to_kinks.end() && next_kink->first == v) to = next_kink->second;
                else to = rails[static_cast<std::size_t>(curves.through(v).front())].nearest(to);
            } else {
                Vector3d mean = Vector3d::Zero();
                double weights = 0;
                const Vector3d m = normals[v].stableNormalized();
                // By area, over the size it should have: triangles of one kind get equal ones.
                for (const int t : surgery.around(v)) {
                    const auto& c = surgery.corners(t);
                    const double h = (lengths[c[0]] + lengths[c[1]] + lengths[c[2]]) / 3, w = normal(c).norm() / (h * h);
                    mean += w * (points[c[0]] + points[c[1]] + points[c[2]]) / 3;
                    weights += w;
                }
                if (!(weights > 0)) continue;
                Vector3d move = k_evening * (mean / weights - p);
                move -= move.dot(m) * m;
                const auto found = tree.nearest_where(p + move, k_infinite, hints[v], [&](int t) { return given_normals.row(t).dot(m) > k_same_side; });
                if (found.triangle < 0 || found.distance > 2 * lengths[v]) continue;
                hints[v] = found.triangle;
                to = found.point;
                lengths[v] = length_at(found.triangle, found.point);
            }
            for (double part = 1; part > 0.1; part /= 2)
                if (const Vector3d place = p + part * (to - p); harmless(v, place)) {
                    points[v] = place;
                    break;
                }
        }
    }

    [[nodiscard]] double length_at(int t, const Vector3d& place) const {
        if (!(options.adapt > 0)) return options.edge_length;
        double sum = 0, weights = 0;
        for (int k = 0; k < 3; ++k) { // by nearness is enough: lengths hardly change over a triangle
            const int v = given.triangles(t, k);
            const double w = 1 / ((given.points.row(v).transpose() - place).norm() + 1e-9 * options.edge_length);
            sum += w * given_lengths[v];
            weights += w;
        }
        return sum / weights;
    }

    void advance() {
        const int round = slice / k_operations;
        switch (slice % k_operations) {
        case 0: split(); break;
        case 1: collapse(); break;
        case 2: swap(round >= options.rounds - k_by_angle); break;
        default: relax(); break;
        }
        ++slice;
    }

    struct Spoke {
        int from, to;
        Vector3d normal;
    };
    std::vector<Spoke> fan_before{}, fan_after{}; ///< kept for their memory
    std::vector<char> on_rim{};
};

Remesher::Remesher(const TriangleMesh& mesh, const std::vector<EdgeCurve>& curves, const std::vector<int>& fixed, const RemeshOptions& options) {
    const auto refuse = [](const std::string& sentence) { throw InvalidInput("bad-option", sentence); };
    if (!(options.edge_length >= 0 && std::isfinite(options.edge_length))) refuse("The edge length must be above 0, or 0 for the mesh's own.");
    if (!(options.adapt >= 0 && options.adapt <= 1)) refuse("Lengths are adapted by " + std::to_string(options.adapt) + "; it must be between 0 and 1.");
    if (options.rounds < 1 || options.rounds > 40) refuse("The number of rounds is " + std::to_string(options.rounds) + "; it must be between 1 and 40.");
    state_ = std::make_unique<State>(mesh, curves, fixed, options);
}
Remesher::~Remesher() = default;
Remesher::Remesher(Remesher&&) noexcept = default;

bool Remesher::step() {
    if (state_->slice < k_operations * state_->options.rounds) state_->advance();
    return state_->slice < k_operations * state_->options.rounds;
}

double Remesher::fraction() const { return static_cast<double>(state_->slice) / (k_operations * state_->options.rounds); }

Remeshed Remesher::result() const {
    const State& s = *state_;
    const auto [place, count] = s.surgery.numbering();
    Remeshed out;
    out.mesh.triangles = s.surgery.triangles(place);
    out.mesh.points.resize(count, 3);
    for (std::size_t v = 0; v < place.size(); ++v)
        if (place[v] >= 0) out.mesh.points.row(place[v]) = s.points[v].transpose();
    for (int k = 0; k < s.of_given_curves; ++k) {
        EdgeCurve curve = s.curves.curves()[static_cast<std::size_t>(k)];
        for (int& v : curve.vertices) v = place[v];
        out.curves.push_back(std::move(curve));
    }
    for (const int v : s.fixed_at) out.fixed.push_back(place[v]);
    out.full = s.full;
    return out;
}

Remeshed remesh(const TriangleMesh& mesh, const RemeshOptions& options, const std::vector<EdgeCurve>& curves, const std::vector<int>& fixed) {
    Remesher remesher(mesh, curves, fixed, options);
    while (remesher.step()) {
    }
    return remesher.result();
}

} // namespace lissom
