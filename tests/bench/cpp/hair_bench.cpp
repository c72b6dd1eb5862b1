// Times the two field solvers of the hair wing, one line of JSON per grid: the dual with its incremental dense
// factor beside the thesis's sparse system, made anew and kept up by update and downdate.
//
//   hair_bench [--grids 29,37,64] [--constraints 2000] [--changed 100] [--no-sparse-above 40]

#include "options.h"

#include "lissom/hair/dual_field.h"
#include "lissom/hair/sparse_field.h"
#include "lissom/mesh/stopwatch.h"

#include <cstdio>
#include <random>
#include <vector>

namespace {

using lissom::DualField;
using lissom::FieldConstraint;
using lissom::SparseField;

template <typename Work>
double seconds(Work&& work) {
    lissom::Stopwatch watch;
    work();
    return watch.lap();
}

/// Runs of neighbouring nodes, as strokes leave them, in a cube of n nodes a side.
std::vector<FieldConstraint> strokes(int n, int count) {
    std::mt19937 random(17);
    std::vector<char> taken(static_cast<std::size_t>(n) * n * n, 0);
    std::vector<FieldConstraint> out;
    while (static_cast<int>(out.size()) < count) {
        Eigen::Vector3d p, way;
        for (int d = 0; d < 3; ++d) {
            p[d] = static_cast<double>(random() % 1000) / 1000 * (n - 1);
            way[d] = static_cast<double>(random() % 2001) / 1000 - 1;
        }
        way.normalize();
        for (int step = 0; step < 25 && static_cast<int>(out.size()) < count; ++step, p += way) {
            if ((p.array() < 0).any() || (p.array() > n - 1).any()) break;
            const Eigen::Vector3i at = p.array().round().cast<int>();
            const int node = at[0] + n * (at[1] + n * at[2]);
            if (taken[static_cast<std::size_t>(node)]) continue;
            taken[static_cast<std::size_t>(node)] = 1;
            out.push_back({node, way});
        }
    }
    return out;
}

double gap(const lissom::Points& a, const lissom::Points& b) { return (a - b).norm() / b.norm(); }

void measure(int n, int constraints, int changed, bool sparse_too) {
    const auto all = strokes(n, constraints + changed);
    const std::span<const FieldConstraint> before(all.data(), static_cast<std::size_t>(constraints));
    const std::span<const FieldConstraint> after(all.data() + changed, static_cast<std::size_t>(constraints));

    std::shared_ptr<const lissom::GridBilaplacian> K;
    const double prepare = seconds([&] { K = std::make_shared<lissom::GridBilaplacian>(Eigen::Vector3i(n, n, n)); });
    DualField dual(K);
    const double first = seconds([&] { dual.set_constraints(before); });
    const double edit = seconds([&] { dual.set_constraints(after); });
    lissom::Points field;
    const double transform = seconds([&] { field = dual.field(); });
    std::printf("{\"grid\":%d,\"unknowns\":%d,\"constraints\":%d,\"changed\":%d,\"dual prepare\":%.4f,\"dual first\":%.4f,"
                "\"dual edit\":%.4f,\"dual field\":%.4f",
                n, n * n * n, constraints, changed, prepare, first, edit, transform);
    if (sparse_too) {
        SparseField sparse(Eigen::Vector3i(n, n, n));
        sparse.set_constraints(before);
        const double update = seconds([&] { sparse.set_constraints(after); });
        const double apart = gap(sparse.field(), field);
        const double fresh = seconds([&] { sparse.refactor(); });
        std::printf(",\"sparse fresh\":%.3f,\"sparse update\":%.3f,\"fresh / edit\":%.1f,\"update / edit\":%.1f,\"apart\":%.1e",
                    fresh, update, fresh / edit, update / edit, apart);
    }
    std::printf("}\n");
    std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv) {
    const bench::Options options(argc, argv);
    const int constraints = options.number("--constraints", 2000), changed = options.number("--changed", 100);
    const int sparse_up_to = options.number("--no-sparse-above", 40);
    for (const int n : options.numbers("--grids", "29,37,64")) measure(n, constraints, changed, n <= sparse_up_to);
}
