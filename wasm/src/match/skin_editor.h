#pragma once

#include "lissom/match/skin_set.h"

#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace lissom {

/// Edits of one edge at a time, on all skins at once; each looks whether it may be done.
class SkinEditor {
public:
    /// @param lengths  per vertex how long edges should be there, L; of an edge the mean of its ends'
    /// @param longest  collapses make no edge longer than so many of that
    SkinEditor(const SkinSet& skins, std::vector<double> lengths, double longest);

    /// Every edge once, ordered.
    [[nodiscard]] std::vector<std::pair<int, int>> edges() const;
    /// Of an edge's length to L.
    [[nodiscard]] double ratio(int a, int b, int skin) const { return (points_[static_cast<std::size_t>(skin)][a] - points_[static_cast<std::size_t>(skin)][b]).norm() / wanted(a, b); }
    [[nodiscard]] int vertex_count() const { return vertices_; }
    [[nodiscard]] bool alive(int v) const { return !around_[v].empty(); }

    bool split(int a, int b);
    bool collapse(int a, int b);
    bool swap_if_better(int a, int b);

    /// What has come of it, without the vertices taken away.
    [[nodiscard]] SkinSet take() const;

private:
    using Places = std::vector<Eigen::Vector3d>; ///< of all vertices on one skin
    using Corners = std::array<int, 3>;
    /// The triangles at an edge: (a, b, left) and (b, a, right); −1 where there is none on that side.
    struct Sides {
        int left = -1, right = -1; ///< triangles
        int left_corner = -1, right_corner = -1;
        bool sound = true; ///< no more than one on each side
        [[nodiscard]] bool inner() const { return sound && left >= 0 && right >= 0; }
    };
    [[nodiscard]] Sides sides(int a, int b) const;
    [[nodiscard]] double wanted(int a, int b) const { return (lengths_[a] + lengths_[b]) / 2; }
    [[nodiscard]] bool on_border(int v) const;
    [[nodiscard]] std::vector<int> ring(int v) const; ///< ascending
    [[nodiscard]] static Eigen::Vector3d normal(const Corners& corners, const Places& p); ///< twice the area long
    /// Whether the triangles at v but for two would turn over, or an edge grow too long, with v at a place.
    [[nodiscard]] bool harms(int v, int other, const Eigen::Vector3d& place, const Places& p) const;
    void replace(int triangle, const Corners& corners);
    void detach(int triangle);
    void attach(int triangle);

    std::vector<double> lengths_;
    double longest_;
    std::vector<Places> points_; ///< of each skin
    std::vector<int> marker_;
    std::optional<EdgeCurves> curves_;
    std::vector<Corners> triangles_;
    std::vector<char> gone_;               ///< triangles
    std::vector<std::vector<int>> around_; ///< triangles at each vertex
    int vertices_;
};

} // namespace lissom
