#pragma once

#include "lissom/mesh/types.h"

#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

namespace lissom {

/// A line along edges of a mesh: each vertex and the next one are joined by an edge, in a closed curve the last and the first, too.
struct EdgeCurve {
    std::vector<int> vertices; ///< no vertex twice
    bool closed = false;       ///< at least three vertices; an open one has at least two, and its ends are corners
    int layer = 0;             ///< curves of one layer meet at corners alone; those of different layers (of different models) may cross
};

/// Chains edges into curves between corners: vertices of other than two of these edges, and those flagged. Closed where there is
/// no corner, or one alone: such a loop begins there.
/// @param edges    each once, ends in [0, vertices)
/// @param corners  one flag per vertex, or none
/// @returns ordered by their smaller end, loops last by their smallest vertex. Cost: linear but for sorting
[[nodiscard]] std::vector<EdgeCurve> chained(int vertices, std::vector<std::pair<int, int>> edges, const std::vector<char>& corners = {});

/// Curves of a mesh, kept while edges of the mesh are split, collapsed and swapped: what may be done, and what becomes of them.
///
/// Source: Wang et al. (004), 3.4, Criteria 4 to 7, each edge asked once for all skins that share it (Criterion 8).
/// Changed: with `Along::edited` edges of a curve may be split, which the paper mentions and leaves out, and collapsed along the curve; else a
/// curve that is found once can never follow a change of the wanted edge length.
/// Cost: a question takes constant time, an edit of a curve the length of the curve.
class EdgeCurves {
public:
    enum class Along {
        kept,  ///< edges of curves are never split or collapsed: Criteria 5 and 6 as written
        edited ///< they may be, the curve going on as before between the same corners
    };

    /// @param fixed  further vertices that are never taken away or moved by a collapse, such as markers
    /// @throws InvalidInput `bad-curve` too short, a vertex out of range or twice
    explicit EdgeCurves(int vertices, std::vector<EdgeCurve> curves = {}, const std::vector<int>& fixed = {}, Along along = Along::kept);

    [[nodiscard]] bool has_edge(int a, int b) const { return edges_.contains(key(a, b)); }
    /// Whether a curve goes through a vertex, ends there, or the vertex is fixed.
    [[nodiscard]] bool tied(int v) const { return fixed_[v] != 0 || !through_[v].empty(); }
    /// An end of a curve, a vertex where curves of one layer meet, or fixed.
    [[nodiscard]] bool is_corner(int v) const { return corner_[v] != 0 || fixed_[v] != 0; }
    /// Numbers of the curves through a vertex, ascending.
    [[nodiscard]] const std::vector<int>& through(int v) const { return through_[v]; }
    [[nodiscard]] const std::vector<EdgeCurve>& curves() const { return curves_; }
    [[nodiscard]] int vertex_count() const { return static_cast<int>(through_.size()); }

    [[nodiscard]] bool may_swap(int a, int b) const { return !has_edge(a, b); }                            ///< Criterion 4
    [[nodiscard]] bool may_split(int a, int b) const { return along_ == Along::edited || !has_edge(a, b); } ///< Criterion 5

    struct Collapse {
        bool allowed = true;
        int kept = -1; ///< the end that stays with its place; −1: they may meet anywhere
    };
    /// Criteria 6 and 7: of two ends tied to something neither may go, of one and a free one the free one goes.
    [[nodiscard]] Collapse may_collapse(int a, int b) const;

    /// Told after each edit. Vertices are numbered as by the editor: `middle` is the next number.
    void split(int a, int b, int middle);
    void collapse(int kept, int taken);
    /// @param place  per vertex its new number, −1 where it is gone; `count` are left
    void renumber(const std::vector<int>& place, int count);

private:
    [[nodiscard]] static std::uint64_t key(int a, int b);
    void count_edge(int a, int b, int by);
    [[nodiscard]] bool may_go(int taken, int kept) const;

    std::vector<EdgeCurve> curves_;
    std::vector<std::vector<int>> through_;
    std::vector<char> corner_, fixed_;
    std::unordered_map<std::uint64_t, int> edges_; ///< how many curves run along each; asked, never walked
    Along along_;
};

} // namespace lissom
