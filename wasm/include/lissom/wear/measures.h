#pragma once

#include "lissom/mesh/types.h"

#include <Eigen/Geometry>

#include <optional>
#include <utility>
#include <vector>

namespace lissom {

/// Something to measure on a body.
struct Measure {
    enum class Kind {
        height,  ///< extent along `direction`
        section, ///< the closed line through `vertex` in which the plane square to `direction` cuts the surface
        loop,    ///< the closed line through `vertices`
        path     ///< the open line through `vertices`
    };
    Kind kind = Kind::height;
    Eigen::Vector3d direction{0, 1, 0}; ///< of any length but 0
    int vertex = 0;
    std::vector<int> vertices;
    bool hull = false;            ///< of closed lines: as a tape would lie, along their convex hull
    std::optional<double> wanted; ///< in the body's unit, above 0; none: it is only measured
};

/// A measure of a body, and how it changes with it.
struct Measured {
    double value = 0;
    std::vector<std::pair<int, Eigen::RowVector3d>> slope; ///< ∂value/∂position of some vertices, which may stand more than once
    std::vector<Eigen::Vector3d> line;                     ///< what was measured: along the hull where that was asked for
};

/// Measures bodies of one connectivity.
class Measurer {
public:
    explicit Measurer(const Triangles& triangles, int vertex_count);

    /// @throws InvalidInput `vertex-out-of-range`, `bad-measure` (no direction, fewer than three vertices of a loop or two of a path, nothing or less wanted).
    ///                      @param number  of the measure, for who has to mend it
    void check(const Measure& measure, int number) const;

    /// @param points  n×3. @throws InvalidInput `loop-open`: the section runs off the surface's border, or does not cut it at the vertex
    [[nodiscard]] Measured measure(const Points& points, const Measure& measure, int number) const;

private:
    struct Crossing {
        int above, below; ///< the edge, by its ends
    };
    [[nodiscard]] std::vector<Crossing> section(const Points& points, const Eigen::Vector3d& normal, int vertex) const;

    Triangles triangles_;
    int vertex_count_;
    std::vector<int> beyond_;               ///< of side 3 t + k (corner k to k + 1) the triangle behind it; −1: a border, or more than one
    std::vector<std::vector<int>> around_;  ///< triangles of each vertex
};

} // namespace lissom
