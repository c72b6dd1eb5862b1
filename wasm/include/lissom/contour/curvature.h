#pragma once

#include "lissom/mesh/types.h"

#include <Eigen/Geometry>

#include <vector>

namespace lissom {

/// A symmetric 3×3 matrix whose null space is the vertex normal: the shape operator, dn = S x for a step x along the surface. Positive
/// where the surface is convex seen from its outside; 1/length.
using ShapeTensor = Eigen::Matrix3d;

/// Unit normals at vertices, exact for a sphere's inscribed meshes: Σ e₁×e₂ / (|e₁|²|e₂|²) over the corners (Max, "Weights for computing
/// vertex normals from facet normals", J. Graphics Tools 4(2), 1999). Zero where no triangle has area.
[[nodiscard]] Points max_normals(const TriangleMesh& mesh);

/// The tensor of one triangle: least squares of II eᵢ = Δnᵢ over its three edges (Rusinkiewicz, "Estimating curvatures and their
/// derivatives on triangle meshes", 3DPVT 2004, Eq 4). Zero for a triangle without area.
[[nodiscard]] ShapeTensor triangle_tensor(const TriangleMesh& mesh, const Points& normals, int triangle);

/// A tangent tensor carried from normal m to normal n by the smallest turn. For opposite normals it stays.
[[nodiscard]] ShapeTensor carried(const ShapeTensor& tensor, const Eigen::Vector3d& m, const Eigen::Vector3d& n);

/// Normals and shape tensors at the vertices of a mesh, as smooth as wanted, made in slices.
///
/// Triangle tensors are carried to the corners and averaged by Voronoi area (Rusinkiewicz, sec. 3.2). Then sweeps of x ← (x + mean of
/// neighbours) / 2, of normals and of tensors alike, carried to the vertex first: noise of 0.2 % of the radius puts half of all
/// suggestive contours where none belong; 15 sweeps remove every one of them and no true one.
/// Cost: linear; 50,000 vertices some 0.2 s with 10 sweeps. Non-manifold and one-sided meshes are welcome: where triangles disagree
/// about their side, curvature is nonsense along that line and nowhere else.
class CurvatureField {
public:
    /// @param sweeps  of diffusion, ≥ 0
    CurvatureField(const TriangleMesh& mesh, int sweeps);

    /// One slice; true while there is more.
    bool step();
    [[nodiscard]] double fraction() const;

    /// As they are, for contours; and diffused, for suggestive contours.
    [[nodiscard]] const Points& normals() const { return normals_; }
    [[nodiscard]] const Points& smooth_normals() const { return smooth_; }
    [[nodiscard]] const std::vector<ShapeTensor>& tensors() const { return tensors_; }

private:
    void add_triangles(int first, int last);
    void sweep();

    const TriangleMesh* mesh_;
    int sweeps_, done_sweeps_ = 0, done_triangles_ = 0;
    Points normals_, smooth_;
    std::vector<ShapeTensor> tensors_;
    Eigen::VectorXd weights_;
    std::vector<int> ring_offsets_, ring_;
};

} // namespace lissom
