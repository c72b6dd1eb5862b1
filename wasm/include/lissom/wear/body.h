#pragma once

#include "lissom/mesh/triangle_tree.h"
#include "lissom/mesh/winding_number.h"

#include <optional>

namespace lissom {

/// A surface with an inside: what clothes must stay out of.
///
/// What has a few openings is closed by fans over them (an ankle, a neck), what faces inward is turned. Whether winding numbers then tell the
/// inside from the outside is tried at places just beside the surface: a soup whose triangles face any way, or a
/// surface full of holes, has no inside.
class Body {
public:
    /// @param size  what lengths are shares of (√area of the skin)
    Body(const TriangleMesh& surface, double size);
    Body(const Body&) = delete;

    /// Whether at least 95 of 100 places beside the surface are told right.
    [[nodiscard]] bool has_inside() const { return has_inside_; }

    /// Whether the surface winds around the place more than half.
    [[nodiscard]] bool contains(const Eigen::Vector3d& p) const { return winding_(p) > 0.5; }

    struct Place {
        Eigen::Vector3d point, normal; ///< nearest on the surface, and the smooth unit normal there
        double distance;
    };
    [[nodiscard]] Place nearest(const Eigen::Vector3d& p) const;

private:
    TriangleMesh mesh_;
    TriangleTree tree_;
    WindingNumber winding_;
    Points normals_;
    bool has_inside_ = false;
};

} // namespace lissom
