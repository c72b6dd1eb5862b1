#include "lissom/match/outer_surface.h"

#include "lissom/match/distances.h"
#include "lissom/match/flood_grid.h"
#include "lissom/mesh/disjoint_sets.h"
#include "lissom/mesh/half_edges.h"
#include "lissom/mesh/operators.h"
#include "lissom/mesh/self_intersections.h"
#include "lissom/mesh/weld.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <utility>

namespace lissom {

using Eigen::Vector3d;
using Eigen::Vector3i;

namespace {

constexpr double k_longest = 0.15;     // of a cell: edges of what crosses
constexpr double k_in_the_way = 0.05;   // of a cell: what is nearer to a place than this does not hide it
constexpr int k_rounds = 16;           // of halvings
constexpr int k_most_triangles = 400000;
constexpr int k_judges = 24;           // triangles that are asked of a patch
constexpr double k_seen = 0.25;        // of those, and of the nodes that each looks for: of either a few are seen through holes
constexpr double k_loose = 0.25;       // share of edges of one triangle above which a surface is a soup
constexpr double k_weld = 0.02;        // of the mean edge: corners of a soup that are nearer are one

using Corners = std::array<int, 3>;
using Ends = std::pair<int, int>;

Ends ends(int a, int b) { return a < b ? Ends{a, b} : Ends{b, a}; }

/// Corners of loose triangles that are meant to be one are.
void weld(OuterSurface& surface) {
    TriangleMesh& mesh = surface.mesh;
    std::vector<int> all(static_cast<std::size_t>(mesh.vertex_count()));
    std::iota(all.begin(), all.end(), 0);
    surface.leader = near_twins(mesh.points, all, k_weld * mean_edge_length(mesh));
    Eigen::Index row = 0;
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        const Eigen::RowVector3i corners = mesh.triangles.row(t).unaryExpr([&](int v) { return surface.leader[v]; });
        if (corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0]) mesh.triangles.row(row++) = corners;
    }
    mesh.triangles.conservativeResize(row, 3);
}

/// Triangles that are bisected at longest edges, neighbours along.
class Bisection {
public:
    explicit Bisection(OuterSurface& surface) : surface_(surface) {
        const TriangleMesh& mesh = surface.mesh;
        for (int t = 0; t < mesh.triangle_count(); ++t) triangles_.push_back({mesh.triangles(t, 0), mesh.triangles(t, 1), mesh.triangles(t, 2)});
        for (int v = 0; v < mesh.vertex_count(); ++v) points_.push_back(mesh.points.row(v).transpose());
    }

    /// Halves longest edges of some triangles where they are longer than that. Afterwards `from` says of which triangle each was.
    /// @returns whether any were
    bool halve(const std::vector<int>& some, double length) {
        std::map<Ends, int> middles; // of the edges to halve
        for (const int t : some) {
            const auto [edge, long_] = longest(t);
            if (long_ > length) middles.emplace(edge, -1);
        }
        if (middles.empty()) return false;
        // A triangle that loses an edge has its longest halved first, so that none becomes a sliver.
        for (bool more = true; more;) {
            more = false;
            for (int t = 0; t < std::ssize(triangles_); ++t)
                if (touched(t, middles)) more = middles.emplace(longest(t).first, -1).second || more;
        }
        for (auto& [edge, middle] : middles) {
            middle = static_cast<int>(points_.size());
            points_.push_back((points_[edge.first] + points_[edge.second]) / 2);
            surface_.between.push_back({edge.first, edge.second});
        }
        std::vector<Corners> made;
        from.clear();
        for (int t = 0; t < std::ssize(triangles_); ++t) cut(triangles_[t], t, middles, made);
        triangles_ = std::move(made);
        return true;
    }

    [[nodiscard]] TriangleMesh mesh() const {
        TriangleMesh mesh{Points(std::ssize(points_), 3), Triangles(std::ssize(triangles_), 3)};
        for (std::size_t v = 0; v < points_.size(); ++v) mesh.points.row(static_cast<Eigen::Index>(v)) = points_[v].transpose();
        for (std::size_t t = 0; t < triangles_.size(); ++t) mesh.triangles.row(static_cast<Eigen::Index>(t)) << triangles_[t][0], triangles_[t][1], triangles_[t][2];
        return mesh;
    }

    std::vector<int> from;

private:
    [[nodiscard]] std::pair<Ends, double> longest(const Corners& t) const {
        std::pair<Ends, double> found{{0, 0}, -1};
        for (int k = 0; k < 3; ++k) {
            const Ends edge = ends(t[k], t[(k + 1) % 3]);
            const double length = (points_[edge.first] - points_[edge.second]).norm();
            if (length > found.second || (length == found.second && edge < found.first)) found = {edge, length};
        }
        return found;
    }
    [[nodiscard]] std::pair<Ends, double> longest(int t) const { return longest(triangles_[t]); }

    [[nodiscard]] bool touched(int t, const std::map<Ends, int>& middles) const {
        const Corners& c = triangles_[t];
        return middles.contains(ends(c[0], c[1])) || middles.contains(ends(c[1], c[2])) || middles.contains(ends(c[2], c[0]));
    }

    void cut(const Corners& t, int source, const std::map<Ends, int>& middles, std::vector<Corners>& made) {
        // The longest edge that is to be halved: of the whole triangle its longest, of a half what is left.
        int side = -1, middle = -1;
        double most = -1;
        for (int k = 0; k < 3; ++k) {
            const Ends edge = ends(t[k], t[(k + 1) % 3]);
            const auto found = middles.find(edge);
            const double length = (points_[edge.first] - points_[edge.second]).norm();
            if (found == middles.end() || !(length > most)) continue;
            side = k;
            middle = found->second;
            most = length;
        }
        if (side < 0) {
            made.push_back(t);
            from.push_back(source);
            return;
        }
        cut({t[side], middle, t[(side + 2) % 3]}, source, middles, made);
        cut({middle, t[(side + 1) % 3], t[(side + 2) % 3]}, source, middles, made);
    }

    OuterSurface& surface_;
    std::vector<Corners> triangles_;
    std::vector<Vector3d> points_;
};

} // namespace

bool is_soup(const TriangleMesh& mesh) {
    int all = 0, open = 0;
    for_each_edge(half_edges(mesh), [&](auto first, auto last) {
        ++all;
        open += last - first == 1;
    });
    return open > k_loose * all;
}

TriangleMesh OuterSurface::seen() const { return without_triangles(mesh, hidden); }

std::vector<char> OuterSurface::carried(const std::vector<char>& flags) const {
    std::vector<char> all = flags;
    for (std::size_t v = 0; v < leader.size(); ++v)
        if (flags[v]) all[leader[v]] = 1;
    for (const auto& [a, b] : between) all.push_back(all[a] && all[b]);
    return all;
}

std::vector<std::vector<int>> OuterSurface::along(const std::vector<int>& chain) const {
    const int count = mesh.vertex_count() - static_cast<int>(between.size());
    if (std::any_of(chain.begin(), chain.end(), [&](int v) { return v < 0 || v >= count; })) return {chain}; // told where it is used
    std::map<Ends, int> middles;
    for (std::size_t i = 0; i < between.size(); ++i) middles.emplace(ends(between[i][0], between[i][1]), count + static_cast<int>(i));
    std::vector<int> fine;
    const auto append = [&](const auto& self, int a, int b) -> void {
        const auto found = middles.find(ends(a, b));
        if (found == middles.end()) {
            fine.push_back(b);
            return;
        }
        self(self, a, found->second);
        self(self, found->second, b);
    };
    for (std::size_t i = 0; i < chain.size(); ++i) {
        const int v = leader.empty() ? chain[i] : leader[chain[i]];
        if (fine.empty()) fine.push_back(v);
        else if (v != fine.back()) append(append, fine.back(), v);
    }
    std::set<Ends> all, seen;
    for (int t = 0; t < mesh.triangle_count(); ++t)
        for (int k = 0; k < 3; ++k) {
            const Ends edge = ends(mesh.triangles(t, k), mesh.triangles(t, (k + 1) % 3));
            all.insert(edge);
            if (!hidden[t]) seen.insert(edge);
        }
    std::vector<std::vector<int>> pieces;
    for (std::size_t i = 0; i + 1 < fine.size(); ++i) {
        const Ends edge = ends(fine[i], fine[i + 1]);
        if (all.contains(edge) && !seen.contains(edge)) continue;
        if (pieces.empty() || pieces.back().back() != fine[i]) pieces.push_back({fine[i]});
        pieces.back().push_back(fine[i + 1]);
    }
    return pieces;
}

struct OuterSurfaceFinder::State {
    enum class Stage { flood, cut, judge, done };

    OuterSurface out;
    TriangleMesh whole{}; ///< before it is cut
    std::optional<FloodGrid> flood{};
    std::optional<Bisection> bisection{};
    std::vector<int> crossed{}; ///< triangles that cross others, ascending
    int round = 0;
    Stage stage = Stage::flood;

    State(const TriangleMesh& model, const OuterSurfaceOptions& o) : out{.mesh = model} {
        if (is_soup(model)) weld(out);
        whole = out.mesh;
        if (is_soup(whole)) finish_whole(model);
        else flood.emplace(whole, o.cells);
    }

    /// Nothing is told to be hidden.
    void finish_whole(const TriangleMesh& model) {
        out = {.mesh = model};
        out.hidden.assign(static_cast<std::size_t>(model.triangle_count()), 0);
        stage = Stage::done;
    }

    void cut() {
        if (!bisection) {
            crossed = self_intersections(whole).triangles;
            bisection.emplace(out);
        } else crossed = still_crossed();
        const bool full = out.mesh.triangle_count() > k_most_triangles;
        if (round++ < k_rounds && !full && bisection->halve(crossed, k_longest * flood->grid().step)) {
            out.mesh = bisection->mesh();
            return;
        }
        stage = Stage::judge;
    }

    /// Parts of what crossed before; nothing else can.
    [[nodiscard]] std::vector<int> still_crossed() const {
        std::vector<int> parts;
        for (int t = 0; t < out.mesh.triangle_count(); ++t)
            if (std::binary_search(crossed.begin(), crossed.end(), bisection->from[t])) parts.push_back(t);
        TriangleMesh those{out.mesh.points, Triangles(std::ssize(parts), 3)};
        for (std::size_t i = 0; i < parts.size(); ++i) those.triangles.row(static_cast<Eigen::Index>(i)) = out.mesh.triangles.row(parts[i]);
        std::vector<int> found = self_intersections(those).triangles;
        for (int& t : found) t = parts[t];
        return found;
    }

    /// Whether a place sees the nodes that are outside: in each octant around it the nearest is asked.
    [[nodiscard]] bool sees_outside(const Vector3d& p, const std::vector<char>& reached, double reach) const {
        const Grid& grid = flood->grid();
        const Vector3d at = grid.local(p);
        const double cells = reach / grid.step;
        const Vector3i low = (at.array() - cells).ceil().cast<int>().max(0).matrix(), high = (at.array() + cells).floor().cast<int>().min(grid.size.array() - 1).matrix();
        std::array<int, 8> nearest;
        std::array<double, 8> least;
        nearest.fill(-1);
        least.fill(cells * cells);
        for (int z = low.z(); z <= high.z(); ++z)
            for (int y = low.y(); y <= high.y(); ++y)
                for (int x = low.x(); x <= high.x(); ++x) {
                    const int node = grid.node(x, y, z);
                    if (!reached[node]) continue;
                    const int octant = (x > at.x()) | (y > at.y()) << 1 | (z > at.z()) << 2;
                    const double squared = (Vector3d(x, y, z) - at).squaredNorm();
                    if (squared > least[octant]) continue;
                    least[octant] = squared;
                    nearest[octant] = node;
                }
        int asked = 0, seen = 0;
        for (const int node : nearest) {
            if (node < 0) continue;
            ++asked;
            const Vector3d from = grid.position(node), way = p - from;
            const double free = 1 - k_in_the_way * grid.step / way.norm();
            const std::vector<RayHit> hits = flood->tree().hits(from, way);
            seen += hits.empty() || hits.front().depth >= free;
        }
        return asked > 0 && seen >= k_seen * asked;
    }

    /// Through a hole in another piece a piece hangs together without crossing it: near rims each triangle is on its own.
    void mark_at_rims(std::vector<char>& alone) const {
        const TriangleMesh& mesh = out.mesh;
        std::vector<HalfEdge> rim;
        for_each_edge(half_edges(mesh), [&](auto first, auto last) {
            if (last - first == 1) rim.push_back(*first);
        });
        if (rim.empty()) return;
        TriangleMesh segments{mesh.points, Triangles(std::ssize(rim), 3)};
        for (std::size_t k = 0; k < rim.size(); ++k) segments.triangles.row(static_cast<Eigen::Index>(k)) << rim[k].a, rim[k].b, rim[k].b;
        const TriangleTree tree(segments);
        for (int t = 0; t < mesh.triangle_count(); ++t) {
            Vector3d middle = Vector3d::Zero();
            double longest = 0;
            for (int k = 0; k < 3; ++k) {
                const Eigen::RowVector3d p = mesh.points.row(mesh.triangles(t, k));
                middle += p.transpose() / 3;
                longest = std::max(longest, (mesh.points.row(mesh.triangles(t, (k + 1) % 3)) - p).norm());
            }
            if (tree.nearest_where(middle, longest, -1, [](int) { return true; }).triangle >= 0) alone[t] = 1;
        }
    }

    void judge() {
        const TriangleMesh& mesh = out.mesh;
        const int n = mesh.triangle_count();
        const double radius = flood->radii()[static_cast<std::size_t>(flood->first_sound())], reach = 2.5 * radius + 2 * flood->grid().step;
        const std::vector<char> reached = flood->reached(radius);
        std::vector<char> crosses(static_cast<std::size_t>(n), 0);
        for (const int t : crossed) crosses[t] = 1;
        mark_at_rims(crosses);
        DisjointSets patches(n);
        for_each_edge(half_edges(mesh), [&](auto first, auto last) {
            if (last - first == 2 && !crosses[first->triangle] && !crosses[(first + 1)->triangle]) patches.join(first->triangle, (first + 1)->triangle);
        });
        std::map<int, std::vector<int>> of_patch;
        for (int t = 0; t < n; ++t) of_patch[patches.find(t)].push_back(t);
        const Eigen::VectorXd areas = triangle_areas(mesh);
        out.hidden.assign(static_cast<std::size_t>(n), 0);
        double hidden = 0;
        for (auto& [name, triangles] : of_patch) {
            // The largest, for slivers lie anywhere.
            const std::ptrdiff_t asked = std::min<std::ptrdiff_t>(k_judges, std::ssize(triangles));
            std::vector<int> judges = triangles;
            std::partial_sort(judges.begin(), judges.begin() + asked, judges.end(), [&](int a, int b) { return areas[a] != areas[b] ? areas[a] > areas[b] : a < b; });
            judges.resize(static_cast<std::size_t>(asked));
            const auto seeing = std::count_if(judges.begin(), judges.end(), [&](int t) {
                const Vector3d middle = (mesh.points.row(mesh.triangles(t, 0)) + mesh.points.row(mesh.triangles(t, 1)) + mesh.points.row(mesh.triangles(t, 2))).transpose() / 3;
                return sees_outside(middle, reached, reach);
            });
            if (static_cast<double>(seeing) > k_seen * static_cast<double>(asked)) continue;
            for (const int t : triangles) {
                out.hidden[t] = 1;
                hidden += areas[t];
            }
        }
        out.hidden_share = hidden / areas.sum();
        stage = Stage::done;
    }

    void advance() {
        switch (stage) {
        case Stage::flood:
            if (!flood->step()) stage = Stage::cut;
            break;
        case Stage::cut: cut(); break;
        case Stage::judge: judge(); break;
        case Stage::done: break;
        }
    }
};

OuterSurfaceFinder::OuterSurfaceFinder(const TriangleMesh& model, const OuterSurfaceOptions& options) {
    check_cells(options.cells);
    state_ = std::make_unique<State>(model, options);
}
OuterSurfaceFinder::~OuterSurfaceFinder() = default;
OuterSurfaceFinder::OuterSurfaceFinder(OuterSurfaceFinder&&) noexcept = default;

bool OuterSurfaceFinder::step() {
    state_->advance();
    return state_->stage != State::Stage::done;
}

const OuterSurface& OuterSurfaceFinder::result() const { return state_->out; }

OuterSurface outer_surface(const TriangleMesh& model, const OuterSurfaceOptions& options) {
    OuterSurfaceFinder finder(model, options);
    while (finder.step()) {
    }
    return finder.result();
}

} // namespace lissom
