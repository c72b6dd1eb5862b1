#pragma once

#include "lissom/mesh/topology.h"
#include "lissom/mesh/triangle_tree.h"
#include "lissom/mesh/working_mesh.h"

#include <memory>
#include <vector>

namespace lissom {

/// What curves ask of a model, made once and used for every curve on it: who neighbours whom, and what a ray meets.
///
/// Everything happens on the working copy (welded, so that soups and coincident vertices hang together; unit diagonal, so
/// that no length means anything but a share of the model). Curves come and go in source space.
/// Cost: linear; half a million vertices in about a fifth of a second. The model is shared, not copied.
class CurveSurface {
public:
    explicit CurveSurface(std::shared_ptr<const WorkingMesh> working);
    /// Of a model that outlives this.
    explicit CurveSurface(const WorkingMesh& working);

    [[nodiscard]] const WorkingMesh& working() const { return *working_; }
    [[nodiscard]] const TriangleMesh& mesh() const { return working_->mesh; }
    [[nodiscard]] const VertexRings& rings() const { return rings_; }
    [[nodiscard]] const TriangleTree& tree() const { return tree_; }

    /// Working vertices as source vertices, every one that was welded into them, ascending.
    [[nodiscard]] std::vector<int> source_vertices(const std::vector<int>& working_vertices) const;

private:
    std::shared_ptr<const WorkingMesh> working_;
    VertexRings rings_;
    TriangleTree tree_;
};

} // namespace lissom
