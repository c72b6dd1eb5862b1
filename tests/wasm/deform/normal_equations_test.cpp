#include "lissom/deform/normal_equations.h"

#include "solve/matrices.h"

#include <doctest/doctest.h>

using namespace lissom;
using matrices::Sequence;

namespace {

constexpr int k_unknowns = 7, k_columns = k_unknowns + 8;

/// Rows of about four entries of three numbers each, the way a solver builds them.
EntryRows<3> some_rows(int count, std::uint32_t seed) {
    Sequence numbers(seed);
    EntryRows<3> rows;
    RowBuilder<3> row(k_columns);
    for (int i = 0; i < count; ++i) {
        for (int e = 0; e < 4; ++e) row.add(numbers.below(k_columns), Eigen::Vector3d(numbers.next(), numbers.next(), numbers.next()));
        row.append_to(rows);
    }
    return rows;
}

/// Column d of every entry as a matrix, rows × columns.
Eigen::MatrixXd dense(const EntryRows<3>& rows, int d) {
    Eigen::MatrixXd out = Eigen::MatrixXd::Zero(rows.count(), k_columns);
    for (int i = 0; i < rows.count(); ++i)
        for (int e = rows.offsets[i]; e < rows.offsets[i + 1]; ++e) out(i, rows.columns[e]) += rows.values[e][d];
    return out;
}

} // namespace

TEST_CASE("a row under construction sums what is added to a column, and is empty again once appended") {
    EntryRows<1> rows;
    RowBuilder<1> row(5);
    using One = RowBuilder<1>::Value;
    row.add(3, One(2));
    row.add(1, One(5));
    row.add(3, One(-0.5));
    CHECK(row[3][0] == 1.5);
    row.append_to(rows);
    CHECK(row.touched().empty());
    row.add(3, One(7));
    row.append_to(rows);
    row.append_to(rows); // a row may have no entry
    CHECK(rows.count() == 3);
    CHECK(rows.columns == std::vector<int>{3, 1, 3});
    CHECK(rows.values[0][0] == 1.5);
    CHECK(rows.values[2][0] == 7);
    CHECK(rows.offsets == std::vector<int>{0, 2, 3, 3});
}

TEST_CASE("the equations are the products of the rows, written out densely (seeds 1 to 10)") {
    for (std::uint32_t seed = 1; seed <= 10; ++seed) {
        CAPTURE(seed);
        const EntryRows<3> rows = some_rows(20, seed);
        Eigen::MatrixXd wanted = Eigen::MatrixXd::Zero(k_columns, k_columns);
        for (int d = 0; d < 3; ++d) wanted += dense(rows, d).transpose() * dense(rows, d);
        const NormalEquations found = normal_equations(rows, rows, k_unknowns, k_columns);
        const Eigen::MatrixXd lower = wanted.topLeftCorner(k_unknowns, k_unknowns).triangularView<Eigen::Lower>();
        CHECK((Eigen::MatrixXd(found.A) - lower).norm() < 1e-13);
        CHECK((Eigen::MatrixXd(found.G) - wanted.topRightCorner(k_unknowns, 8)).norm() < 1e-13);
    }
}

TEST_CASE("left and right rows may differ") {
    const EntryRows<3> right = some_rows(20, 3);
    EntryRows<3> left = right;
    for (auto& value : left.values) value *= 2.5;
    const NormalEquations plain = normal_equations(right, right, k_unknowns, k_columns), scaled = normal_equations(left, right, k_unknowns, k_columns);
    CHECK((Eigen::MatrixXd(scaled.A) - 2.5 * Eigen::MatrixXd(plain.A)).norm() < 1e-13);
    CHECK((Eigen::MatrixXd(scaled.G) - 2.5 * Eigen::MatrixXd(plain.G)).norm() < 1e-13);
}

TEST_CASE("only the lower triangle is stored, sorted, with every diagonal entry") {
    EntryRows<3> rows = some_rows(3, 5); // so few that some unknowns stand in none
    const SparseMatrix A = normal_equations(rows, rows, k_unknowns, k_columns).A;
    for (int m = 0; m < k_unknowns; ++m) {
        int before = m - 1;
        for (SparseMatrix::InnerIterator entry(A, m); entry; ++entry) {
            CHECK(entry.row() > before);
            before = static_cast<int>(entry.row());
        }
        const SparseMatrix::InnerIterator first(A, m);
        REQUIRE(static_cast<bool>(first));
        CHECK(first.row() == m);
    }
}
