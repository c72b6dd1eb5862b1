#pragma once

#include <Eigen/Core>

#include <array>
#include <vector>

namespace lissom {

/// A piece of a line within one triangle.
struct LinePiece {
    int triangle;
    std::array<int, 2> edges;                ///< numbers of the mesh edges it ends on; −1: it ends within the triangle
    std::array<Eigen::Vector3d, 2> ends;     ///< working space
    std::array<Eigen::Vector3d, 2> weights;  ///< of both ends in the triangle, of its corners
    std::array<double, 2> values{};          ///< D at both ends
};

/// Pieces joined end to end.
struct LineChain {
    std::vector<Eigen::Vector3d> points;
    std::vector<int> triangles;           ///< one of those that each point lies on
    std::vector<Eigen::Vector3d> weights; ///< of each point in that triangle
    std::vector<double> values;
    bool closed = false; ///< the first point follows the last

    [[nodiscard]] double length() const;
};

/// Joins pieces that end on the same edge; at an edge where more than two meet, two of the same triangle pair in the order given.
/// @returns in the order of each chain's first piece
[[nodiscard]] std::vector<LineChain> chained(const std::vector<LinePiece>& pieces);

/// Splits a chain where its direction over `bend` before and after a point differs by more than `degrees`, at the sharpest such points. A
/// closed chain with one corner is opened there. Nowhere that would leave a part shorter than `least`.
[[nodiscard]] std::vector<LineChain> split_at_corners(const LineChain& chain, double degrees, double bend, double least);

} // namespace lissom
