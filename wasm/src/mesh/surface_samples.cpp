#include "lissom/mesh/surface_samples.h"

#include "lissom/mesh/chance.h"
#include "lissom/mesh/operators.h"

#include <algorithm>
#include <cmath>

namespace lissom {

namespace {

/// Steps of a two-dimensional sequence of low discrepancy: 1/x and 1/x² for the real root of x³ = x + 1.
constexpr double k_first = 0.7548776662466927, k_second = 0.5698402909980532;

double fraction(double x) { return x - std::floor(x); }

} // namespace

SurfacePlaces sample_surface(const TriangleMesh& mesh, int count, std::uint64_t seed) {
    SurfacePlaces samples;
    const Eigen::VectorXd areas = triangle_areas(mesh);
    const double whole = areas.sum();
    if (!(whole > 0) || count <= 0) return samples;
    samples.triangle.reserve(static_cast<std::size_t>(count));
    samples.weights.resize(count, 3);
    const double along = unit(hash_bits(seed, 0, 1)), first = unit(hash_bits(seed, 0, 2)), second = unit(hash_bits(seed, 0, 3));
    int t = 0;
    double before = 0; // area of the triangles before t
    for (int i = 0; i < count; ++i) {
        const double at = (i + along) / count * whole;
        while (t + 1 < mesh.triangle_count() && before + areas[t] <= at) before += areas[t++];
        double u = fraction(first + i * k_first), v = fraction(second + i * k_second);
        if (u + v > 1) { // the other half of the parallelogram
            u = 1 - u;
            v = 1 - v;
        }
        samples.triangle.push_back(t);
        samples.weights.row(i) << 1 - u - v, u, v;
    }
    return samples;
}

} // namespace lissom
