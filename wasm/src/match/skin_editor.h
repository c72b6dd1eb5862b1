#pragma once

#include "lissom/match/skin_set.h"
#include "lissom/mesh/edge_surgery.h"

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
    [[nodiscard]] std::vector<std::pair<int, int>> edges() const { return surgery_.edges(); }
    /// Of an edge's length to L.
    [[nodiscard]] double ratio(int a, int b, int skin) const { return (points_[static_cast<std::size_t>(skin)][a] - points_[static_cast<std::size_t>(skin)][b]).norm() / wanted(a, b); }
    [[nodiscard]] int vertex_count() const { return surgery_.vertex_count(); }
    [[nodiscard]] bool alive(int v) const { return surgery_.alive(v); }

    bool split(int a, int b);
    bool collapse(int a, int b);
    bool swap_if_better(int a, int b);

    /// What has come of it, without the vertices taken away.
    [[nodiscard]] SkinSet take() const;

private:
    using Places = std::vector<Eigen::Vector3d>; ///< of all vertices on one skin
    using Corners = EdgeSurgery::Corners;
    [[nodiscard]] double wanted(int a, int b) const { return (lengths_[a] + lengths_[b]) / 2; }
    [[nodiscard]] static Eigen::Vector3d normal(const Corners& corners, const Places& p); ///< twice the area long
    /// Whether the triangles at v but for two would turn over, or an edge grow too long, with v at a place.
    [[nodiscard]] bool harms(int v, int other, const Eigen::Vector3d& place, const Places& p) const;

    EdgeSurgery surgery_;
    std::vector<double> lengths_;
    double longest_;
    std::vector<Places> points_; ///< of each skin
    std::vector<int> marker_;
    std::optional<EdgeCurves> curves_;
};

} // namespace lissom
