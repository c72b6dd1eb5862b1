#include "lissom/isoline/reduced_solver.h"

#include "lissom/isoline/triangle_frames.h"
#include "lissom/mesh/errors.h"
#include "lissom/mesh/polar.h"
#include "lissom/mesh/stopwatch.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

namespace lissom {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Share of the last rotation in Eq 9, whose matrix has no inverse where all normals lie in a plane (a bar, a cylinder).
constexpr double k_inertia = 0.01;

/// Share in a first guess of handles that rule a carrier less than all points do.
constexpr double k_hearsay = 1e-3;

/// A⁻¹ B by a Cholesky factor of A scaled to a unit diagonal; tried again with the diagonal raised where rounding spoils it.
Eigen::MatrixXd solved(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B) {
    const Eigen::VectorXd scale = A.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
    Eigen::MatrixXd scaled = scale.asDiagonal() * A * scale.asDiagonal();
    for (const double shift : {0.0, 1e-13, 1e-11, 1e-9}) {
        scaled.diagonal().setConstant(1 + shift);
        const Eigen::LLT<Eigen::MatrixXd> factor(scaled);
        if (factor.info() != Eigen::Success) continue;
        const Eigen::MatrixXd right = scale.asDiagonal() * B;
        Eigen::MatrixXd x = factor.solve(right);
        scaled.diagonal().setOnes();
        x += factor.solve(right - scaled * x); // one refinement gives back what a condition of 1e9 takes
        return scale.asDiagonal() * x;
    }
    throw SolverFailure("The reduced system of " + std::to_string(A.rows()) +
                        " unknowns is not positive definite. Use fewer controls, or handles that lie farther apart.");
}

} // namespace

Vector3d rotation_vector(const Matrix3d& R) {
    const Eigen::AngleAxisd turn(R);
    return turn.angle() * turn.axis();
}

Matrix3d rotation_of(const Vector3d& vector) {
    const double angle = vector.norm();
    return angle > 0 ? Eigen::AngleAxisd(angle, vector / angle).toRotationMatrix() : Matrix3d(Matrix3d::Identity());
}

ReducedSolver::ReducedSolver(const TriangleMesh& mesh, const SparseMatrix& L, const Eigen::VectorXd& areas, const Columns& fields, ControlSets sets,
                             Carriers carriers, ReducedEnergy energy, std::vector<HandleEnd> ends, Options options)
    : mesh_(mesh), L_(L), areas_(areas), fields_(fields), sets_(std::move(sets)), carriers_(std::move(carriers)), ends_(std::move(ends)),
      options_(options), P_(std::move(energy.P)), Q_(std::move(energy.Q)), handle_rows_(std::move(energy.handle_rows)), anderson_(options.memory) {
    const Eigen::Index h = energy.G.cols(), details = energy.C.cols();
    Eigen::MatrixXd right(energy.A.rows(), details + h);
    right << energy.C, -energy.G;
    Y_ = solved(energy.A, right);
    if (options_.positions_only) inverse_ = solved(energy.A, Eigen::MatrixXd::Identity(energy.A.rows(), energy.A.rows()));
    h_ = Columns::Zero(h, 3);
    right_ = Columns::Zero(details + h, 3);
    d_ = Columns::Zero(P_.rows(), 3);
    rotations_.assign(static_cast<std::size_t>(carriers_.details.count), Matrix3d::Identity());
    scales_.assign(rotations_.size(), 1);
    handle_rotations_.assign(ends_.size(), Matrix3d::Identity());
    sample_points();
}

void ReducedSolver::sample_points() {
    std::map<int, int> number;
    const auto take = [&](int v) {
        const auto [at, fresh] = number.try_emplace(v, static_cast<int>(points_.size()));
        if (fresh) points_.push_back(v);
        return at->second;
    };
    if (options_.positions_only) {
        for (int v = 0; v < mesh_.vertex_count(); ++v) points_.push_back(v);
    } else {
        for (const auto& samples : carriers_.samples)
            for (const Carriers::Sample& s : samples) {
                std::array<int, 3> corner;
                for (int k = 0; k < 3; ++k) corner[k] = take(mesh_.triangles(s.triangle, k));
                corners_.push_back(corner);
                const Matrix3d frame = triangle_frame(mesh_.points.row(mesh_.triangles(s.triangle, 0)), mesh_.points.row(mesh_.triangles(s.triangle, 1)),
                                                      mesh_.points.row(mesh_.triangles(s.triangle, 2)));
                rest_inverse_.push_back(frame.inverse());
                rest_normal_.push_back(frame.col(2));
            }
    }
    entry_offsets_.push_back(0);
    std::vector<ControlSets::Entry> entries;
    for (const int v : points_) {
        entries.clear();
        if ((fields_.row(v).array() != 0).any())
            sets_.entries_at({fields_.data() + v * fields_.cols(), static_cast<std::size_t>(fields_.cols())}, entries);
        entries_.insert(entries_.end(), entries.begin(), entries.end());
        entry_offsets_.push_back(entries_.size());
    }
    samples_.resize(3 * static_cast<Eigen::Index>(points_.size()));
    move_samples();
}

int ReducedSolver::sampled_triangles() const { return options_.positions_only ? mesh_.triangle_count() : static_cast<int>(corners_.size()); }

double ReducedSolver::memory_bytes() const {
    return 8.0 * static_cast<double>(Y_.size() + inverse_.size() + samples_.size() * (2 * options_.memory + 4)) +
           static_cast<double>(entries_.size() * sizeof(ControlSets::Entry) + rest_inverse_.size() * sizeof(Matrix3d));
}

void ReducedSolver::prescribe(const ReducedTargets& targets) {
    for (std::size_t f = 0; f < ends_.size(); ++f) {
        const Eigen::Affine3d& map = targets.maps[f];
        const Eigen::Index row = handle_rows_[f];
        if (ends_[f].kind == HandleEnd::Kind::region) {
            h_.middleRows<3>(row) = (map.linear() - Matrix3d::Identity()).transpose();
            h_.row(row + 3) = map.translation().transpose();
        } else if (ends_[f].kind == HandleEnd::Kind::point) {
            h_.row(row) = (map * ends_[f].at - ends_[f].at).transpose();
        }
    }
    right_.bottomRows(h_.rows()) = h_;
}

void ReducedSolver::predict(const ReducedTargets& targets, bool afresh) {
    if (afresh || !started_) {
        std::fill(rotations_.begin(), rotations_.end(), Matrix3d::Identity());
        std::fill(handle_rotations_.begin(), handle_rotations_.end(), Matrix3d::Identity());
    }
    Columns turns = Columns::Zero(static_cast<Eigen::Index>(ends_.size()), 4); // rotation vector and logarithm of the scale
    Eigen::VectorXd oriented = Eigen::VectorXd::Zero(turns.rows());
    for (std::size_t f = 0; f < ends_.size(); ++f) {
        if (ends_[f].kind != HandleEnd::Kind::region) continue;
        const auto row = static_cast<Eigen::Index>(f);
        const Matrix3d linear = targets.maps[f].linear(), R = nearest_rotation(linear);
        oriented[row] = 1;
        turns.row(row).head<3>() = rotation_vector(R * handle_rotations_[f].transpose()).transpose();
        turns(row, 3) = options_.scale_details ? std::log(std::max(uniform_scale(linear), 1e-12)) : 0;
        handle_rotations_[f] = R;
    }
    // Where only points rule, all handles that have a direction are asked alike.
    const Eigen::MatrixXd fields = carriers_.fields + k_hearsay * (Eigen::VectorXd::Ones(carriers_.fields.rows()) - carriers_.fields * oriented) * oriented.transpose();
    const Eigen::VectorXd weights = fields * oriented;
    const Columns means = fields * turns;
    for (std::size_t c = 0; c < rotations_.size(); ++c) {
        const auto row = static_cast<Eigen::Index>(c);
        if (const int f = carriers_.handle[c]; f >= 0) {
            rotations_[c] = handle_rotations_[f];
            scales_[c] = std::exp(turns(f, 3));
        } else if (weights[row] > 0) {
            rotations_[c] = rotation_of(means.row(row).head<3>().transpose() / weights[row]) * rotations_[c];
            scales_[c] = std::exp(means(row, 3) / weights[row]);
        }
    }
}

void ReducedSolver::local() {
    std::size_t s = 0;
    for (std::size_t c = 0; c < rotations_.size(); ++c) {
        const auto& samples = carriers_.samples[c];
        if (samples.empty()) continue;
        Matrix3d moved = Matrix3d::Zero(), rest = Matrix3d::Zero();
        double weights = 0;
        for (const Carriers::Sample& sample : samples) {
            const auto at = [&](int k) -> Vector3d { return samples_.segment<3>(3 * corners_[s][static_cast<std::size_t>(k)]); };
            const Matrix3d frame = triangle_frame(at(0), at(1), at(2));
            if (carriers_.normals_only) {
                moved.noalias() += sample.weight * frame.col(2) * rest_normal_[s].transpose();
                rest.noalias() += sample.weight * rest_normal_[s] * rest_normal_[s].transpose();
            } else {
                moved.noalias() += sample.weight * (frame * rest_inverse_[s]);
            }
            weights += sample.weight;
            ++s;
        }
        if (carriers_.normals_only) { // Eq 9
            moved += k_inertia * weights * rotations_[c];
            rest += k_inertia * weights * Matrix3d::Identity();
            rotations_[c] = moved * rest.inverse();
        } else {
            rotations_[c] = nearest_rotation(moved);
        }
    }
}

void ReducedSolver::global() {
    for (std::size_t c = 0; c < rotations_.size(); ++c)
        right_.middleRows<3>(3 * static_cast<Eigen::Index>(c)) = (scales_[c] * rotations_[c] - Matrix3d::Identity()).transpose();
    const Columns u = Y_ * right_; // Eq 10
    d_ = P_ * u + Q_ * h_;
    move_samples();
}

/// Right-hand side Wᵀ Lᵀ a⁻¹ (R − I) δ (Isolines Eq 6), every vertex turned by what its own triangles say.
void ReducedSolver::global_of_positions() {
    Points moved(mesh_.vertex_count(), 3);
    for (int v = 0; v < mesh_.vertex_count(); ++v) moved.row(v) = samples_.segment<3>(3 * v).transpose();
    const Rotations turned = vertex_rotations(mesh_, moved);
    Points b = L_ * mesh_.points;
    for (int v = 0; v < mesh_.vertex_count(); ++v)
        b.row(v) = ((turned[v] - Matrix3d::Identity()) * b.row(v).transpose()).transpose() / areas_[v];
    const Points fitted = L_ * b;
    Columns right = Columns::Zero(P_.rows(), 3);
    for (int v = 0; v < mesh_.vertex_count(); ++v)
        for (std::size_t e = entry_offsets_[v]; e < entry_offsets_[v + 1]; ++e) {
            const Eigen::RowVector3d row = entries_[e].weight * fitted.row(v);
            auto block = right.middleRows<4>(4 * entries_[e].control);
            block.topRows<3>() += mesh_.points.row(v).transpose() * row;
            block.row(3) += row;
        }
    const Columns u = inverse_ * (P_.transpose() * right) + Y_.rightCols(h_.rows()) * h_;
    d_ = P_ * u + Q_ * h_;
    move_samples();
}

void ReducedSolver::move_samples() {
    for (std::size_t p = 0; p < points_.size(); ++p)
        samples_.segment<3>(3 * static_cast<Eigen::Index>(p)) =
            blended(mesh_.points.row(points_[p]), {entries_.data() + entry_offsets_[p], entry_offsets_[p + 1] - entry_offsets_[p]}, d_);
}

ReducedStep ReducedSolver::frame(const ReducedTargets& targets, int solves, bool afresh) {
    ReducedStep step;
    Stopwatch watch;
    prescribe(targets);
    predict(targets, afresh);
    // Of positions, too, the first guess is the patches', for there are none yet to read rotations from.
    if (options_.positions_only && started_ && !afresh) global_of_positions();
    else global();
    started_ = true;
    step.solves = 1;
    step.global_seconds += watch.lap();
    if ((d_.array() == 0).all()) return step; // at rest: rotations read from the points would differ from none by rounding
    anderson_.restart();
    Eigen::VectorXd x = samples_;
    while (step.solves < solves) {
        if (!options_.positions_only) local();
        step.local_seconds += watch.lap();
        if (options_.positions_only) global_of_positions();
        else global();
        ++step.solves;
        step.change = 0;
        for (Eigen::Index p = 0; p < x.size(); p += 3) step.change = std::max(step.change, (samples_ - x).segment<3>(p).norm());
        if (!(step.change > options_.tolerance)) {
            step.global_seconds += watch.lap();
            break;
        }
        x = anderson_.next(x, samples_);
        if (step.solves < solves) samples_ = x;
        step.global_seconds += watch.lap();
    }
    if (!d_.allFinite()) throw SolverFailure("The reduced deformation ran out of numbers: a control is not finite. Move the handles less far.");
    return step;
}

} // namespace lissom
