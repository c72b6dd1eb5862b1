#pragma once

#include "lissom/deform/prepared_solver.h"
#include "lissom/mesh/types.h"

#include <optional>
#include <vector>

namespace lissom {

/// One harmonic field per handle: L φ_i = 0 with φ_i = 1 on handle i and 0 on the others (Isolines 4.1).
///
/// The cotangents are not clamped: what little leaves [0, 1] is clipped and the fields divided by their sum, so that
/// they sum to one everywhere (a partition of unity). A piece of the mesh without any handle is left out: all
/// its fields are 0.
///
/// Cost: one factorization for all fields; one solve of handles − 1 columns, the last field being what is left of 1.
class HarmonicFields {
public:
    /// Assembles and analyzes; call step() until it returns false, then take().
    /// @param L       cotangent Laplacian of the mesh (negative semi-definite)
    /// @param handle  per vertex the handle it belongs to, or −1
    /// @param handles how many there are; a handle without a vertex has a field of zeros
    HarmonicFields(const TriangleMesh& mesh, const SparseMatrix& L, std::vector<int> handle, int handles);

    /// One slice of the factorization. @returns true while there is more. @throws SolverFailure
    bool step();
    [[nodiscard]] double fraction() const;
    [[nodiscard]] double memory_bytes() const;

    /// n×handles, row by row. Requires that step() has returned false.
    [[nodiscard]] Columns solve() const;

private:
    std::vector<int> handle_;
    int handles_;
    std::vector<int> unknown_; ///< per vertex, −1: given or left out
    int unknowns_ = 0;
    std::optional<PreparedSolver> solver_; ///< none where nothing is unknown
};

/// Clips fields to [0, 1], takes 1e-4 off each and divides them by their sum: what a handle has no say in is then 0
/// and costs nothing, and where a field dies out it has no step. Rows without any field stay 0.
void normalise_fields(Columns& fields);

/// |∇φ_i| per vertex, area-weighted over its triangles: small where the surface stays rigid (Isolines 4.1). 1/length.
/// @returns n×handles
[[nodiscard]] Columns rigidity_fields(const TriangleMesh& mesh, const Columns& fields);

/// √(Σ_i ψ_i²) of each row (Isolines 4.1).
[[nodiscard]] Eigen::VectorXd combined_rigidity(const Columns& rigidity);

/// ∇φ_i per vertex, area-weighted over its triangles, 3 numbers a field. 1/length. @returns n×3·handles
[[nodiscard]] Columns field_gradients(const TriangleMesh& mesh, const Columns& fields);

} // namespace lissom
