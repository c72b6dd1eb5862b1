#include "lissom/merge/transition.h"

#include "lissom/mesh/errors.h"
#include "lissom/mesh/surface_paths.h"
#include "lissom/mesh/topology.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace lissom {
namespace {

constexpr double k_snap = 0.25; // of an edge: the line passes through vertices nearer than this

class StripCutter {
public:
    StripCutter(const Part& part, int loop, double width, const std::string& name) : part_(part), loop_(loop), width_(width), name_(name) {}

    Strip run(Part& rest) {
        measure();
        cut_triangles();
        Strip strip;
        std::vector<int> in_rest = collect_rest(rest);
        collect_strip(strip, in_rest);
        set_rest_loops(rest, in_rest);
        return strip;
    }

private:
    [[noreturn]] void refuse() const {
        throw InvalidInput("transition-not-a-ring", "The transition region of the " + name_ + " is not one band around the boundary: its width is shorter than the faces there, "
                                                        "or reaches around the model or to another opening. Choose another width.");
    }

    void measure() {
        const WeightedGraph graph = edge_graph(part_.mesh);
        const ShortestPaths found = shortest_paths(graph, part_.loops[loop_], 4 * width_);
        level_.resize(static_cast<std::size_t>(part_.mesh.vertex_count()));
        for (std::size_t v = 0; v < level_.size(); ++v) level_[v] = std::min(found.distance[v], 4 * width_);
        distance_ = level_;
        for (double& l : level_) l -= width_;
        std::vector<char> onto(level_.size(), 0);
        const std::set<int> loop(part_.loops[loop_].begin(), part_.loops[loop_].end());
        for (int v = 0; v < graph.size(); ++v)
            for (int e = graph.offsets[v]; e < graph.offsets[v + 1]; ++e) {
                const int w = graph.ends[e];
                if (level_[v] * level_[w] < 0 && std::abs(level_[v]) < k_snap * (std::abs(level_[v]) + std::abs(level_[w])) && !loop.contains(v)) onto[v] = 1;
            }
        for (std::size_t v = 0; v < level_.size(); ++v)
            if (onto[v]) level_[v] = 0;
        for (const std::vector<int>& other : part_.loops)
            if (&other != &part_.loops[loop_])
                for (const int v : other)
                    if (level_[v] <= 0) refuse();
    }

    int crossing(int a, int b) {
        const auto key = std::minmax(a, b);
        if (const auto known = crossings_.find(key); known != crossings_.end()) return known->second;
        const double f = level_[key.first] / (level_[key.first] - level_[key.second]);
        const int vertex = part_.mesh.vertex_count() + static_cast<int>(new_points_.size());
        new_points_.emplace_back((1 - f) * part_.mesh.points.row(key.first) + f * part_.mesh.points.row(key.second));
        new_origins_.push_back(between(part_.origin[key.first], part_.origin[key.second], f));
        return crossings_[key] = vertex;
    }

    struct Piece {
        std::array<int, 3> v;
        int triangle;
        bool whole, in_strip;
    };

    void cut_triangles() {
        for (int t = 0; t < part_.mesh.triangle_count(); ++t) {
            const std::array<int, 3> c{part_.mesh.triangles(t, 0), part_.mesh.triangles(t, 1), part_.mesh.triangles(t, 2)};
            int below = 0, above = 0;
            for (const int v : c) {
                below += level_[v] < 0;
                above += level_[v] > 0;
            }
            if (below == 0 || above == 0) {
                pieces_.push_back({c, t, true, below > 0});
                continue;
            }
            std::vector<int> low, high; // the two sides' polygons, in order
            for (int k = 0; k < 3; ++k) {
                const int a = c[k], b = c[(k + 1) % 3];
                if (level_[a] <= 0) low.push_back(a);
                if (level_[a] >= 0) high.push_back(a);
                if (level_[a] * level_[b] < 0) {
                    const int x = crossing(a, b);
                    low.push_back(x);
                    high.push_back(x);
                }
            }
            add_polygon(low, t, true);
            add_polygon(high, t, false);
        }
    }

    [[nodiscard]] Eigen::RowVector3d point(int v) const {
        return v < part_.mesh.vertex_count() ? Eigen::RowVector3d(part_.mesh.points.row(v)) : new_points_[static_cast<std::size_t>(v - part_.mesh.vertex_count())];
    }

    void add_polygon(const std::vector<int>& p, int t, bool in_strip) {
        if (p.size() == 3) pieces_.push_back({{p[0], p[1], p[2]}, t, false, in_strip});
        if (p.size() != 4) return;
        if ((point(p[0]) - point(p[2])).norm() <= (point(p[1]) - point(p[3])).norm() * (1 + 1e-9)) {
            pieces_.push_back({{p[0], p[1], p[2]}, t, false, in_strip});
            pieces_.push_back({{p[0], p[2], p[3]}, t, false, in_strip});
        } else {
            pieces_.push_back({{p[0], p[1], p[3]}, t, false, in_strip});
            pieces_.push_back({{p[1], p[2], p[3]}, t, false, in_strip});
        }
    }

    /// Gathers the pieces of one side. @returns its vertex for each of ours, −1 elsewhere
    std::vector<int> gather(bool in_strip, TriangleMesh& mesh, std::vector<Origin>& origins) const {
        const int own = part_.mesh.vertex_count();
        std::vector<int> place(static_cast<std::size_t>(own) + new_points_.size(), -1);
        Eigen::Index count = 0;
        for (const Piece& piece : pieces_)
            if (piece.in_strip == in_strip) {
                ++count;
                for (const int v : piece.v) place[v] = 0;
            }
        int vertices = 0;
        for (int& p : place)
            if (p == 0) p = vertices++;
        mesh.points.resize(vertices, 3);
        origins.clear();
        for (int v = 0; v < std::ssize(place); ++v)
            if (place[v] >= 0) {
                mesh.points.row(place[v]) = point(v);
                origins.push_back(v < own ? part_.origin[v] : new_origins_[static_cast<std::size_t>(v - own)]);
            }
        mesh.triangles.resize(count, 3);
        Eigen::Index t = 0;
        for (const Piece& piece : pieces_)
            if (piece.in_strip == in_strip) mesh.triangles.row(t++) << place[piece.v[0]], place[piece.v[1]], place[piece.v[2]];
        return place;
    }

    std::vector<int> collect_rest(Part& rest) const {
        rest = {};
        std::vector<int> place = gather(false, rest.mesh, rest.origin);
        if (rest.mesh.triangle_count() == 0) refuse();
        for (const Piece& piece : pieces_)
            if (!piece.in_strip) {
                rest.triangle_origin.push_back(part_.triangle_origin[piece.triangle]);
                rest.is_whole.push_back(piece.whole && part_.is_whole[piece.triangle]);
            }
        return place;
    }

    void collect_strip(Strip& strip, const std::vector<int>& in_rest) {
        const std::vector<int> place = gather(true, strip.mesh, strip.origin);
        strip.part_vertex.assign(strip.origin.size(), -1);
        strip.distance.assign(strip.origin.size(), width_);
        std::vector<int> ours(strip.origin.size());
        for (int v = 0; v < std::ssize(place); ++v)
            if (place[v] >= 0) {
                ours[place[v]] = v;
                if (v >= part_.mesh.vertex_count()) continue;
                strip.part_vertex[place[v]] = v;
                strip.distance[place[v]] = std::min(distance_[v], width_);
            }
        const auto borders = boundary_loops(strip.mesh);
        if (borders.size() != 2 || euler_characteristic(strip.mesh) != 0 || components(vertex_rings(strip.mesh)).count != 1 || !non_manifold_vertices(strip.mesh).empty()) refuse();
        for (const int v : part_.loops[loop_]) {
            if (place[v] < 0) refuse();
            strip.near.push_back(place[v]);
        }
        const std::set<int> near(strip.near.begin(), strip.near.end());
        const std::vector<int>& far = near.contains(borders[0].front()) ? borders[1] : borders[0];
        strip.far.assign(far.rbegin(), far.rend());
        for (const int v : strip.far) {
            if (near.contains(v) || in_rest[ours[v]] < 0) refuse();
            strip.far_in_rest.push_back(in_rest[ours[v]]);
        }
    }

    void set_rest_loops(Part& rest, const std::vector<int>& in_rest) const {
        std::vector<char> on_line(rest.origin.size(), 0);
        for (int v = 0; v < std::ssize(in_rest); ++v)
            if (in_rest[v] >= 0) on_line[in_rest[v]] = v >= part_.mesh.vertex_count() || level_[v] == 0;
        std::vector<int> line;
        for (const std::vector<int>& border : boundary_loops(rest.mesh)) {
            if (!std::all_of(border.begin(), border.end(), [&](int v) { return on_line[v]; })) continue;
            if (!line.empty()) refuse();
            line = border;
        }
        if (line.empty() || !non_manifold_vertices(rest.mesh).empty()) refuse();
        for (std::size_t k = 0; k < part_.loops.size(); ++k) {
            auto& loop = rest.loops.emplace_back();
            if (static_cast<int>(k) == loop_) loop = line;
            else
                for (const int v : part_.loops[k]) loop.push_back(in_rest[v]);
        }
    }

    const Part& part_;
    const int loop_;
    const double width_;
    const std::string& name_;
    std::vector<double> distance_, level_; ///< level: distance less the width
    std::map<std::pair<int, int>, int> crossings_;
    std::vector<Eigen::RowVector3d> new_points_;
    std::vector<Origin> new_origins_;
    std::vector<Piece> pieces_;
};

} // namespace

Strip cut_strip(const Part& part, int loop, double width, const std::string& name, Part& rest) {
    return StripCutter(part, loop, width, name).run(rest);
}

} // namespace lissom
