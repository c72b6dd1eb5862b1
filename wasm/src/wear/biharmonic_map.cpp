#include "lissom/wear/biharmonic_map.h"

#include "lissom/mesh/errors.h"

#include <Eigen/LU>

#include <cmath>

namespace lissom {

using Eigen::RowVector3d;
using Eigen::Vector3d;

namespace {

constexpr double k_give = 1e-6;

} // namespace

BiharmonicMap::BiharmonicMap(const Points& from, const Points& to) : middle_(RowVector3d::Zero()) {
    const Eigen::Index n = from.rows();
    if (n < 4 || to.rows() != n) throw InvalidInput("too-few-places", "A map of space needs four places or more, each on both sides.");
    middle_ = from.colwise().mean();
    size_ = std::sqrt((from.rowwise() - middle_).rowwise().squaredNorm().mean());
    if (!(size_ > 0)) throw SolverFailure("The places that a map of space is made from are all one.");
    centres_ = (from.rowwise() - middle_) / size_;

    Eigen::MatrixXd system = Eigen::MatrixXd::Zero(n + 4, n + 4), sides = Eigen::MatrixXd::Zero(n + 4, 3);
    for (Eigen::Index j = 0; j < n; ++j) {
        system.col(j).head(n) = (centres_.rowwise() - centres_.row(j)).rowwise().norm();
        // −|x| is positive where the sums vanish: what is added has its sign.
        system(j, j) = -k_give;
    }
    system.col(n).head(n).setOnes();
    system.block(0, n + 1, n, 3) = centres_;
    system.bottomRows(4).leftCols(n) = system.rightCols(4).topRows(n).transpose();
    sides.topRows(n) = to;
    const Eigen::PartialPivLU<Eigen::Ref<Eigen::MatrixXd>> factor(system);
    if (!(factor.matrixLU().diagonal().cwiseAbs().minCoeff() > 1e-12)) throw SolverFailure("The places that a map of space is made from lie in one plane.");
    weights_ = factor.solve(sides);
    if (!weights_.allFinite()) throw SolverFailure("The places that a map of space is made from decide none.");
}

Vector3d BiharmonicMap::operator()(const Vector3d& x) const {
    const RowVector3d at = (x.transpose() - middle_) / size_;
    const Eigen::Index n = centres_.rows();
    RowVector3d sum = weights_.row(n) + at * weights_.bottomRows(3);
    for (Eigen::Index i = 0; i < n; ++i) sum += (at - centres_.row(i)).norm() * weights_.row(i);
    return sum.transpose();
}

} // namespace lissom
