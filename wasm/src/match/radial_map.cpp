#include "lissom/match/radial_map.h"

#include <Eigen/LU>
#include <Eigen/SVD>

#include <cmath>

namespace lissom {

using Eigen::RowVector3d;
using Eigen::Vector3d;

namespace {

/// Spread across their plane as a share of that along it, below which the linear part is noise.
constexpr double k_flat = 1e-6;

double phi(double squared) { return squared * std::sqrt(squared); }

} // namespace

/// Brings the centres to unit size. @returns whether they decide a map
bool RadialMap::place(const Points& from) {
    if (from.rows() < 4 || !from.allFinite()) return false;
    middle_ = from.colwise().mean();
    centres_ = from.rowwise() - middle_;
    size_ = centres_.rowwise().norm().maxCoeff();
    if (!(size_ > 0)) return false;
    centres_ /= size_;
    const Vector3d spread = Eigen::JacobiSVD<Eigen::MatrixXd>(centres_).singularValues();
    return spread[2] > k_flat * spread[0];
}

/// Of λ, t and M: rows of Ψ(τ_i) = τ′_i, then of the compatibility conditions.
Eigen::MatrixXd RadialMap::system() const {
    const Eigen::Index n = centres_.rows();
    Eigen::MatrixXd A = Eigen::MatrixXd::Zero(n + 4, n + 4);
    for (Eigen::Index i = 0; i < n; ++i)
        for (Eigen::Index j = 0; j < n; ++j) A(i, j) = phi((centres_.row(i) - centres_.row(j)).squaredNorm());
    A.block(0, n, n, 1).setOnes();
    A.block(0, n + 1, n, 3) = centres_;
    A.block(n, 0, 4, n) = A.block(0, n, n, 4).transpose();
    return A;
}

std::optional<RadialMap> RadialMap::between(const Points& from, const Points& to) {
    RadialMap map;
    if (!to.allFinite() || !map.place(from)) return std::nullopt;
    const Eigen::Index n = from.rows();
    const Eigen::MatrixXd A = map.system();
    Eigen::MatrixXd B = Eigen::MatrixXd::Zero(n + 4, 3);
    B.topRows(n) = to;
    const Eigen::FullPivLU<Eigen::MatrixXd> lu(A);
    if (!lu.isInvertible()) return std::nullopt;
    map.weights_ = lu.solve(B);
    map.weights_ += lu.solve(B - A * map.weights_); // the last digits: markers are met exactly
    if (!map.weights_.allFinite()) return std::nullopt;
    return map;
}

std::optional<Eigen::MatrixXd> RadialMap::leave_one_out(const Points& from) {
    RadialMap map;
    if (from.rows() < 5 || !map.place(from)) return std::nullopt;
    const Eigen::FullPivLU<Eigen::MatrixXd> lu(map.system());
    if (!lu.isInvertible()) return std::nullopt;
    const Eigen::Index n = from.rows();
    Eigen::MatrixXd G = lu.inverse().topLeftCorner(n, n);
    if (!G.allFinite() || !(G.diagonal().cwiseAbs().minCoeff() > 1e-9 * G.cwiseAbs().maxCoeff())) return std::nullopt; // without one the others lie flat
    return G;
}

Vector3d RadialMap::operator()(const Vector3d& x) const {
    const RowVector3d at = (x.transpose() - middle_) / size_;
    const Eigen::Index n = centres_.rows();
    RowVector3d sum = weights_.row(n) + at * weights_.bottomRows<3>();
    for (Eigen::Index i = 0; i < n; ++i) sum += phi((at - centres_.row(i)).squaredNorm()) * weights_.row(i);
    return sum.transpose();
}

Points RadialMap::operator()(const Points& points) const {
    Points image(points.rows(), 3);
    for (Eigen::Index v = 0; v < points.rows(); ++v) image.row(v) = (*this)(Vector3d(points.row(v))).transpose();
    return image;
}

} // namespace lissom
