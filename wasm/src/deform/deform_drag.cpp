#include "deform_state.h"

#include "lissom/mesh/errors.h"
#include "lissom/mesh/polar.h"

#include <cmath>
#include <numbers>
#include <utility>

namespace lissom {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double k_near_half_turn = 170 * std::numbers::pi / 180;

/// The rotation that carries the points nearest to their images, and of several such the least.
Matrix3d least_rotation(const Points& from, const Points& to) {
    const Points a = from.rowwise() - from.colwise().mean(), b = to.rowwise() - to.colwise().mean();
    const Matrix3d C = b.transpose() * a;
    const double size = C.norm();
    // A little of the identity decides what the points leave open.
    return nearest_rotation(size > 0 ? Matrix3d(C / size + 1e-6 * Matrix3d::Identity()) : Matrix3d::Identity());
}

double angle(const Matrix3d& R) {
    return std::acos(std::clamp((R.trace() - 1) / 2, -1.0, 1.0));
}

/// One drag. All vectors are in slots; u is a displacement, of v′ before `undo_displacement` and of v after it.
class Drag {
public:
    Drag(const PreparedDeform& prepared, std::span<const Eigen::Affine3d> targets, const Points* details)
        : p_(prepared), region_(prepared.region), targets_(targets),
          w_(Columns::Zero(region_.columns() - region_.unknowns, 3)), u_(Points::Zero(region_.slots(), 3)) {
        for (int h = 0; h < region_.handle_count; ++h) {
            const Eigen::Affine3d map = p_.working.to_working(targets[h]);
            set_parameters(h, map.linear(), map.translation());
            const Matrix3d R = nearest_rotation(map.linear());
            rotations_.push_back(R);
            turns_.push_back(turn(map.linear(), R));
        }
        for (int s = region_.unknowns; s < region_.slots(); ++s) {
            const auto v = region_.mesh.points.row(region_.vertex_of_slot[s]);
            const int row = 4 * region_.handle[region_.vertex_of_slot[s]];
            u_.row(s) = v * w_.block<3, 3>(row, 0) + w_.row(row + 3);
        }
        for (int k = 0; k < static_cast<int>(region_.poses.size()); ++k) set_pose(k);
        details_.resize(std::ssize(p_.blend_rows), 3);
        for (Eigen::Index b = 0; b < details_.rows(); ++b) details_.row(b) = details->row(p_.blend_rows[static_cast<std::size_t>(b)]) / p_.working.scale;
    }

    DeformResult run(bool settle) {
        is_final_ = settle;
        if (region_.unknowns > 0) {
            if (!p_.has_first()) {
                solve(*p_.second, nullptr);
                result_.iterations = 1;
            } else {
                const Columns ties = details_.rows() > 0 ? Columns(p_.implicit.blends * Points(p_.implicit.blend_scale.asDiagonal() * details_ - p_.implicit.blend_rest))
                                                         : Columns();
                solve(*p_.first, details_.rows() > 0 ? &ties : nullptr); // Eq 2.8, with E_T of Fu 3.3.3
                if (settle && p_.has_second()) remove_shear();
                else undo_displacement();
            }
        }
        write_back();
        warn();
        return std::move(result_);
    }

private:
    void set_parameters(int h, const Matrix3d& linear, const Vector3d& translation) {
        w_.block<3, 3>(4 * h, 0) = (linear - Matrix3d::Identity()).transpose();
        w_.row(4 * h + 3) = translation.transpose();
    }

    void set_pose(int k) {
        Points from(0, 3), to(0, 3);
        for (int s = region_.unknowns; s < region_.slots(); ++s) {
            const int v = region_.vertex_of_slot[s];
            if (region_.piece[v] != region_.poses[k]) continue;
            from.conservativeResize(from.rows() + 1, 3);
            from.row(from.rows() - 1) = region_.mesh.points.row(v);
            to.conservativeResize(from.rows(), 3);
            to.row(to.rows() - 1) = from.row(from.rows() - 1) + u_.row(s);
        }
        set_parameters(region_.handle_count + k, least_rotation(from, to), Vector3d::Zero());
    }

    void solve(const PreparedSolver& solver, const Columns* b) {
        u_.topRows(region_.unknowns) = solver.solve(w_, b, is_final_);
        result_.solve_seconds += watch_.lap();
    }

    /// M_i − I (Eq 2.5), or of the handle that prescribes it.
    [[nodiscard]] Matrix3d gradient_offset(int s) const {
        if (const int h = p_.implicit.gradient_handle[s]; h >= 0) return w_.block<3, 3>(4 * h, 0).transpose();
        Matrix3d sum = Matrix3d::Zero();
        for (int e = p_.implicit.offsets[s]; e < p_.implicit.offsets[s + 1]; ++e)
            sum.noalias() += u_.row(p_.implicit.slots[e]).transpose() * p_.implicit.coefficients.row(e);
        return sum;
    }

    /// s R − I of Eq 2.11, or R − I of Eq 2.10.
    [[nodiscard]] Matrix3d turn(const Matrix3d& M, const Matrix3d& R) const {
        return (p_.options.scale_details ? uniform_scale(M) : 1.0) * R - Matrix3d::Identity();
    }

    /// ṽ_i = M_i (v_i − v′_i) + ṽ′_i for the degenerate vertices (Fu 2.4.3).
    void undo_displacement() {
        const std::vector<int>& displaced = p_.implicit.displaced;
        Points change(static_cast<Eigen::Index>(displaced.size()), 3); // all before any: gradients read neighbours
        for (std::size_t k = 0; k < displaced.size(); ++k) change.row(k) = p_.implicit.displacement.row(k) * gradient_offset(displaced[k]).transpose();
        for (std::size_t k = 0; k < displaced.size(); ++k) u_.row(displaced[k]) -= change.row(k);
        result_.rotate_seconds += watch_.lap();
    }

    /// Eq 2.10/2.11, and again from its own result for the iterative method (Isolines, section 3).
    void remove_shear() {
        const int rounds = p_.options.method == DeformMethod::iterative ? p_.options.iterations : 1;
        const std::vector<int>& displaced = p_.implicit.displaced;
        Points b(region_.slots(), 3);
        std::vector<Matrix3d> turns(static_cast<std::size_t>(region_.slots()));
        for (int round = 0; round < rounds; ++round) {
            if (round > 0) // back to v′, whose rings have gradients
                for (std::size_t k = 0; k < displaced.size(); ++k)
                    u_.row(displaced[k]) += p_.implicit.displacement.row(k) * turns[displaced[k]].transpose();
            for (int s = 0; s < region_.slots(); ++s) {
                const int v = region_.vertex_of_slot[s];
                if (region_.role[v] == Role::region) {
                    turns[s] = turns_[region_.handle[v]];
                } else {
                    const Matrix3d M = Matrix3d::Identity() + gradient_offset(s);
                    turns[s] = turn(M, nearest_rotation(M));
                }
                b.row(s) = (turns[s] * p_.rebuild.delta.row(s).transpose()).transpose();
            }
            for (Eigen::Index k = 0; k < details_.rows(); ++k) { // interpolated details, Fu 3.3.3
                const double share = p_.options.blended[p_.blend_rows[static_cast<std::size_t>(k)]].share;
                auto detail = b.row(p_.blend_slots[static_cast<std::size_t>(k)]);
                detail = (1 - share) * detail + share * (details_.row(k) - p_.rebuild.delta.row(p_.blend_slots[static_cast<std::size_t>(k)]));
            }
            result_.rotate_seconds += watch_.lap();
            const Columns rhs = p_.rebuild.T * b;
            result_.reconstruct_seconds += watch_.lap();
            solve(*p_.second, &rhs);
            ++result_.iterations;
        }
    }

    void write_back() {
        if (!u_.allFinite())
            throw SolverFailure("The deformation ran out of numbers: a position is not finite. Move the handles less far.");
        result_.positions = p_.working.source;
        for (const auto& [v, k] : p_.free_sources) result_.positions.row(v) += p_.working.scale * u_.row(k);
        for (const auto& [v, h] : p_.handle_sources)
            result_.positions.row(v) = (targets_[h] * Vector3d(p_.working.source.row(v))).transpose();
        result_.reconstruct_seconds += watch_.lap();
    }

    /// Neighbouring handles that turn half a turn against each other leave the solve no shorter way round
    /// (Fu 2.5); others between them bridge the angle, so only sets that no small steps join count.
    void warn() {
        Finding far{"rotation-near-180", 0, {}, false};
        for (const HeldPiece& piece : region_.pieces) {
            std::vector<int> reached, waiting = piece.region_handles;
            if (piece.touches_fixed) reached.push_back(-1);
            else if (!waiting.empty()) {
                reached.push_back(waiting.front());
                waiting.erase(waiting.begin());
            }
            for (std::size_t k = 0; k < reached.size(); ++k)
                std::erase_if(waiting, [&](int h) {
                    const Matrix3d from = reached[k] < 0 ? Matrix3d(Matrix3d::Identity()) : rotations_[reached[k]];
                    if (angle(from.transpose() * rotations_[h]) > k_near_half_turn) return false;
                    reached.push_back(h);
                    return true;
                });
            for (const int h : waiting) {
                ++far.count;
                if (far.examples.size() < 8) far.examples.push_back(h);
            }
        }
        if (far.count > 0) result_.warnings.push_back(std::move(far));
    }

    const PreparedDeform& p_;
    const HeldRegion& region_;
    std::span<const Eigen::Affine3d> targets_;
    Columns w_;                       ///< W − I of handles and poses, four rows each: (v, 1) times them moves v
    Points u_;
    Points details_;                  ///< to mix in, working space
    std::vector<Matrix3d> rotations_; ///< of each handle
    std::vector<Matrix3d> turns_;     ///< s R − I of each handle
    bool is_final_ = true;
    Stopwatch watch_;
    DeformResult result_;
};

} // namespace

DeformResult drag(const PreparedDeform& prepared, std::span<const Eigen::Affine3d> targets, bool settle, const Points* details) {
    return Drag(prepared, targets, details).run(settle);
}

} // namespace lissom
