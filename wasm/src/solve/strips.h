#pragma once

// Dense blocks of the factor are kept in strips: four rows, stored column after column, four numbers each.
// A product of two strips is then a 4×4 tile of sums over contiguous memory, which needs no packing and
// maps to two-wide SIMD everywhere: the vector extension below is understood by GCC and Clang for every
// target, WebAssembly's simd128 among them.

#include <cstddef>

namespace lissom::solve {

typedef double Pair __attribute__((vector_size(16), aligned(8), may_alias));

/// Four rows of one column.
struct Quad {
    Pair low, high;
};

[[gnu::always_inline]] inline Quad load(const double* p) {
    return {*reinterpret_cast<const Pair*>(p), *reinterpret_cast<const Pair*>(p + 2)};
}
[[gnu::always_inline]] inline void store(double* p, const Quad& q) {
    *reinterpret_cast<Pair*>(p) = q.low;
    *reinterpret_cast<Pair*>(p + 2) = q.high;
}
[[gnu::always_inline]] inline void add_product(Quad& sum, const Quad& q, double factor) {
    const Pair f = {factor, factor};
    sum.low += q.low * f;
    sum.high += q.high * f;
}
[[gnu::always_inline]] inline void subtract_product(Quad& difference, const Quad& q, double factor) {
    const Pair f = {factor, factor};
    difference.low -= q.low * f;
    difference.high -= q.high * f;
}

[[nodiscard]] inline int strip_count(int rows) { return (rows + 3) / 4; }

/// Where strip q of a lower triangle begins; strip q has the columns 0 … 4q+3.
[[nodiscard]] inline std::size_t triangle_strip(int q) { return std::size_t(8) * q * (q + 1); }

/// Doubles in a lower triangle of `rows` rows whose last strip is full (update matrices).
[[nodiscard]] inline std::size_t triangle_size(int rows) { return triangle_strip(strip_count(rows)); }

/// A supernode's part of L: the triangle of its own `width` rows, whose last strip ends at column width−1,
/// then the `height` rows below it in strips of `width` columns. Rows that fill up a strip are zero. The
/// diagonal holds reciprocals once factored.
struct PanelShape {
    int width, height;

    [[nodiscard]] std::size_t triangle() const {
        return triangle_strip(strip_count(width) - 1) + std::size_t(4) * width;
    }
    [[nodiscard]] std::size_t below(int q) const { return triangle() + std::size_t(4) * width * q; }
    [[nodiscard]] std::size_t size() const { return below(strip_count(height)); }
    /// Place of one entry; `row` counts from the first column's own row.
    [[nodiscard]] std::size_t at(int row, int column) const {
        return row < width ? triangle_strip(row / 4) + 4 * column + row % 4
                           : below((row - width) / 4) + 4 * column + (row - width) % 4;
    }
};

} // namespace lissom::solve
