#include "lissom/wear/gradient_fit.h"

#include "lissom/mesh/operators.h"
#include "lissom/mesh/topology.h"

#include <algorithm>

namespace lissom {

using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

/// Cotangents at most as large as those of cotangent_laplacian.
constexpr double k_height_floor = 1e-4;

Points half_cotangents(const TriangleMesh& mesh) {
    Points found = Points::Zero(mesh.triangle_count(), 3);
    for (int t = 0; t < mesh.triangle_count(); ++t)
        for (int k = 0; k < 3; ++k) {
            const Vector3d at = mesh.points.row(mesh.triangles(t, k));
            const Vector3d u = mesh.points.row(mesh.triangles(t, (k + 1) % 3)).transpose() - at, w = mesh.points.row(mesh.triangles(t, (k + 2) % 3)).transpose() - at;
            const double longest = std::max({u.squaredNorm(), w.squaredNorm(), (u - w).squaredNorm()});
            if (longest > 0) found(t, k) = 0.5 * u.dot(w) / std::max(u.cross(w).norm(), k_height_floor * longest);
        }
    return found;
}

} // namespace

GradientFit::GradientFit(const TriangleMesh& mesh) : mesh_(mesh), cotangents_(half_cotangents(mesh)), areas_(vertex_areas(mesh)) {
    Components pieces = components(vertex_rings(mesh));
    piece_ = std::move(pieces.of_vertex), pieces_ = pieces.count;
    const int n = mesh.vertex_count();
    std::vector<Eigen::Triplet<double>> entries;
    for (int t = 0; t < mesh.triangle_count(); ++t)
        for (int k = 0; k < 3; ++k) {
            const int i = mesh.triangles(t, (k + 1) % 3), j = mesh.triangles(t, (k + 2) % 3);
            const double weight = cotangents_(t, k);
            entries.emplace_back(i, i, weight);
            entries.emplace_back(j, j, weight);
            entries.emplace_back(std::max(i, j), std::min(i, j), -weight);
        }
    // The right side of a piece sums to zero, so one vertex that is held at zero pulls at nothing.
    std::vector<char> held(static_cast<std::size_t>(pieces_), 0);
    for (int v = 0; v < n; ++v) {
        char& is_held = held[static_cast<std::size_t>(piece_[static_cast<std::size_t>(v)])];
        entries.emplace_back(v, v, is_held ? 0 : 1);
        is_held = 1;
    }
    SparseMatrix K(n, n);
    K.setFromTriplets(entries.begin(), entries.end());
    factor_.emplace(K, &mesh.points);
    factor_->begin(K);
}

bool GradientFit::step() {
    if (!done_) done_ = !factor_->step();
    return !done_;
}

double GradientFit::fraction() const { return done_ ? 1 : factor_->fraction(); }

Points GradientFit::fit(const std::vector<Matrix3d>& maps, const Points& means) const {
    const Triangles& T = mesh_.triangles;
    Columns u = Columns::Zero(mesh_.vertex_count(), 3);
    for (int t = 0; t < mesh_.triangle_count(); ++t) {
        const Matrix3d offset = maps[static_cast<std::size_t>(t)] - Matrix3d::Identity();
        for (int k = 0; k < 3; ++k) { // each edge by its cotangent
            const int i = T(t, (k + 1) % 3), j = T(t, (k + 2) % 3);
            const Eigen::RowVector3d along = cotangents_(t, k) * (mesh_.points.row(i) - mesh_.points.row(j)) * offset.transpose();
            u.row(i) += along;
            u.row(j) -= along;
        }
    }
    factor_->solve(u);
    Points sums = Points::Zero(pieces_, 3);
    Eigen::VectorXd areas = Eigen::VectorXd::Zero(pieces_);
    for (Eigen::Index v = 0; v < u.rows(); ++v) {
        const int piece = piece_[static_cast<std::size_t>(v)];
        sums.row(piece) += areas_[v] * (means.row(v) - u.row(v));
        areas[piece] += areas_[v];
    }
    Points placed = mesh_.points;
    for (Eigen::Index v = 0; v < u.rows(); ++v) {
        const int piece = piece_[static_cast<std::size_t>(v)];
        placed.row(v) += u.row(v) + sums.row(piece) / areas[piece];
    }
    return placed;
}

} // namespace lissom
