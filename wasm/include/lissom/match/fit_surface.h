#pragma once

#include "lissom/mesh/corner_weights.h"
#include "lissom/mesh/half_edges.h"
#include "lissom/mesh/triangle_tree.h"
#include "lissom/mesh/types.h"

#include <vector>

namespace lissom {

/// What a skin is fitted to: where on a surface the place lies that a point should go to.
///
/// A place counts only where the surface faces as the point does, so that a thin part's far side is no answer. A place on the rim of an open surface is
/// where *everything* beyond it is nearest to: only points of the skin's own border go there. In a soup every edge is
/// a rim; such a surface is asked without these rules.
/// Source: Wang et al. (004), 3.1, tracking positions. Changed: by normals and borders, always over the whole surface.
class FitSurface {
public:
    struct Rules {
        bool borders = true; ///< false: rims are as good as any other place
        bool facing = true;  ///< false: which way triangles face says nothing
    };
    /// A place of the surface; none where `triangle` is −1.
    struct Place {
        int triangle = -1;
        Eigen::Vector3d point = Eigen::Vector3d::Zero();
        double distance = 0;
        double cosine = 1;   ///< between the asking point's normal and the surface's, blended between vertices so that it does not jump at edges; 1 where facing says nothing
        bool on_border = false;
        bool ignored = false;
    };

    FitSurface(TriangleMesh mesh, const Rules& rules);
    explicit FitSurface(TriangleMesh mesh);
    FitSurface(const FitSurface&) = delete;
    FitSurface& operator=(const FitSurface&) = delete;

    /// The nearest place no farther than `reach` that faces as `normal` does, by a cosine of its triangle's normal above `least_cosine`.
    /// @param hint  triangle found before, or −1: saves time and changes nothing
    [[nodiscard]] Place nearest(const Eigen::Vector3d& p, const Eigen::Vector3d& normal, double least_cosine, double reach, int hint = -1) const;
    /// The nearest place of the rim; none where there is none in reach or rims do not count.
    [[nodiscard]] Place nearest_on_border(const Eigen::Vector3d& p, double reach) const;

    /// Leaves a part of the surface out: what is nearest there is told so. @param vertices  one flag each; a triangle is left out with all of its corners
    void ignore(std::vector<char> vertices);
    [[nodiscard]] bool ignores(int triangle) const;
    [[nodiscard]] bool ignores_some() const { return !ignored_.empty(); }

    [[nodiscard]] bool has_border() const { return border_.triangle_count() > 0; }
    [[nodiscard]] bool has_facing() const { return rules_.facing; } ///< whether normals say anything
    [[nodiscard]] const TriangleMesh& mesh() const { return mesh_; }
    [[nodiscard]] const Points& normals() const { return normals_; } ///< of triangles, unit; zero without area

private:
    FitSurface(TriangleMesh mesh, const Rules& rules, std::vector<HalfEdge> sides);

    TriangleMesh mesh_;
    Rules rules_;
    Points normals_, vertex_normals_;
    TriangleMesh border_;           ///< each edge of the rim as a triangle (a, b, b)
    std::vector<char> border_edge_; ///< of side 3 t + k, opposite corner k; empty without a rim
    std::vector<char> border_vertex_;
    std::vector<char> ignored_; ///< vertices; empty: none
    TriangleTree tree_, border_tree_;
};

/// Unit normals of triangles; zero without area.
[[nodiscard]] Points triangle_normals(const TriangleMesh& mesh);

} // namespace lissom
