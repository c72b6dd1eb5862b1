#include "sweeps.h"

#include <algorithm>
#include <vector>

namespace lissom::solve {

namespace {

/// Σ over the first n columns of a strip, times the rows of x (n×K): four sums per right-hand side.
template <int K>
[[gnu::always_inline]] inline void multiply_strip(Quad (&sum)[K], const double* strip, const double* x, int n) {
    for (const double* const end = strip + 4 * n; strip < end; strip += 4, x += K) {
        const Quad l = load(strip);
        for (int r = 0; r < K; ++r)
            add_product(sum[r], l, x[r]);
    }
}

/// sums += stripᵀ y for the first n columns of a strip; two partial sums per number, to be added at the end.
template <int K>
[[gnu::always_inline]] inline void multiply_transposed(double* sums, const double* strip, const Quad (&y)[K],
                                                       int n) {
    for (const double* const end = strip + 4 * n; strip < end; strip += 4, sums += 2 * K) {
        const Quad l = load(strip);
        for (int r = 0; r < K; ++r)
            *reinterpret_cast<Pair*>(sums + 2 * r) += l.low * y[r].low + l.high * y[r].high;
    }
}

template <int K>
[[gnu::always_inline]] inline void spill(double (&numbers)[K][4], const Quad (&quads)[K]) {
    for (int r = 0; r < K; ++r)
        store(numbers[r], quads[r]);
}

template <int K>
void forward(const PanelShape shape, const double* panel, const int* rows, double* own, double* X) {
    double sums[K][4];
    for (int q = 0; q < strip_count(shape.width); ++q) {
        const double* const strip = panel + triangle_strip(q);
        Quad sum[K] = {};
        multiply_strip<K>(sum, strip, own, 4 * q);
        spill<K>(sums, sum);
        const int w = std::min(4, shape.width - 4 * q);
        const double* const tile = strip + 16 * q;
        double* const x = own + 4 * q * K;
        for (int i = 0; i < w; ++i)
            for (int r = 0; r < K; ++r) {
                double value = x[K * i + r] - sums[r][i];
                for (int j = 0; j < i; ++j)
                    value -= tile[4 * j + i] * x[K * j + r];
                x[K * i + r] = value * tile[4 * i + i];
            }
    }
    const double* strip = panel + shape.below(0);
    for (int q = 0; q < strip_count(shape.height); ++q, strip += 4 * shape.width) {
        Quad sum[K] = {};
        multiply_strip<K>(sum, strip, own, shape.width);
        spill<K>(sums, sum);
        const int w = std::min(4, shape.height - 4 * q);
        for (int i = 0; i < w; ++i)
            for (int r = 0; r < K; ++r)
                X[std::size_t(K) * rows[4 * q + i] + r] -= sums[r][i];
    }
}

template <int K>
void backward(const PanelShape shape, const double* panel, const int* rows, double* own, const double* X,
              double* sums) {
    std::fill_n(sums, 2 * K * shape.width, 0.0);
    double values[K][4];
    Quad y[K];
    const double* strip = panel + shape.below(0);
    for (int q = 0; q < strip_count(shape.height); ++q, strip += 4 * shape.width) {
        const int w = std::min(4, shape.height - 4 * q);
        for (int i = 0; i < 4; ++i)
            for (int r = 0; r < K; ++r)
                values[r][i] = i < w ? X[std::size_t(K) * rows[4 * q + i] + r] : 0;
        for (int r = 0; r < K; ++r)
            y[r] = load(values[r]);
        multiply_transposed<K>(sums, strip, y, shape.width);
    }
    for (int q = strip_count(shape.width) - 1; q >= 0; --q) {
        strip = panel + triangle_strip(q);
        const int w = std::min(4, shape.width - 4 * q);
        const double* const tile = strip + 16 * q;
        double* const x = own + 4 * q * K;
        for (int r = 0; r < K; ++r)
            values[r][1] = values[r][2] = values[r][3] = 0;
        for (int i = w - 1; i >= 0; --i)
            for (int r = 0; r < K; ++r) {
                const double* const sum = sums + 2 * (K * (4 * q + i) + r);
                double value = x[K * i + r] - (sum[0] + sum[1]);
                for (int j = i + 1; j < w; ++j)
                    value -= tile[4 * i + j] * values[r][j];
                values[r][i] = x[K * i + r] = value * tile[4 * i + i];
            }
        for (int r = 0; r < K; ++r)
            y[r] = load(values[r]);
        multiply_transposed<K>(sums, strip, y, 4 * q);
    }
}

template <int K>
void sweep(const Factor& factor, double* X) {
    const Supernodes& nodes = factor.supernodes;
    int widest = 0;
    for (int s = 0; s < nodes.count(); ++s) {
        widest = std::max(widest, nodes.width(s));
        forward<K>(factor.shape(s), factor.numbers.get() + factor.panel_offsets[s], nodes.rows_of(s),
                   X + std::size_t(K) * nodes.first[s], X);
    }
    std::vector<double> sums(std::size_t(2) * K * widest);
    for (int s = nodes.count() - 1; s >= 0; --s)
        backward<K>(factor.shape(s), factor.numbers.get() + factor.panel_offsets[s], nodes.rows_of(s),
                    X + std::size_t(K) * nodes.first[s], X, sums.data());
}

} // namespace

void solve_sweeps(const Factor& factor, double* X, int k) {
    switch (k) {
    case 1: return sweep<1>(factor, X);
    case 2: return sweep<2>(factor, X);
    case 3: return sweep<3>(factor, X);
    default: return sweep<4>(factor, X);
    }
}

} // namespace lissom::solve
