#pragma once

#include "lissom/mesh/types.h"

#include <vector>

namespace lissom {

/// Triangles on their way into the working copy, in source indices, with the source face of each in file order.
struct Selection {
    Triangles triangles;
    std::vector<int> polygon_of_triangle;

    /// Which of the vertices the triangles use.
    [[nodiscard]] std::vector<bool> used(int vertex_count) const;
    /// Vertex v becomes vertex[v].
    void map(const std::vector<int>& vertex);
    /// Leaves out the triangles that use a vertex twice. @returns their faces, each once, ascending
    std::vector<int> drop_collapsed();
    /// Leaves out the triangles that repeat an earlier one. @returns their faces, each once, ascending
    std::vector<int> drop_repeated();

private:
    template <class Unwanted>
    std::vector<int> drop(Unwanted unwanted);
};

/// Both lists in one, each ascending and without repeats.
[[nodiscard]] std::vector<int> united(const std::vector<int>& a, const std::vector<int>& b);

/// What welding did.
struct Welding {
    std::vector<int> leader;              ///< per vertex the one that stands for it; −1: not used
    std::vector<int> exact, near;         ///< vertices that gave way to a twin
    std::vector<int> collapsed, repeated; ///< faces that lost a triangle by it, or that repeated an earlier one
};

/// Joins exact twins, then those within `tolerance` along what is still open, and leaves out the triangles that
/// have become pointless.
[[nodiscard]] Welding weld(const Points& points, const std::vector<bool>& used, double tolerance, Selection& chosen);

} // namespace lissom
