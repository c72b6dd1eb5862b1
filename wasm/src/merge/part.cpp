#include "lissom/merge/part.h"

#include "lissom/mesh/errors.h"
#include "lissom/mesh/half_edges.h"
#include "lissom/mesh/topology.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace lissom {
namespace {

constexpr double k_spill = 0.25; // share of the painted corners that may lie on the wrong side

/// The triangles at one edge: those that run along the loop (it has them on its left), and those that run against it.
struct Sides {
    std::vector<int> left, right;
};

class Cutter {
public:
    Cutter(const TriangleMesh& input, std::span<const BoundaryLoop> loops, const std::string& name)
        : input_(input), given_(loops), name_(name), removed_(static_cast<std::size_t>(input.triangle_count()), 0) {}

    Part run() {
        for (std::size_t k = 0; k < given_.size(); ++k) check(static_cast<int>(k));
        find_sides();
        find_neighbours();
        for (std::size_t k = 0; k < given_.size(); ++k) choose_side(static_cast<int>(k));
        for (std::size_t k = 0; k < given_.size(); ++k) remove_beyond(static_cast<int>(k));
        return collect();
    }

private:
    [[nodiscard]] std::string loop_name(int k) const {
        return "The " + name_ + " boundary" + (given_.size() > 1 ? " " + std::to_string(k + 1) : "");
    }

    void check(int k) {
        const std::vector<int>& loop = given_[k].vertices;
        for (const std::vector<int>* list : {&given_[k].vertices, &given_[k].keep})
            for (const int v : *list)
                if (v < 0 || v >= input_.vertex_count())
                    throw InvalidInput("vertex-out-of-range", loop_name(k) + " names vertex " + std::to_string(v) + ", which the model does not have.");
        if (loop.size() < 3)
            throw InvalidInput("loop-too-short", loop_name(k) + " has " + std::to_string(loop.size()) + " vertices; a closed one needs at least 3.");
        std::set<int> own;
        for (const int v : loop) {
            if (!own.insert(v).second)
                throw InvalidInput("loop-touches-itself", loop_name(k) + " passes vertex " + std::to_string(v) +
                                                              " twice. Choose a boundary that does not touch itself.");
            if (!seen_.insert(v).second)
                throw InvalidInput("loops-touch", loop_name(k) + " touches another one at vertex " + std::to_string(v) +
                                                      ". Move them apart.");
        }
    }

    void find_sides() {
        std::map<std::pair<int, int>, std::vector<int>> running; // (from, to) → triangles
        for (std::size_t k = 0; k < given_.size(); ++k) {
            const std::vector<int>& loop = given_[k].vertices;
            for (std::size_t i = 0; i < loop.size(); ++i) {
                const int a = loop[i], b = loop[(i + 1) % loop.size()];
                running[{a, b}];
                running[{b, a}];
            }
        }
        for (int t = 0; t < input_.triangle_count(); ++t)
            for (int c = 0; c < 3; ++c)
                if (const auto at = running.find({input_.triangles(t, c), input_.triangles(t, (c + 1) % 3)}); at != running.end())
                    at->second.push_back(t);
        for (std::size_t k = 0; k < given_.size(); ++k) {
            const std::vector<int>& loop = given_[k].vertices;
            auto& sides = sides_.emplace_back();
            for (std::size_t i = 0; i < loop.size(); ++i) {
                const int a = loop[i], b = loop[(i + 1) % loop.size()];
                Sides side{running[{a, b}], running[{b, a}]};
                if (side.left.empty() && side.right.empty())
                    throw InvalidInput("loop-not-connected", loop_name(static_cast<int>(k)) + " jumps from vertex " + std::to_string(a) +
                                                                 " to vertex " + std::to_string(b) + ", which no edge joins.");
                if (side.left.size() > 1 || side.right.size() > 1)
                    throw InvalidInput("loop-non-manifold", loop_name(static_cast<int>(k)) + " runs along the edge from vertex " + std::to_string(a) +
                                                                " to " + std::to_string(b) + ", where more than two faces meet. Choose another way.");
                barrier_.insert(std::minmax(a, b));
                sides.push_back(std::move(side));
            }
        }
    }

    void find_neighbours() {
        neighbours_.resize(static_cast<std::size_t>(input_.triangle_count()));
        for_each_edge(half_edges(input_), [&](auto first, auto last) {
            if (barrier_.contains({first->a, first->b})) return;
            for (auto s = first; s != last; ++s)
                for (auto o = first; o != last; ++o)
                    if (s != o) neighbours_[s->triangle].push_back(o->triangle);
        });
    }

    /// Every triangle that the seeds reach without crossing a loop.
    [[nodiscard]] std::vector<char> flood(const std::vector<int>& seeds) const {
        std::vector<char> reached(neighbours_.size(), 0);
        std::vector<int> front;
        for (const int t : seeds)
            if (!std::exchange(reached[t], 1)) front.push_back(t);
        while (!front.empty()) {
            const int t = front.back();
            front.pop_back();
            for (const int u : neighbours_[t])
                if (!std::exchange(reached[u], 1)) front.push_back(u);
        }
        return reached;
    }

    [[nodiscard]] std::vector<int> seeds(int k, bool left) const {
        std::vector<int> found;
        for (const Sides& side : sides_[k])
            for (const int t : left ? side.left : side.right) found.push_back(t);
        return found;
    }

    /// Turns the loop so that what is kept lies to its left.
    void choose_side(int k) {
        std::vector<int> loop = given_[k].vertices;
        bool only_left = false, only_right = false;
        for (const Sides& side : sides_[k]) {
            only_left = only_left || side.right.empty();
            only_right = only_right || side.left.empty();
        }
        if (only_left && only_right)
            throw InvalidInput("loop-two-sided", loop_name(k) + " runs along open edges with the surface on its left here and on its right there. "
                                                                "Follow one opening, or stay inside the surface.");
        bool keep_left = !only_right;
        if (!only_left && !only_right && !given_[k].keep.empty()) {
            const std::vector<char> left = flood(seeds(k, true)), right = flood(seeds(k, false));
            const std::set<int> on_loop(loop.begin(), loop.end()), wanted(given_[k].keep.begin(), given_[k].keep.end());
            int votes_left = 0, votes_right = 0;
            for (int t = 0; t < input_.triangle_count(); ++t)
                for (int c = 0; c < 3; ++c)
                    if (const int v = input_.triangles(t, c); wanted.contains(v) && !on_loop.contains(v)) {
                        votes_left += left[t] && !right[t];
                        votes_right += right[t] && !left[t];
                    }
            // Paint spills over an edge here and there; only a real share of it on either side leaves the choice open.
            if (std::min(votes_left, votes_right) > k_spill * (votes_left + votes_right))
                throw InvalidInput("keep-side-unclear", loop_name(k) + ": the vertices to keep lie on both sides of it. Choose those of one side.");
            keep_left = votes_left >= votes_right;
        }
        if (!keep_left) {
            std::reverse(loop.begin(), loop.end());
            std::rotate(loop.begin(), loop.end() - 1, loop.end()); // the first vertex stays first
            std::reverse(sides_[k].begin(), sides_[k].end());
            for (Sides& side : sides_[k]) std::swap(side.left, side.right);
        }
        loops_.push_back(std::move(loop));
    }

    void remove_beyond(int k) {
        const std::vector<char> beyond = flood(seeds(k, false));
        for (std::size_t l = 0; l < sides_.size(); ++l)
            for (const Sides& side : sides_[l])
                if (beyond[side.left.front()])
                    throw InvalidInput("loop-not-separating", loop_name(k) + " does not part the model: one can walk from one side of it to the other. "
                                                                             "Choose a closed path that cuts a piece off.");
        for (std::size_t t = 0; t < beyond.size(); ++t) removed_[t] = removed_[t] || beyond[t];
    }

    Part collect() {
        Part part;
        std::vector<int> place(static_cast<std::size_t>(input_.vertex_count()), -1);
        for (int t = 0; t < input_.triangle_count(); ++t)
            if (!removed_[t]) {
                part.triangle_origin.push_back(t);
                for (int c = 0; c < 3; ++c) place[input_.triangles(t, c)] = 0;
            }
        if (part.triangle_origin.empty()) throw InvalidInput("nothing-kept", "Nothing of the " + name_ + " is left beside its boundary.");
        for (int v = 0; v < input_.vertex_count(); ++v)
            if (place[v] == 0) {
                place[v] = static_cast<int>(part.origin.size());
                part.origin.push_back(Origin::of(v));
            }
        part.mesh.points.resize(std::ssize(part.origin), 3);
        for (std::size_t v = 0; v < part.origin.size(); ++v) part.mesh.points.row(v) = input_.points.row(part.origin[v].vertex[0]);
        part.mesh.triangles.resize(std::ssize(part.triangle_origin), 3);
        for (std::size_t t = 0; t < part.triangle_origin.size(); ++t)
            for (int c = 0; c < 3; ++c) part.mesh.triangles(t, c) = place[input_.triangles(part.triangle_origin[t], c)];
        part.is_whole.assign(part.triangle_origin.size(), 1);
        for (const std::vector<int>& loop : loops_) {
            auto& local = part.loops.emplace_back();
            for (const int v : loop) local.push_back(place[v]);
        }
        check_loops(part);
        return part;
    }

    /// A seam needs a surface that opens at the loop and nowhere else: no bow tie, no other opening.
    void check_loops(const Part& part) const {
        std::vector<int> open(part.origin.size(), 0);
        for (const Edge& e : edges(part.mesh))
            if (e.forward + e.backward == 1) {
                ++open[e.a];
                ++open[e.b];
            }
        const std::vector<int> ties = non_manifold_vertices(part.mesh);
        for (std::size_t k = 0; k < part.loops.size(); ++k)
            for (const int v : part.loops[k])
                if (open[v] != 2 || std::binary_search(ties.begin(), ties.end(), v))
                    throw InvalidInput("loop-touches-boundary", loop_name(static_cast<int>(k)) + " touches an opening or a second sheet at vertex " +
                                                                    std::to_string(part.origin[v].vertex[0]) + ". Lead it around.");
    }

    const TriangleMesh& input_;
    std::span<const BoundaryLoop> given_;
    const std::string& name_;
    std::vector<char> removed_;
    std::set<int> seen_;
    std::set<std::pair<int, int>> barrier_;
    std::vector<std::vector<Sides>> sides_; ///< per loop, per edge
    std::vector<std::vector<int>> neighbours_;
    std::vector<std::vector<int>> loops_;
};

} // namespace

Origin between(const Origin& a, const Origin& b, double fraction) {
    Origin result;
    int count = 0;
    const auto add = [&](int v, double weight) {
        if (weight == 0) return;
        for (int k = 0; k < count; ++k)
            if (result.vertex[k] == v) {
                result.weight[k] += weight;
                return;
            }
        if (count == 3) return; // cannot be: both points lie on one triangle
        result.vertex[count] = v;
        result.weight[count++] = weight;
    };
    for (int k = 0; k < 3; ++k) add(a.vertex[k], a.weight[k] * (1 - fraction));
    for (int k = 0; k < 3; ++k) add(b.vertex[k], b.weight[k] * fraction);
    for (; count < 3; ++count) {
        result.vertex[count] = result.vertex[0];
        result.weight[count] = 0;
    }
    return result;
}

Part cut_part(const TriangleMesh& input, std::span<const BoundaryLoop> loops, const std::string& name) {
    return Cutter(input, loops, name).run();
}

std::vector<std::vector<int>> loops_around(const TriangleMesh& mesh, std::span<const int> region) {
    std::vector<char> painted(static_cast<std::size_t>(mesh.vertex_count()), 0);
    for (const int v : region)
        if (v >= 0 && v < mesh.vertex_count()) painted[v] = 1;
    std::vector<int> inside;
    for (int t = 0; t < mesh.triangle_count(); ++t)
        if (painted[mesh.triangles(t, 0)] && painted[mesh.triangles(t, 1)] && painted[mesh.triangles(t, 2)]) inside.push_back(t);
    TriangleMesh patch{mesh.points, Triangles(std::ssize(inside), 3)};
    for (std::size_t t = 0; t < inside.size(); ++t) patch.triangles.row(t) = mesh.triangles.row(inside[t]);
    std::set<std::pair<int, int>> open;
    for (const Edge& e : edges(mesh))
        if (e.forward + e.backward == 1) open.insert({e.a, e.b});
    std::vector<std::vector<int>> loops = boundary_loops(patch);
    std::erase_if(loops, [&](const std::vector<int>& loop) {
        for (std::size_t i = 0; i < loop.size(); ++i)
            if (open.contains(std::minmax(loop[i], loop[(i + 1) % loop.size()]))) return true;
        return false;
    });
    return loops;
}

} // namespace lissom
