#pragma once

#include "lissom/isoline/field_basis.h"
#include "lissom/mesh/types.h"
#include "lissom/solve/sparse_cholesky.h"

#include <span>
#include <vector>

namespace lissom {

/// What turns the details: which rotations each vertex takes, and how much of each (sum 1).
///
/// Patches: one a vertex. Isolines (W_δ of Isolines 4.3): those of its controls.
struct DetailCarriers {
    struct Share {
        int carrier;
        double weight;
    };
    std::vector<int> offsets; ///< n+1
    std::vector<Share> shares;
    int count = 0;
};

/// What a handle prescribes of the controls of its own field.
struct HandleEnd {
    enum class Kind {
        region, ///< the whole transformation where its field is 1: four known rows
        point,  ///< where one point goes: one known row; the linear part is the solve's
        open    ///< nothing: a handle that the solve places
    };
    Kind kind = Kind::region;
    Eigen::Vector3d at = Eigen::Vector3d::Zero(); ///< the point that a `point` handle holds

    [[nodiscard]] int rows() const { return kind == Kind::region ? 4 : kind == Kind::point ? 1 : 0; }
};

/// The deformation energy in the space of the controls, as offsets d of their transformations from the identity, 4 rows a control
/// (three of the linear part, transposed, then the translation), columns x, y, z:
///
///     E(d) = Σ_k |(L W d)_k − (R_k − I) δ_k|² / a_k + β² (n − 1) Σ_ij |d_ij − d_i,j+1|²         (Isolines 4.2, normalised)
///
/// with L the cotangent stiffness, δ = L x, a_k a third of the ring's area: the first sum is ∫|Δx′ − R Δx|² dA, which has no unit and
/// does not depend on the tessellation, where the paper's, without a_k and in the model's own units, does. Handles are substituted:
/// d = P u + Q h.
///
/// Cost: one pass over the vertices; W is never stored. Memory: (4·controls)² + 12·controls·carriers numbers.
struct ReducedEnergy {
    Eigen::MatrixXd A;            ///< u × u, PᵀAP, symmetric positive definite
    Eigen::MatrixXd G;            ///< u × h, PᵀAQ
    Eigen::MatrixXd C;            ///< u × 3·carriers: A u = C (R − I) − G h, with (R_c − I)ᵀ in rows 3c … 3c+2
    SparseMatrix P;               ///< 4·controls × u
    SparseMatrix Q;               ///< 4·controls × h
    std::vector<int> handle_rows; ///< first row of each field's handle in h; one more at the end: their count

    [[nodiscard]] int unknowns() const { return static_cast<int>(A.rows()); }
};

/// @param mesh    D = 1, centred; vertices with fields of 0 are left out
/// @param L       cotangent Laplacian of it; @param areas  a_k
/// @param fields  n×k as HarmonicFields gives them
/// @param ends    one per field
/// @param beta    weight of the smoothness between neighbouring controls, > 0, no unit
[[nodiscard]] ReducedEnergy reduced_energy(const TriangleMesh& mesh, const SparseMatrix& L, const Eigen::VectorXd& areas, const Columns& fields,
                                           const ControlSets& sets, const DetailCarriers& carriers, std::span<const HandleEnd> ends, double beta);

/// Where the controls take a point: x + Σ w (D x + t). @param d  4·controls × 3, see ReducedEnergy
[[nodiscard]] Eigen::Vector3d blended(const Eigen::Vector3d& x, std::span<const ControlSets::Entry> entries, const Columns& d);

} // namespace lissom
