#pragma once

// What the isoline tests share: a model prepared, a session run, and the surface under both.

#include "../deform/handles.h"

#include "lissom/isoline/harmonic_fields.h"
#include "lissom/isoline/isoline_session.h"

#include <memory>
#include <vector>

namespace sessions {

using lissom::DeformHandle;
using lissom::IsolineModelOptions;
using lissom::IsolineOptions;
using lissom::Points;
using lissom::TriangleMesh;

/// A working mesh with its model, at one place in memory.
struct Prepared {
    lissom::WorkingMesh working;
    lissom::IsolineModel model;

    explicit Prepared(const TriangleMesh& mesh, const IsolineModelOptions& options = {});
    Prepared(const Prepared&) = delete;
    Prepared& operator=(const Prepared&) = delete;
    /// All of it free but for the handles.
    [[nodiscard]] lissom::IsolineSession session(const std::vector<DeformHandle>& handles, const IsolineOptions& options = {}) const;
};

/// A mesh of D = 1, its operators, two ends as handles and their fields.
struct Fielded {
    TriangleMesh mesh;
    lissom::SparseMatrix laplacian;
    Eigen::VectorXd areas;
    std::vector<int> handle;
    lissom::Columns fields;

    /// @param ends  one vertex list per handle
    Fielded(const TriangleMesh& mesh, const std::vector<DeformHandle>& ends);
};

struct Dragged {
    Points positions;
    int solves = 0;
    double change = 0;
};
/// One cold drag of `solves` steps, everything free.
[[nodiscard]] Dragged drag(const TriangleMesh& mesh, const std::vector<DeformHandle>& handles, const std::vector<Eigen::Affine3d>& targets,
                           const IsolineOptions& options = {}, int solves = 40);

/// Handles at the six ends of the axes, the first `count`: +x, −x, +y …
[[nodiscard]] std::vector<DeformHandle> axis_caps(const Points& points, int count, double share = 0.1);

} // namespace sessions
