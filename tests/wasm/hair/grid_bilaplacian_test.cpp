#include "lissom/hair/grid_bilaplacian.h"

#include "hair/fields.h"

#include <doctest/doctest.h>

using namespace lissom;
using Eigen::MatrixXd;

namespace {

const Grid k_grid{{0, 0, 0}, 1, {9, 11, 8}};

} // namespace

TEST_CASE("the cosine basis inverts the squared grid Laplacian") {
    const GridBilaplacian K(k_grid.size);
    const SparseMatrix L = fields::grid_laplacian(k_grid);
    std::srand(3);
    MatrixXd f = MatrixXd::Random(k_grid.count(), 2);
    f.rowwise() -= f.colwise().mean().eval();
    CHECK((L * (L * K.apply_inverse(f)) - f).norm() < 1e-10 * f.norm());
}

TEST_CASE("Green's function by reflection is the inverse's own entry") {
    const GridBilaplacian K(k_grid.size);
    for (const int q : {0, 17, 402, k_grid.count() - 1}) {
        MatrixXd unit = MatrixXd::Zero(k_grid.count(), 1);
        unit(q, 0) = 1;
        const MatrixXd column = K.apply_inverse(unit);
        for (int p = 0; p < k_grid.count(); p += 13)
            CHECK(K.green(k_grid.cell(p), k_grid.cell(q)) == doctest::Approx(column(p, 0)).epsilon(1e-9));
    }
}

TEST_CASE("what is constant has no bend: it is dropped, and no answer holds any of it") {
    const GridBilaplacian K(k_grid.size);
    MatrixXd unit = MatrixXd::Zero(k_grid.count(), 1);
    unit(100, 0) = 1;
    const double usual = 7 * K.apply_inverse(unit).norm() * k_grid.count(); // of as much that is not constant
    CHECK(K.apply_inverse(MatrixXd::Constant(k_grid.count(), 1, 7)).norm() < 1e-14 * usual);
    CHECK(std::abs(K.apply_inverse(unit).sum()) < 1e-9);
}

TEST_CASE("Green's function of many pairs is that of each, and the same either way") {
    const GridBilaplacian K(k_grid.size);
    const std::vector<Eigen::Vector3i> rows{{0, 0, 0}, {8, 10, 7}, {3, 4, 5}}, columns{{1, 2, 3}, {3, 4, 5}};
    const MatrixXd G = K.green(rows, columns);
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 2; ++j) {
            CHECK(G(i, j) == K.green(rows[static_cast<std::size_t>(i)], columns[static_cast<std::size_t>(j)]));
            CHECK(G(i, j) == doctest::Approx(K.green(columns[static_cast<std::size_t>(j)], rows[static_cast<std::size_t>(i)])));
        }
}

TEST_CASE("the smoothest modes are orthonormal eigenvectors, the constant first") {
    const GridBilaplacian K(k_grid.size);
    std::vector<Eigen::Vector3i> all;
    for (int node = 0; node < k_grid.count(); ++node) all.push_back(k_grid.cell(node));
    const GridBilaplacian::Modes modes = K.smoothest(all, 3);
    REQUIRE(modes.values.cols() == 27);
    CHECK((modes.values.transpose() * modes.values - MatrixXd::Identity(27, 27)).norm() < 1e-12);
    CHECK(modes.inverse[0] == 0);
    CHECK((modes.values.col(0).array() - modes.values(0, 0)).matrix().norm() < 1e-12);
    const MatrixXd image = K.apply_inverse(modes.values);
    CHECK((image - modes.values * modes.inverse.asDiagonal()).norm() < 1e-9 * image.norm());
}
