#include "front.h"

#include <algorithm>
#include <cmath>

namespace lissom::solve {

namespace {

/// Strips that pass through a tile column in one go: 32 of 64 columns are 64 kB, which stays near the core.
constexpr int k_strips_at_once = 32;

/// tile −= a bᵀ over `n` columns: a and b point into strips, tile is W columns of a strip.
template <int W>
[[gnu::always_inline]] inline void subtract_product(double* tile, const double* a, const double* b, int n) {
    Quad sum[W] = {};
    const double* const end = a + 4 * n;
    for (; a + 16 <= end; a += 16, b += 16) // by fours: engines check for interrupts once a round
        for (int k = 0; k < 16; k += 4) {
            const Quad rows = load(a + k);
            for (int w = 0; w < W; ++w)
                add_product(sum[w], rows, b[k + w]);
        }
    for (; a < end; a += 4, b += 4) {
        const Quad rows = load(a);
        for (int w = 0; w < W; ++w)
            add_product(sum[w], rows, b[w]);
    }
    for (int w = 0; w < W; ++w) {
        Quad t = load(tile + 4 * w);
        t.low -= sum[w].low;
        t.high -= sum[w].high;
        store(tile + 4 * w, t);
    }
}

/// X Lᵀ = tile for a tile of W columns; `diagonal` is L's tile with reciprocals on its diagonal.
template <int W>
[[gnu::always_inline]] inline void solve_tile(double* tile, const double* diagonal) {
    Quad x[W];
    for (int w = 0; w < W; ++w)
        x[w] = load(tile + 4 * w);
    for (int w = 0; w < W; ++w) {
        const double reciprocal = diagonal[4 * w + w];
        const Pair r = {reciprocal, reciprocal};
        x[w].low *= r;
        x[w].high *= r;
        for (int v = w + 1; v < W; ++v)
            subtract_product(x[v], x[w], diagonal[4 * w + v]);
        store(tile + 4 * w, x[w]);
    }
}

/// Cholesky factor of a tile of W columns in place, reciprocals on the diagonal.
template <int W>
Breakdown factor_tile(double* tile) {
    for (int w = 0; w < W; ++w) {
        const double pivot = tile[4 * w + w];
        if (!(pivot > 0) || !std::isfinite(pivot))
            return {w, pivot};
        const double reciprocal = 1 / std::sqrt(pivot);
        tile[4 * w + w] = reciprocal;
        for (int i = w + 1; i < 4; ++i)
            tile[4 * w + i] *= reciprocal;
        for (int v = w + 1; v < W; ++v)
            for (int i = v; i < 4; ++i)
                tile[4 * v + i] -= tile[4 * w + i] * tile[4 * w + v];
    }
    return {};
}

/// Calls f with the number of columns of the tile at `column`, at most 4, as a constant.
template <class F>
auto with_tile_width(int column, int end, const F& f) {
    switch (std::min(4, end - column)) {
    case 1: return f.template operator()<1>();
    case 2: return f.template operator()<2>();
    case 3: return f.template operator()<3>();
    default: return f.template operator()<4>();
    }
}

/// Finishes W columns from `column` on, given the columns [begin, column) of the same block.
template <int W>
Breakdown factor_tile_column(const Front& front, int begin, int column) {
    const int width = front.shape.width;
    const int first = column / 4;
    double* const own = front.panel + triangle_strip(first);
    double* const diagonal = own + 4 * column;
    const int n = column - begin;
    subtract_product<W>(diagonal, own + 4 * begin, own + 4 * begin, n);
    if (const Breakdown breakdown = factor_tile<W>(diagonal); breakdown.column >= 0)
        return {column + breakdown.column, breakdown.pivot};
    for (int q = first + 1; q < strip_count(width); ++q) {
        double* const strip = front.panel + triangle_strip(q);
        subtract_product<W>(strip + 4 * column, strip + 4 * begin, own + 4 * begin, n);
        solve_tile<W>(strip + 4 * column, diagonal);
    }
    double* strip = front.panel + front.shape.below(0);
    for (int q = 0; q < strip_count(front.shape.height); ++q, strip += 4 * width) {
        subtract_product<W>(strip + 4 * column, strip + 4 * begin, own + 4 * begin, n);
        solve_tile<W>(strip + 4 * column, diagonal);
    }
    return {};
}

/// Subtracts what the columns [begin, end) of the panel contribute to W later columns of it, in the strips
/// [from, to), counted from the top of the panel.
template <int W>
void update_tile_column(const Front& front, int begin, int end, int column, int from, int to) {
    const int width = front.shape.width;
    const int own_strips = strip_count(width);
    const double* const own = front.panel + triangle_strip(column / 4) + 4 * begin;
    for (int q = std::max(from, column / 4); q < std::min(to, own_strips); ++q) {
        double* const strip = front.panel + triangle_strip(q);
        subtract_product<W>(strip + 4 * column, strip + 4 * begin, own, end - begin);
    }
    for (int q = std::max(from - own_strips, 0); q < to - own_strips; ++q) {
        double* const strip = front.panel + front.shape.below(q);
        subtract_product<W>(strip + 4 * column, strip + 4 * begin, own, end - begin);
    }
}

void update_panel(const Front& front, int begin, int end) {
    const int width = front.shape.width;
    const int strips = strip_count(width) + strip_count(front.shape.height);
    for (int from = end / 4; from < strips; from += k_strips_at_once) {
        const int to = std::min(from + k_strips_at_once, strips);
        for (int column = end; column < std::min(width, 4 * to); column += 4)
            with_tile_width(column, width, [&]<int W>() {
                update_tile_column<W>(front, begin, end, column, from, to);
            });
    }
}

/// Subtracts what the columns [begin, end) of the panel contribute to the update matrix.
void update_triangle(const Front& front, int begin, int end) {
    const std::size_t stride = std::size_t(4) * front.shape.width;
    const double* const below = front.panel + front.shape.below(0) + 4 * begin;
    const int strips = strip_count(front.shape.height);
    for (int from = 0; from < strips; from += k_strips_at_once) {
        const int to = std::min(from + k_strips_at_once, strips);
        for (int p = 0; p < to; ++p)
            for (int q = std::max(p, from); q < to; ++q)
                subtract_product<4>(front.update + triangle_strip(q) + 16 * p, below + stride * q,
                                    below + stride * p, end - begin);
    }
}

} // namespace

void extend_add(const Front& front, const double* child_update, int rows, const int* place) {
    const int width = front.shape.width;
    const int own = static_cast<int>(std::lower_bound(place, place + rows, width) - place);
    for (int i = 0; i < rows; ++i) {
        const double* const from = child_update + triangle_strip(i / 4) + i % 4;
        double* const panel = front.panel + front.shape.at(place[i], 0);
        const int in_panel = std::min(own, i + 1);
        for (int j = 0; j < in_panel; ++j)
            panel[4 * place[j]] += from[4 * j];
        if (i < own)
            continue;
        const int row = place[i] - width;
        double* const update = front.update + triangle_strip(row / 4) + row % 4;
        for (int j = own; j <= i; ++j)
            update[4 * (place[j] - width)] += from[4 * j];
    }
}

Breakdown factor_block(const Front& front, int begin) {
    const int width = front.shape.width;
    const int end = std::min(begin + k_block_columns, width);
    for (int column = begin; column < end; column += 4) {
        const Breakdown breakdown = with_tile_width(
            column, end, [&]<int W>() { return factor_tile_column<W>(front, begin, column); });
        if (breakdown.column >= 0)
            return breakdown;
    }
    update_panel(front, begin, end);
    update_triangle(front, begin, end);
    return {};
}

double block_work(PanelShape shape, int begin) {
    const double columns = std::min(k_block_columns, shape.width - begin);
    const double rows = shape.width - begin + shape.height;
    return columns * rows * rows / 2;
}

} // namespace lissom::solve
