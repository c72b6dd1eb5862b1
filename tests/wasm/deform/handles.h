#pragma once

// What the deformation tests share: handles at the two ends of a mesh, runs, and what to measure of the result.

#include "shapes.h"

#include "lissom/deform/held_region.h"
#include "lissom/solve/sparse_cholesky.h"

#include <Eigen/Geometry>

#include <string>
#include <vector>

namespace handles {

using Eigen::Affine3d;
using Eigen::Vector3d;
using lissom::DeformHandle;
using lissom::DeformOptions;
using lissom::DeformResult;
using lissom::DeformSession;
using lissom::Points;
using lissom::TriangleMesh;

struct Named {
    const char* name;
    TriangleMesh mesh;
};

/// A flat-sided bar, closed, genus 1, with boundary, two components.
[[nodiscard]] std::vector<Named> models();

[[nodiscard]] std::vector<int> everything(const Points& points);

/// One region handle at each end of the longest axis, `share` of its length each. For two spheres: one each.
[[nodiscard]] std::vector<DeformHandle> two_ends(const Points& points, double share = 0.15);

[[nodiscard]] Affine3d turn(double degrees, const Vector3d& axis, const Vector3d& through = Vector3d::Zero());
/// Shear, stretch and turn, far from the identity, no reflection.
[[nodiscard]] Affine3d some_affine();
[[nodiscard]] Affine3d some_similarity();

[[nodiscard]] Points images(const Affine3d& map, const Points& points);

/// Largest distance between corresponding points.
[[nodiscard]] double gap(const Points& a, const Points& b);

/// Prepares, factors and drags, everything free.
[[nodiscard]] DeformResult deform(const TriangleMesh& mesh, const std::vector<DeformHandle>& handles,
                                  const std::vector<Affine3d>& targets, const DeformOptions& options = {});
void factor(DeformSession& session);

/// What a session builds its systems of: all of a mesh free but for its handles.
struct Held {
    lissom::WorkingMesh working;
    lissom::HeldRegion region;
    lissom::SparseMatrix laplacian;
    Eigen::VectorXd areas;

    Held(const TriangleMesh& mesh, const std::vector<DeformHandle>& handles);
    /// Handle parameters W − I of maps in working space, poses at rest.
    [[nodiscard]] lissom::Columns parameters(const std::vector<Affine3d>& maps) const;
    /// Unknowns of A u = b, A given by its lower triangle; by a method of its own.
    [[nodiscard]] static Points solved(const lissom::SparseMatrix& A, const Points& b);
};

/// √mean((l/l₀ − 1)²) over the edges.
[[nodiscard]] double edge_rms(const TriangleMesh& rest, const Points& moved);
[[nodiscard]] double volume_ratio(const TriangleMesh& rest, const Points& moved);

/// One of the shared models, binary little-endian PLY of float positions (and flags) and triangles; no vertices where there
/// is none.
/// @param name  below shared/data
[[nodiscard]] TriangleMesh shared_model(const std::string& name);

} // namespace handles
