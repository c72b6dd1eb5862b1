#pragma once

#include "lissom/mesh/types.h"

#include <array>
#include <utility>
#include <vector>

namespace lissom {

/// Triangles whose edges are split, collapsed and swapped one at a time; knows nothing of places. Edges of other than one or two triangles that agree are left alone.
class EdgeSurgery {
public:
    using Corners = std::array<int, 3>;

    /// Triangles with equal corners are left out.
    EdgeSurgery(const Triangles& triangles, int vertices);

    /// Every edge once, ordered.
    [[nodiscard]] std::vector<std::pair<int, int>> edges() const;
    [[nodiscard]] int vertex_count() const { return vertices_; } ///< in use
    [[nodiscard]] int numbered() const { return static_cast<int>(around_.size()); }
    [[nodiscard]] bool alive(int v) const { return !around_[v].empty(); }
    [[nodiscard]] const std::vector<int>& around(int v) const { return around_[v]; } ///< triangles
    [[nodiscard]] const Corners& corners(int t) const { return triangles_[t]; }
    [[nodiscard]] std::vector<int> ring(int v) const; ///< ascending
    [[nodiscard]] bool on_border(int v) const;

    /// The triangles at an edge: (a, b, left) and (b, a, right); −1 where there is none on that side.
    struct Sides {
        int left = -1, right = -1; ///< triangles
        int left_corner = -1, right_corner = -1;
        bool sound = true; ///< no more than one on each side
        [[nodiscard]] bool inner() const { return sound && left >= 0 && right >= 0; }
    };
    [[nodiscard]] Sides sides(int a, int b) const;

    /// @returns the new vertex, −1 where it may not be
    int split(int a, int b);
    /// Whether the surface stays what it is (link condition), no border is pinched, and no vertex is left without a fan.
    [[nodiscard]] bool may_collapse(int a, int b) const;
    void collapse(int kept, int taken);
    [[nodiscard]] bool may_swap(int a, int b) const;
    void swap(int a, int b);

    /// New numbers of vertices, −1 where gone; and how many are left.
    [[nodiscard]] std::pair<std::vector<int>, int> numbering() const;
    [[nodiscard]] Triangles triangles(const std::vector<int>& place) const;

private:
    void replace(int triangle, const Corners& corners);
    void detach(int triangle);
    void attach(int triangle);

    std::vector<Corners> triangles_;
    std::vector<char> gone_;
    std::vector<std::vector<int>> around_;
    int vertices_ = 0;
};

} // namespace lissom
