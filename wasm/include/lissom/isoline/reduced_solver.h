#pragma once

#include "lissom/isoline/anderson.h"
#include "lissom/isoline/carriers.h"

#include <Eigen/Geometry>

#include <optional>
#include <vector>

namespace lissom {

/// What the handles are asked to do in one frame, in the mesh's space (D = 1).
struct ReducedTargets {
    std::vector<Eigen::Affine3d> maps; ///< one per field; of an open field it is not read, of a point where its point goes
};

struct ReducedStep {
    int solves = 0;       ///< global steps done
    double change = 0;    ///< of the sampled points in the last one, D = 1
    double local_seconds = 0, global_seconds = 0;
};

/// Local and global steps by turns in the space of the controls: the cost of one does not depend on the mesh.
///
/// Local: each carrier's rotation is that nearest to Σ w [e₁ e₂ n] [e₁ e₂ n]⁻¹ of its sampled triangles (or Isolines Eq 9 of their
/// normals). Global: the controls that fit the details so turned (Isolines Eq 10), one product with a matrix made beforehand.
/// The sampled points are what is iterated, with Anderson acceleration.
///
/// A frame starts from where the last one ended, each carrier turned on by exp(Σ φ_i log ΔR_i) of the handles' turns since; the first
/// from the identity turned so. Turns beyond 180 degrees are therefore those that were dragged.
class ReducedSolver {
public:
    struct Options {
        int memory = 5;             ///< of the acceleration; 0: plain
        double tolerance = 1e-4;    ///< stop when no sampled point moves farther, D = 1
        bool scale_details = false; ///< details take the scale of the handles, blended
        bool positions_only = false; ///< t1 of Isolines 5: every vertex its own carrier, O(n) an iteration; `carriers` then gives the first guess only
    };

    /// Factors and multiplies out. @param mesh, fields  kept by reference, as are L and areas where `positions_only`
    /// @throws SolverFailure  the energy is not positive definite
    ReducedSolver(const TriangleMesh& mesh, const SparseMatrix& L, const Eigen::VectorXd& areas, const Columns& fields, ControlSets sets,
                  Carriers carriers, ReducedEnergy energy, std::vector<HandleEnd> ends, Options options);

    /// @param solves   at most this many global steps, ≥ 1
    /// @param afresh   forget the last frame
    /// @throws SolverFailure  the result is not finite
    ReducedStep frame(const ReducedTargets& targets, int solves, bool afresh = false);

    /// Offsets of the controls' transformations, see ReducedEnergy; zeros before the first frame. 4·controls × 3.
    [[nodiscard]] const Columns& controls() const { return d_; }
    [[nodiscard]] int unknowns() const { return static_cast<int>(Y_.rows()); }
    [[nodiscard]] int sampled_triangles() const;
    [[nodiscard]] double memory_bytes() const;

private:
    using Rotations = std::vector<Eigen::Matrix3d>;

    void sample_points();
    void prescribe(const ReducedTargets& targets);
    void predict(const ReducedTargets& targets, bool afresh);
    void local();
    void global();
    void global_of_positions();
    void move_samples();

    const TriangleMesh& mesh_;
    const SparseMatrix& L_;
    const Eigen::VectorXd& areas_;
    const Columns& fields_;
    ControlSets sets_;
    Carriers carriers_;
    std::vector<HandleEnd> ends_;
    Options options_;

    SparseMatrix P_, Q_;
    std::vector<int> handle_rows_;
    Eigen::MatrixXd Y_;  ///< u × (3·carriers + h): A⁻¹ (C, −G)
    Eigen::MatrixXd inverse_; ///< A⁻¹, for positions_only

    std::vector<int> points_;                 ///< sampled vertices
    std::vector<std::array<int, 3>> corners_; ///< of each sample, numbers in points_
    std::vector<Eigen::Matrix3d> rest_inverse_; ///< [e₁ e₂ n]⁻¹ of each sample
    std::vector<Eigen::Vector3d> rest_normal_;
    std::vector<std::size_t> entry_offsets_;
    std::vector<ControlSets::Entry> entries_;

    Columns h_;
    Rotations handle_rotations_; ///< of the last frame
    Rotations rotations_;        ///< of the carriers
    std::vector<double> scales_; ///< of the carriers
    Columns right_;              ///< (R − I)ᵀ stacked, then h
    Columns d_;
    Eigen::VectorXd samples_;    ///< sampled points, x y z each
    Anderson anderson_;
    bool started_ = false;
};

/// The rotation vector of R, of a length in [0, π].
[[nodiscard]] Eigen::Vector3d rotation_vector(const Eigen::Matrix3d& R);
[[nodiscard]] Eigen::Matrix3d rotation_of(const Eigen::Vector3d& vector);

} // namespace lissom
