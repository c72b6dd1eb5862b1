#include "lissom/isoline/harmonic_fields.h"

#include "lissom/mesh/topology.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <utility>

namespace lissom {
namespace {

/// A field below this is none: at 1e-4 the bend that leaving it out makes is a fiftieth of a degree.
constexpr double k_faintest = 1e-4;

/// Gradients of the three hat functions of a triangle, one a row; zero for one without area.
Eigen::Matrix3d hat_gradients(const TriangleMesh& mesh, int t, double& twice_area) {
    std::array<Eigen::Vector3d, 3> p;
    for (int k = 0; k < 3; ++k) p[k] = mesh.points.row(mesh.triangles(t, k));
    const Eigen::Vector3d normal = (p[1] - p[0]).cross(p[2] - p[0]);
    const double squared = normal.squaredNorm();
    twice_area = std::sqrt(squared);
    Eigen::Matrix3d gradients = Eigen::Matrix3d::Zero();
    if (!(squared > 0)) return gradients;
    for (int k = 0; k < 3; ++k) gradients.row(k) = normal.cross(p[(k + 2) % 3] - p[(k + 1) % 3]).transpose() / squared;
    return gradients;
}

} // namespace

HarmonicFields::HarmonicFields(const TriangleMesh& mesh, const SparseMatrix& L, std::vector<int> handle, int handles)
    : handle_(std::move(handle)), handles_(handles) {
    const int n = mesh.vertex_count();
    const Components pieces = components(vertex_rings(mesh));
    std::vector<char> held(static_cast<std::size_t>(pieces.count), 0);
    for (int v = 0; v < n; ++v)
        if (handle_[v] >= 0) held[pieces.of_vertex[v]] = 1;
    unknown_.assign(static_cast<std::size_t>(n), -1);
    std::vector<int> vertex_of;
    for (int v = 0; v < n; ++v)
        if (handle_[v] < 0 && held[pieces.of_vertex[v]]) {
            unknown_[v] = unknowns_++;
            vertex_of.push_back(v);
        }
    if (unknowns_ == 0) return;

    NormalEquations equations;
    equations.A.resize(unknowns_, unknowns_);
    equations.A.reserve(L.nonZeros() / 2 + n);
    std::vector<Eigen::Triplet<double>> given;
    Points coordinates(unknowns_, 3);
    for (int k = 0; k < unknowns_; ++k) {
        const int v = vertex_of[k];
        coordinates.row(k) = mesh.points.row(v);
        equations.A.startVec(k);
        for (SparseMatrix::InnerIterator e(L, v); e; ++e) {
            const auto w = static_cast<int>(e.row());
            if (unknown_[w] >= k) equations.A.insertBack(unknown_[w], k) = -e.value(); // L is negative semi-definite
            else if (handle_[w] >= 0) given.emplace_back(k, handle_[w], -e.value());
        }
    }
    equations.A.finalize();
    equations.G.resize(unknowns_, handles_);
    equations.G.setFromTriplets(given.begin(), given.end());
    solver_.emplace(std::move(equations), coordinates);
}

bool HarmonicFields::step() { return solver_ && !solver_->ready() && solver_->step(); }
double HarmonicFields::fraction() const { return solver_ ? solver_->fraction() : 1; }
double HarmonicFields::memory_bytes() const { return solver_ ? solver_->memory_bytes() : 0; }

Columns HarmonicFields::solve() const {
    const auto n = static_cast<Eigen::Index>(handle_.size());
    Columns fields = Columns::Zero(n, handles_);
    Columns inner;
    if (solver_ && handles_ > 1) inner = solver_->solve(Columns::Identity(handles_, handles_ - 1));
    for (Eigen::Index v = 0; v < n; ++v) {
        if (handle_[v] >= 0) {
            fields(v, handle_[v]) = 1;
        } else if (unknown_[v] >= 0) {
            if (handles_ > 1) fields.row(v).head(handles_ - 1) = inner.row(unknown_[v]);
            fields(v, handles_ - 1) = 1 - fields.row(v).head(handles_ - 1).sum();
        }
    }
    normalise_fields(fields);
    return fields;
}

void normalise_fields(Columns& fields) {
    for (Eigen::Index v = 0; v < fields.rows(); ++v) {
        auto row = fields.row(v);
        if ((row.array() == 0).all()) continue;
        row = (row.cwiseMin(1.0).array() - k_faintest).cwiseMax(0.0).matrix();
        row /= row.sum();
    }
}

Columns field_gradients(const TriangleMesh& mesh, const Columns& fields) {
    const Eigen::Index k = fields.cols();
    Columns sums = Columns::Zero(mesh.vertex_count(), 3 * k);
    Eigen::VectorXd areas = Eigen::VectorXd::Zero(mesh.vertex_count());
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        double area = 0;
        const Eigen::Matrix3d hats = hat_gradients(mesh, t, area);
        for (Eigen::Index i = 0; i < k; ++i) {
            Eigen::RowVector3d gradient = Eigen::RowVector3d::Zero();
            for (int c = 0; c < 3; ++c) gradient += fields(mesh.triangles(t, c), i) * hats.row(c);
            for (int c = 0; c < 3; ++c) sums.row(mesh.triangles(t, c)).segment<3>(3 * i) += area * gradient;
        }
        for (int c = 0; c < 3; ++c) areas[mesh.triangles(t, c)] += area;
    }
    for (Eigen::Index v = 0; v < sums.rows(); ++v)
        if (areas[v] > 0) sums.row(v) /= areas[v];
    return sums;
}

Columns rigidity_fields(const TriangleMesh& mesh, const Columns& fields) {
    const Eigen::Index k = fields.cols();
    Columns sums = Columns::Zero(mesh.vertex_count(), k);
    Eigen::VectorXd areas = Eigen::VectorXd::Zero(mesh.vertex_count());
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        double area = 0;
        const Eigen::Matrix3d hats = hat_gradients(mesh, t, area);
        for (Eigen::Index i = 0; i < k; ++i) {
            Eigen::RowVector3d gradient = Eigen::RowVector3d::Zero();
            for (int c = 0; c < 3; ++c) gradient += fields(mesh.triangles(t, c), i) * hats.row(c);
            const double magnitude = area * gradient.norm(); // magnitudes are averaged, not vectors, which cancel at a ridge
            for (int c = 0; c < 3; ++c) sums(mesh.triangles(t, c), i) += magnitude;
        }
        for (int c = 0; c < 3; ++c) areas[mesh.triangles(t, c)] += area;
    }
    for (Eigen::Index v = 0; v < sums.rows(); ++v)
        if (areas[v] > 0) sums.row(v) /= areas[v];
    return sums;
}

Eigen::VectorXd combined_rigidity(const Columns& rigidity) { return rigidity.rowwise().norm(); }

} // namespace lissom
