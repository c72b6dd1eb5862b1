#include "lissom/hair/grid_bilaplacian.h"

#include <array>
#include <cmath>
#include <numbers>

namespace lissom {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3i;

namespace {

/// Multiplies axis d of a box of numbers (x fastest) by `m`; the axis takes m.rows() as its new length.
std::vector<double> along(const std::vector<double>& box, Vector3i& size, int d, const MatrixXd& m) {
    using Map = Eigen::Map<const MatrixXd>;
    const Index before = d == 0 ? 1 : d == 1 ? size[0] : Index(size[0]) * size[1];
    const Index length = size[d];
    const Index after = Index(size.prod()) / (before * length);
    std::vector<double> out(static_cast<std::size_t>(before * m.rows() * after));
    if (before == 1) {
        Eigen::Map<MatrixXd>(out.data(), m.rows(), after).noalias() = m * Map(box.data(), length, after);
    } else {
        const MatrixXd mt = m.transpose();
        for (Index slab = 0; slab < after; ++slab)
            Eigen::Map<MatrixXd>(out.data() + slab * before * m.rows(), before, m.rows()).noalias() =
                Map(box.data() + slab * before * length, before, length) * mt;
    }
    size[d] = static_cast<int>(m.rows());
    return out;
}

} // namespace

GridBilaplacian::GridBilaplacian(const Vector3i& size) : size_(size), inverse_(size.prod()) {
    MatrixXd image[3]; // image(u, k) = (c_k²/2) cos(πku/n): one factor of T
    Eigen::VectorXd eigenvalue[3];
    for (int d = 0; d < 3; ++d) {
        const int n = size[d];
        cosine_[d].resize(n, n);
        image[d].resize(n + 1, n);
        eigenvalue[d].resize(n);
        for (int k = 0; k < n; ++k) {
            const double c2 = (k == 0 ? 1.0 : 2.0) / n;
            const double angle = std::numbers::pi * k / n;
            for (int p = 0; p < n; ++p) cosine_[d](k, p) = std::sqrt(c2) * std::cos(angle * (p + 0.5));
            for (int u = 0; u <= n; ++u) image[d](u, k) = 0.5 * c2 * std::cos(angle * u);
            eigenvalue[d][k] = (2 - 2 * std::cos(angle)) / 6;
        }
    }
    Index at = 0;
    for (int z = 0; z < size[2]; ++z)
        for (int y = 0; y < size[1]; ++y)
            for (int x = 0; x < size[0]; ++x, ++at) {
                const double lambda = eigenvalue[0][x] + eigenvalue[1][y] + eigenvalue[2][z];
                inverse_[at] = at == 0 ? 0 : 1 / (lambda * lambda);
            }
    Vector3i shape = size;
    table_.assign(inverse_.data(), inverse_.data() + inverse_.size());
    for (int d = 0; d < 3; ++d) table_ = along(table_, shape, d, image[d]);
}

GridBilaplacian::Modes GridBilaplacian::smoothest(const std::vector<Vector3i>& nodes, int per_axis) const {
    const Vector3i n = size_.cwiseMin(per_axis);
    Modes modes{MatrixXd(static_cast<Index>(nodes.size()), n.prod()), Eigen::VectorXd(n.prod())};
    Index column = 0;
    for (int z = 0; z < n.z(); ++z)
        for (int y = 0; y < n.y(); ++y)
            for (int x = 0; x < n.x(); ++x, ++column) {
                modes.inverse[column] = inverse_[x + Index(size_.x()) * (y + Index(size_.y()) * z)];
                for (std::size_t i = 0; i < nodes.size(); ++i)
                    modes.values(static_cast<Index>(i), column) =
                        cosine_[0](x, nodes[i].x()) * cosine_[1](y, nodes[i].y()) * cosine_[2](z, nodes[i].z());
            }
    return modes;
}

MatrixXd GridBilaplacian::apply_inverse(const MatrixXd& f) const {
    MatrixXd out(f.rows(), f.cols());
    for (Index c = 0; c < f.cols(); ++c) {
        std::vector<double> box(f.col(c).data(), f.col(c).data() + f.rows());
        Vector3i shape = size_;
        for (int d = 0; d < 3; ++d) box = along(box, shape, d, cosine_[d]);
        Eigen::Map<Eigen::VectorXd>(box.data(), inverse_.size()).array() *= inverse_.array();
        for (int d = 0; d < 3; ++d) box = along(box, shape, d, cosine_[d].transpose());
        out.col(c) = Eigen::Map<const Eigen::VectorXd>(box.data(), f.rows());
    }
    return out;
}

namespace {

/// The two distances at which a pair of nodes and its mirror image see each other along one axis of n nodes.
std::array<int, 2> images(int p, int q, int n) {
    const int sum = p + q + 1;
    return {p < q ? q - p : p - q, sum <= n ? sum : 2 * n - sum};
}

} // namespace

double GridBilaplacian::green(const Vector3i& p, const Vector3i& q) const {
    const auto x = images(p[0], q[0], size_[0]), y = images(p[1], q[1], size_[1]), z = images(p[2], q[2], size_[2]);
    const Index row = size_[0] + 1, slab = row * (size_[1] + 1);
    double sum = 0;
    for (const int w : z)
        for (const int v : y) {
            const double* line = table_.data() + w * slab + v * row;
            sum += line[x[0]] + line[x[1]];
        }
    return sum;
}

MatrixXd GridBilaplacian::green(const std::vector<Vector3i>& rows, const std::vector<Vector3i>& columns) const {
    MatrixXd g(static_cast<Index>(rows.size()), static_cast<Index>(columns.size()));
    for (std::size_t j = 0; j < columns.size(); ++j)
        for (std::size_t i = 0; i < rows.size(); ++i)
            g(static_cast<Index>(i), static_cast<Index>(j)) = green(rows[i], columns[j]);
    return g;
}

} // namespace lissom
